#include "renderer/transparents.h"

namespace plume {
namespace {
constexpr uint32_t kForwardOrder = 0xffffffff;

struct CardPush {
  uint32_t order_last;  // kForwardOrder, or the index of the last: draw backwards
  glm::vec2 covered;
};
}  // namespace

void Transparents::draw(gpu::Pass& pass, const Style& style) const {
  gpu::Bindings bindings = style.bindings;
  bindings.insert(bindings.end(), {{"View", view},
                                   {"Cards", cards},
                                   {"Order", style.order ? style.order : order},
                                   {"puffs", puffs},
                                   {"opaque_depth", style.opaque_depth}});
  pass.draw({.vertex = "surface/card.vert",
             .fragment = style.fragment,
             .targets = style.targets,
             .depth = style.depth_test,
             .depth_use = style.depth_test ? gpu::DepthUse::kTest : gpu::DepthUse::kNone,
             .area = style.area,
             .constants = style.constants,
             .bindings = std::move(bindings),
             .vertices = 6,
             .instances = count},
            CardPush{.order_last = style.backwards && count > 0 ? count - 1 : kForwardOrder,
                     .covered = style.covered});
}

}  // namespace plume
