#include "renderer/transparents.h"

#include <numeric>

#include "renderer/radix_sort.h"

namespace plume {
namespace {
struct CardPush {
  uint32_t backwards;
  glm::vec2 covered;
};
}  // namespace

Source source_of(glm::vec3 transmission) {
  return transmission.r == transmission.g && transmission.g == transmission.b ? Source::kScalar
                                                                              : Source::kRgb;
}

uint32_t Transparents::first(Source source) const {
  return std::accumulate(counts.begin(), counts.begin() + size_t(source), 0u);
}

void Transparents::draw(gpu::Pass& pass, const Style& style) const {
  gpu::Bindings bindings = style.bindings;
  bindings.insert(bindings.end(), {{"View", view},
                                   {"Cards", cards},
                                   {"Order", style.order ? style.order : order},
                                   {"Work", work},
                                   {"puffs", puffs},
                                   {"opaque_depth", style.opaque_depth}});
  pass.draw({.vertex = style.vertex,
             .fragment = style.fragment,
             .targets = style.targets,
             .depth = style.depth_test,
             .depth_use = style.depth_test ? style.depth_use : gpu::DepthUse::kNone,
             .area = style.area,
             .pixel = style.pixel,
             .constants = style.constants,
             .bindings = std::move(bindings),
             .strip = true,
             .indirect = style.indirect ? style.indirect : draws,
             .indirect_index = style.indirect ? style.indirect_index
                               : style.source ? 1 + uint32_t(*style.source)
                                              : 0,
             .count_fragments = style.count_fragments},
            CardPush{.backwards = style.backwards ? 1u : 0u, .covered = style.covered});
}

gpu::Bindings Transparents::seen() const {
  return {{"View", view}, {"Cards", cards}, {"Order", order}, {"Work", work}};
}

gpu::IndirectGroups Transparents::each_seen() const {
  return each_item(*work);
}

}  // namespace plume
