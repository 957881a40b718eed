#include "sandbox/workspace/emitter_depths.h"

#include <algorithm>
#include <cmath>

#include "renderer/parameters.h"
#include "sandbox/workspace/living_particles.h"

namespace plume {

float EmitterDepths::drawn_m(float depth_m, float near_m) const {
  return std::max(depth_m - offset_m, 2.0f * near_m);
}

std::vector<EmitterDepths> emitter_depths(const Stage& stage, size_t instance, const CameraKey& camera) {
  const std::optional<uint32_t> call = stage.call_of(instance);
  if (!call) return {};
  const Instances& instances = stage.simulation().instances();
  const CallState& called = instances.calls[*call];
  std::vector<EmitterDepths> result;
  for (const Emitter& emitter : called.described())
    result.push_back({.name = emitter.name,
                      .offset_m = camera_offset_m(called.call, emitter),
                      .depths_m = {},
                      .has_states = !emitter.motion.analytic});
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const auto positions = living_positions(stage, instance);
  for (size_t e = 0; e < positions.size(); ++e)
    for (const glm::vec3& position : positions[e]) {
      const float depth = glm::dot(position - camera.position, forward);
      if (depth > 0) result[e].depths_m.push_back(depth);
    }
  for (EmitterDepths& emitter : result) std::ranges::sort(emitter.depths_m);
  return result;
}

float DepthCurve::slice(float depth_m) const {
  return std::clamp(float(count) * std::log2(1 + std::max(depth_m, 0.0f) / a) / std::log2(1 + b / a), 0.0f,
                    float(count));
}

float DepthCurve::depth_m(float slice) const {
  return a * (std::exp2(slice / float(count) * std::log2(1 + b / a)) - 1);
}

std::optional<size_t> SlicedDepth::physical_at(float depth_m) const {
  const auto found = std::ranges::upper_bound(physical, depth_m, {}, &DepthSlice::far_m);
  if (found == physical.end() || depth_m < found->near_m) return {};
  return size_t(found - physical.begin());
}

SlicedDepth sliced_depth(gpu::Device& device, const MethodInstance& drawn) {
  SlicedDepth result{.curve = {}, .physical = drawn.method->depth_slices(device, drawn.resources)};
  const nlohmann::json values = parameter_values(*drawn.method);
  const nlohmann::json found = drawn.method->statistics(device, drawn.resources);
  if (values.contains("curve_a") && values.contains("curve_b") && found.contains("virtual_slices"))
    result.curve = {.a = values["curve_a"], .b = values["curve_b"], .count = found["virtual_slices"]};
  return result;
}

}  // namespace plume
