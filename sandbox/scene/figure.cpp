#include "sandbox/scene/figure.h"

#include <cmath>

namespace plume {
namespace {

/// A limb in the frame of the body, in body heights; x is to the person's left, z to the front.
struct Limb {
  glm::vec3 from, to;
  float radius;
  bool mirrored;  ///< the person has it on both sides
};

// Seven and a half heads tall; hips at half the height, wrists just below them, shoulders two heads wide.
// Arms hang away from the body, legs stand apart: the gaps are what makes a silhouette read as a person.
constexpr Limb kLimbs[] = {
    {{0.062f, 0.020f, -0.015f}, {0.072f, 0.018f, 0.075f}, 0.018f, true},   // foot
    {{0.062f, 0.050f, 0.000f}, {0.058f, 0.275f, 0.006f}, 0.033f, true},    // shin
    {{0.058f, 0.285f, 0.006f}, {0.046f, 0.495f, 0.000f}, 0.043f, true},    // thigh
    {{-0.034f, 0.520f, 0.000f}, {0.034f, 0.520f, 0.000f}, 0.057f, false},  // hips
    {{-0.012f, 0.560f, 0.000f}, {-0.020f, 0.720f, 0.000f}, 0.066f, true},  // waist
    {{-0.056f, 0.755f, 0.000f}, {0.056f, 0.755f, 0.000f}, 0.066f, false},  // chest
    {{0.020f, 0.825f, 0.000f}, {0.104f, 0.798f, 0.000f}, 0.031f, true},    // shoulder
    {{0.110f, 0.790f, 0.000f}, {0.143f, 0.625f, -0.012f}, 0.029f, true},   // upper arm
    {{0.143f, 0.625f, -0.012f}, {0.153f, 0.450f, 0.020f}, 0.025f, true},   // forearm and hand
    {{0.000f, 0.800f, 0.000f}, {0.000f, 0.890f, 0.008f}, 0.034f, false},   // neck
};
constexpr glm::vec3 kHead{0.0f, 0.933f, 0.012f};
constexpr float kHeadRadius = 0.067f;

}  // namespace

std::vector<Solid> standing_figure(const glm::vec3& feet, float yaw_deg, float height_m,
                                   const glm::vec3& color, Material material) {
  const float yaw = glm::radians(yaw_deg), c = std::cos(yaw), s = std::sin(yaw);
  const auto place = [&](const glm::vec3& p) {
    return feet + height_m * glm::vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
  };
  std::vector<Solid> solids;
  const auto add = [&](SolidKind kind, const glm::vec3& from, const glm::vec3& to, float radius) {
    Solid solid;
    solid.kind = kind;
    solid.material = material;
    solid.color = color;
    solid.position = place(from);
    if (kind == SolidKind::kCapsule) solid.end = place(to);
    solid.radius_m = radius * height_m;
    solids.push_back(solid);
  };
  const glm::vec3 mirror(-1.0f, 1.0f, 1.0f);
  for (const Limb& limb : kLimbs) {
    add(SolidKind::kCapsule, limb.from, limb.to, limb.radius);
    if (limb.mirrored) add(SolidKind::kCapsule, limb.from * mirror, limb.to * mirror, limb.radius);
  }
  add(SolidKind::kSphere, kHead, kHead, kHeadRadius);
  return solids;
}

}  // namespace plume
