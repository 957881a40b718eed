#include "sandbox/effects/motion_tables.h"

#include <cmath>

namespace plume {
namespace {

constexpr float kDeep = 1e6f;  // m: the ground under a plane
constexpr float kMargin =
    0.05f;  // m: above the skin that keeps particles from surfaces, 10 km from the origin

shared::AttractorData attractor_data(const Attractor& a) {
  return {.from = a.from_m,
          .scale = 2.0f * std::sqrt(2.0f) * a.strength / a.radius_m,
          .along = a.to_m - a.from_m,
          .inv_radius = 1.0f / a.radius_m};
}

shared::KillVolumeData kill_data(const KillVolume& k) {
  using enum KillVolume::Kind;
  return {.position = k.position_m,
          .kind = uint32_t(k.kind),
          .extent = k.kind == kBox      ? k.size_m * 0.5f
                    : k.kind == kSphere ? glm::vec3(k.radius_m)
                                        : glm::normalize(k.normal),
          .outside = k.outside};
}

shared::BoxCollider box_collider(const Solid& solid) {
  const bool plane = solid.kind == SolidKind::kPlane;
  const float yaw = plane ? 0.0f : glm::radians(solid.yaw_deg);
  const glm::vec3 half = solid.size_m * 0.5f;
  return {.position = solid.position,
          .depth = plane ? kDeep : 0.0f,
          .half_size = plane ? glm::vec3(half.x, 0.0f, half.z) : half,
          .yaw_sin = std::sin(yaw),
          .yaw_cos = std::cos(yaw)};
}

shared::RoundCollider round_collider(const Solid& solid) {
  const glm::vec3 core = solid.kind == SolidKind::kCapsule ? solid.end - solid.position : glm::vec3(0.0f);
  const float length = glm::length(core);
  return {.position = solid.position,
          .radius = solid.radius_m,
          .axis = length > 0.0f ? core / length : glm::vec3(0.0f),
          .length_m = length};
}

Bounds extent_of(const Solid& solid) {
  if (solid.kind == SolidKind::kSphere || solid.kind == SolidKind::kCapsule) {
    const glm::vec3 end = solid.kind == SolidKind::kCapsule ? solid.end : solid.position;
    return {glm::min(solid.position, end) - solid.radius_m, glm::max(solid.position, end) + solid.radius_m};
  }
  const shared::BoxCollider box = box_collider(solid);
  const float s = std::abs(box.yaw_sin), c = std::abs(box.yaw_cos);
  const glm::vec3 half(box.half_size.x * c + box.half_size.z * s, box.half_size.y,
                       box.half_size.x * s + box.half_size.z * c);
  return {box.position - half - glm::vec3(0, box.depth, 0), box.position + half};
}

/// A descriptor needs something to point at.
template <class T>
gpu::Buffer buffer_of(gpu::Device& device, const char* label, std::vector<T> rows) {
  if (rows.empty()) rows.emplace_back();
  return gpu::make_buffer(device, "simulation", label, rows);
}

}  // namespace

uint32_t features_of(const Emitter& emitter) {
  const Motion& m = emitter.motion;
  uint32_t features = 0;
  if (m.curl.strength != 0.0f) features |= shared::kUsesCurl;
  if (m.vortex.strength != 0.0f || m.vortex.pull != 0.0f) features |= shared::kUsesVortex;
  if (!m.attractors.empty()) features |= shared::kUsesAttractors;
  if (m.field) features |= shared::kUsesField;
  if (m.orbit != 0.0f) features |= shared::kUsesOrbit;
  if (m.collision) features |= shared::kUsesCollision;
  if (!m.kill.empty()) features |= shared::kUsesKill;
  if (m.curl_displacement.amplitude_m != 0.0f) features |= shared::kUsesDisplacement;
  if (m.analytic) features |= shared::kIsAnalytic;
  return features;
}

MotionTables::MotionTables(const std::vector<Solid>& solids) {
  for (const Solid& solid : solids)
    if (solid.kind == SolidKind::kPlane || solid.kind == SolidKind::kBox) {
      boxes_.all.push_back(box_collider(solid));
      boxes_.extents.push_back(extent_of(solid));
    } else {
      rounds_.all.push_back(round_collider(solid));
      rounds_.extents.push_back(extent_of(solid));
    }
}

template <class Collider>
MotionTables::Range MotionTables::Colliders<Collider>::list_within(const Bounds* reach, float margin) {
  std::vector<uint32_t> near;
  for (uint32_t i = 0; i < all.size(); ++i)
    if (!reach || (glm::all(glm::lessThanEqual(extents[i].min - margin, reach->max)) &&
                   glm::all(glm::lessThanEqual(reach->min, extents[i].max + margin))))
      near.push_back(i);
  const auto [entry, added] = known.try_emplace(near, Range{uint32_t(lists.size()), uint32_t(near.size())});
  if (added)
    for (const uint32_t i : near) lists.push_back(all[i]);
  return entry->second;
}

MotionTables::Ranges MotionTables::enter(const Emitter& emitter) {
  const Motion& motion = emitter.motion;
  const Ranges ranges{.attractors = {uint32_t(attractors_.size()), uint32_t(motion.attractors.size())},
                      .kill = {uint32_t(kill_volumes_.size()), uint32_t(motion.kill.size())},
                      .field_first = uint32_t(field_cells_.size())};
  for (const Attractor& a : motion.attractors) attractors_.push_back(attractor_data(a));
  for (const KillVolume& k : motion.kill) kill_volumes_.push_back(kill_data(k));
  if (motion.field)
    field_cells_.insert(field_cells_.end(), motion.field->grid->cells.begin(),
                        motion.field->grid->cells.end());
  return ranges;
}

void MotionTables::fill(const Emitter& emitter, shared::EmitterData& data, const Bounds* reach) {
  auto entry = entered_.find(&emitter);
  if (entry == entered_.end()) entry = entered_.emplace(&emitter, enter(emitter)).first;
  const Ranges& ranges = entry->second;
  data.attractor_first = ranges.attractors.first;
  data.attractor_count = ranges.attractors.count;
  data.kill_first = ranges.kill.first;
  data.kill_count = ranges.kill.count;
  if (const auto& field = emitter.motion.field) {
    const glm::vec3 extent = (field->grid->high - field->grid->low) * field->scale;
    data.field_first = ranges.field_first;
    data.field_size = field->grid->size;
    data.field_low = field->grid->low * field->scale + field->offset_m;
    data.field_inv_cell = glm::vec3(field->grid->size) / extent;
  }
  if (const auto& collision = emitter.motion.collision) {
    const float margin = collision->radius_m + kMargin;
    const Range boxes = boxes_.list_within(reach, margin), rounds = rounds_.list_within(reach, margin);
    data.box_first = boxes.first;
    data.box_count = boxes.count;
    data.round_first = rounds.first;
    data.round_count = rounds.count;
  }
}

void MotionTables::upload(gpu::Device& device) {
  attractor_buffer_ = buffer_of(device, "attractors", attractors_);
  kill_buffer_ = buffer_of(device, "kill volumes", kill_volumes_);
  field_buffer_ = buffer_of(device, "field cells", field_cells_);
  box_buffer_ = buffer_of(device, "box colliders", boxes_.lists);
  round_buffer_ = buffer_of(device, "round colliders", rounds_.lists);
}

gpu::Bindings MotionTables::bindings() const {
  return {{"Attractors", &attractor_buffer_},
          {"FieldCells", &field_buffer_},
          {"BoxColliders", &box_buffer_},
          {"RoundColliders", &round_buffer_},
          {"KillVolumes", &kill_buffer_}};
}

}  // namespace plume
