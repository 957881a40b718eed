#include "sandbox/scene/pane_card.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "shaders/effects/puff.h"

namespace plume {
namespace {

glm::uvec2 pack_half4(glm::vec3 rgb, float a = 0.0f) {
  return {glm::packHalf2x16({rgb.r, rgb.g}), glm::packHalf2x16({rgb.b, a})};
}

}  // namespace

shared::Card pane_card(const Pane& pane) {
  const float yaw = glm::radians(pane.yaw_deg), pitch = glm::radians(pane.pitch_deg);
  const glm::vec3 along(std::cos(yaw), 0.0f, -std::sin(yaw));
  const glm::vec3 upright(std::sin(yaw) * std::sin(pitch), std::cos(pitch), std::cos(yaw) * std::sin(pitch));
  // Coverage 1 is an optical depth that leaves nothing in 32 bits.
  const float depth = pane.coverage < 1.0f ? -std::log1p(-pane.coverage) : shared::kOpaqueDepth;
  return {.center = pane.position,
          .optical_depth = std::min(depth, shared::kOpaqueDepth),
          .axis_u = along * (pane.size_m.x * 0.5f),
          .inv_feather = 0.0f,
          .axis_v = upright * (pane.size_m.y * 0.5f),
          .layers = shared::kSolidLayer | shared::kSolidLayer << shared::kLayerBits,
          .sunlit = {0, 0},
          .ambient = pack_half4(pane.color),
          .emission = pack_half4(pane.emission),
          .transmission = pack_half4(pane.transmission, glm::radians(pane.diffusion_deg)),
          .light = {0, 0},
          .motion = {0, 0}};
}

}  // namespace plume
