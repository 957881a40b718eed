#include "shaders/methods/avboit/exact_layers.h"

#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_exact_layers_needs(Needs& needs, const Plan& plan) {
  const uint64_t layers = uint64_t(plan.size.x) * plan.size.y * plan.volume.exact_layers;
  needs.buffers.push_back(
      {.name = "layers", .bytes = std::max<uint64_t>(layers * 8, 8), .clear = shared::kNoLayer});
  needs.buffers.push_back({.name = "layer_tail",
                           .bytes = 4 + (layers > 0 ? uint64_t(plan.size.x) * plan.size.y * 4 : 0),
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
               .bindings = {{"Layers", buffer("layers")}, {"LayerTail", buffer("layer_tail")}},
               .order = buffer("source_order"),
               .indirect = buffer("source_draws"),
               .indirect_index = shared::kIntoLayers});
  });
}

}  // namespace plume::avboit
