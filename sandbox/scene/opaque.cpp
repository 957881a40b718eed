#include "sandbox/scene/opaque.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "shaders/shared/solid.h"

namespace plume {
namespace {

shared::SolidData solid_data(const Solid& solid) {
  const float yaw = glm::radians(solid.yaw_deg);
  const bool round = solid.kind == SolidKind::kSphere || solid.kind == SolidKind::kCapsule;
  return {.position = solid.position,
          .kind = uint32_t(solid.kind),
          .end = solid.kind == SolidKind::kCapsule ? solid.end : solid.position,
          .material = uint32_t(solid.material),
          .half_size = solid.size_m * 0.5f,
          .radius = round ? solid.radius_m : 0.0f,
          .color = solid.color,
          .yaw_sin = std::sin(yaw),
          .yaw_cos = std::cos(yaw)};
}

}  // namespace

OpaqueScene::OpaqueScene(gpu::Device& device, const std::vector<Solid>& solids)
    : count_(uint32_t(solids.size())) {
  std::vector<shared::SolidData> data;
  for (const Solid& solid : solids) data.push_back(solid_data(solid));
  if (data.empty()) data.push_back({});  // a descriptor needs something to point at
  solids_ = gpu::make_buffer(device, "scene", "solids", data);
}

void OpaqueScene::record_depth(gpu::Frame& frame, const Targets& targets, const gpu::Buffer& view) const {
  frame.pass("depth", [&](gpu::Pass& pass) {
    pass.draw({.vertex = "opaque/solid.vert",
               .fragment = "",
               .targets = {},
               .depth = &targets.opaque_depth,
               .depth_use = gpu::DepthUse::kTestAndWrite,
               .clear_depth = true,
               .area = {targets.size.x, targets.size.y},
               .constants = {},
               .bindings = {{"View", &view}, {"Solids", &solids_}},
               .vertices = shared::kSolidVertices,
               .instances = count_},
              0u);
  });
}

void OpaqueScene::record_color(gpu::Frame& frame, const Targets& targets, const gpu::Image& depth,
                               const gpu::Buffer& view, const Lighting* lighting) const {
  const bool lit = lighting && lighting->bodies();
  gpu::Bindings bindings{{"View", &view}, {"Solids", &solids_}};
  if (lit) std::ranges::move(lighting->bindings(), std::back_inserter(bindings));
  frame.pass("opaque", [&](gpu::Pass& pass) {
    constexpr std::array<float, 4> kBlack{0, 0, 0, 1};
    const gpu::Area area{targets.size.x, targets.size.y};
    pass.draw({.vertex = "post/fullscreen.vert",
               .fragment = "opaque/sky.frag",
               .targets = {{.image = &targets.opaque_color, .blend = gpu::Blend::kReplace, .clear = kBlack}},
               .depth = &depth,
               .depth_use = gpu::DepthUse::kTest,
               .area = area,
               .constants = {},
               .bindings = {{"View", &view}}},
              0u);
    pass.draw({.vertex = "opaque/solid.vert",
               .fragment = lit ? "opaque/solid_lit.frag" : "opaque/solid.frag",
               .targets = {{.image = &targets.opaque_color, .blend = gpu::Blend::kReplace, .clear = {}}},
               .depth = &depth,  // equal where visible
               .depth_use = gpu::DepthUse::kTest,
               .area = area,
               .constants = lit ? gpu::Constants{lighting->shadows() ? 1u : 0u} : gpu::Constants{},
               .bindings = std::move(bindings),
               .vertices = shared::kSolidVertices,
               .instances = count_,
               .count_fragments = true},
              0u);
  });
}

}  // namespace plume
