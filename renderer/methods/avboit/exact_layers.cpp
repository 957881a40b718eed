#include "shaders/methods/avboit/exact_layers.h"

#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_exact_layers_needs(Needs& needs, const Plan& plan) {
  const uint64_t pixels = plan.volume.exact_layers > 0 ? uint64_t(plan.size.x) * plan.size.y : 0;
  needs.buffers.push_back({.name = "layers",
                           .bytes = std::max<uint64_t>(pixels * plan.volume.exact_layers * 8, 8),
                           .clear = shared::kNoLayer});
  needs.buffers.push_back({.name = "layer_tails",
                           .bytes = 4 + std::max<uint64_t>(pixels, 1) * sizeof(shared::LayerTail),
                           .clear = 0});
  needs.buffers.push_back({.name = "layers_start", .bytes = plan.tiles() * 4, .clear = shared::kNoSlice});
}

void record_exact_layers(const Picture& picture, const Plan& plan) {
  if (plan.volume.exact_layers == 0) return;
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  picture.frame.pass("exact_layers", [&](gpu::Pass& pass) {
    picture.transparents.draw(
        pass, {.fragment = "methods/avboit/exact_layers.frag",
               .targets = {},
               .depth_test = &picture.opaque_depth,
               .opaque_depth = &picture.opaque_depth,
               .area = picture.area(),
               .constants = {plan.volume.exact_layers},
               .bindings = {{"Layers", buffer("layers")}, {"LayerTails", buffer("layer_tails")}},
               .order = buffer("source_order"),
               .indirect = buffer("source_draws"),
               .indirect_index = shared::kIntoLayers});
  });
}

}  // namespace plume::avboit
