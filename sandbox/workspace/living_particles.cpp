#include "sandbox/workspace/living_particles.h"

#include <algorithm>

#include "sandbox/effects/bounds.h"
#include "shaders/shared/bad_number.h"

namespace plume {

std::vector<std::vector<glm::vec3>> living_positions(const Stage& stage, size_t instance) {
  const std::optional<uint32_t> call = stage.call_of(instance);
  if (!call) return {};
  const Instances& instances = stage.simulation().instances();
  std::vector<std::vector<glm::vec3>> result(instances.calls[*call].described().size());
  const std::vector<shared::Particle> particles = stage.simulation().particles();
  size_t next = 0;
  for (const EmitterState& emitter : instances.emitters) {
    if (!emitter.wanted || emitter.is_analytic()) continue;
    const size_t end = next + emitter.living();
    for (; next < end; ++next) {
      const shared::Particle& particle = particles[next];
      if (emitter.call != *call || (particle.state & shared::kDeadAge) == shared::kDeadAge) continue;
      if (shared::is_bad(particle.position)) continue;  // nor is it drawn
      result[emitter.index].push_back(particle.position);
    }
  }
  return result;
}

Ball ball_round(const Stage& stage, size_t instance) {
  const Instance& described = stage.scene().instances.at(instance);
  std::vector<glm::vec3> points;
  float largest_m = 0;
  const auto positions = living_positions(stage, instance);
  for (size_t e = 0; e < positions.size(); ++e) {
    const CallState& called = stage.simulation().instances().calls[*stage.call_of(instance)];
    const Emitter& emitter = called.described()[e];
    if (!positions[e].empty())
      largest_m = std::max(largest_m, float(emitter.look.radius_m.extremes().largest.value));
    points.insert(points.end(), positions[e].begin(), positions[e].end());
    const EmitterState& state =
        stage.simulation().instances().emitter_of(*stage.call_of(instance), uint32_t(e));
    if (!emitter.motion.analytic || !state.wanted || state.living() == 0) continue;
    const Bounds bounds =
        emitter_bounds(*called.call.effect, {.position = described.position,
                                             .yaw_deg = described.yaw_deg,
                                             .path = described.path ? &*described.path : nullptr,
                                             .wind = stage.scene().wind})[e];
    if (!bounds.empty()) points.insert(points.end(), {bounds.min, bounds.max});
  }
  if (points.empty()) return {.centre = described.position, .radius_m = 1.0f};
  glm::vec3 low(0.0f), high(0.0f);
  std::vector<float> along(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::transform(points, along.begin(), [&](const glm::vec3& p) { return p[axis]; });
    std::ranges::sort(along);
    const size_t left_out = along.size() / 20;
    low[axis] = along[left_out];
    high[axis] = along[along.size() - 1 - left_out];
  }
  return {.centre = 0.5f * (low + high), .radius_m = 0.5f * glm::length(high - low) + largest_m};
}

}  // namespace plume
