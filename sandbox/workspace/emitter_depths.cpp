#include "sandbox/workspace/emitter_depths.h"

#include <algorithm>
#include <charconv>
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

float DepthSlices::slice(float depth_m) const {
  return std::clamp(float(count) * std::log2(1 + std::max(depth_m, 0.0f) / a) / std::log2(1 + b / a), 0.0f,
                    float(count));
}

float DepthSlices::depth_m(float slice) const {
  return a * (std::exp2(slice / float(count) * std::log2(1 + b / a)) - 1);
}

std::optional<DepthSlices> depth_slices(Method& method) {
  const nlohmann::json values = parameter_values(method);
  if (!values.contains("curve_a") || !values.contains("curve_b") || !values.contains("virtual_slices"))
    return {};
  const std::string slices = values["virtual_slices"].is_string()
                                 ? values["virtual_slices"].get<std::string>()
                                 : values["virtual_slices"].dump();
  DepthSlices found{.a = values["curve_a"], .b = values["curve_b"], .count = 0};
  std::from_chars(slices.data(), slices.data() + slices.size(), found.count);
  if (found.count == 0) return {};
  return found;
}

}  // namespace plume
