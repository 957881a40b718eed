#include "renderer/transparents.h"

#include <numeric>

namespace plume {
namespace {
struct CardPush {
  uint32_t order_first;
  int32_t order_step;
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
                                   {"puffs", puffs},
                                   {"opaque_depth", style.opaque_depth}});
  const uint32_t begin = style.source ? first(*style.source) : 0;
  const uint32_t number_drawn = style.source ? number(*style.source) : count;
  pass.draw({.vertex = style.vertex,
             .fragment = style.fragment,
             .targets = style.targets,
             .depth = style.depth_test,
             .depth_use = style.depth_test ? style.depth_use : gpu::DepthUse::kNone,
             .area = style.area,
             .pixel = style.pixel,
             .constants = style.constants,
             .bindings = std::move(bindings),
             .vertices = 4,
             .instances = number_drawn,
             .strip = true,
             .indirect = style.indirect,
             .indirect_index = style.indirect_index,
             .count_fragments = style.count_fragments},
            CardPush{.order_first = style.backwards && number_drawn > 0 ? begin + number_drawn - 1 : begin,
                     .order_step = style.backwards ? -1 : 1,
                     .covered = style.covered});
}

}  // namespace plume
