#include "sandbox/effects/emitter_data.h"

#include <algorithm>
#include <cmath>

#include "sandbox/effects/lighting.h"
#include "sandbox/effects/lineage.h"
#include "sandbox/effects/motion_tables.h"
#include "shaders/effects/puff.h"
#include "shaders/shared/hash.h"

namespace plume {
namespace {

constexpr float kStandardGravity = 9.81f;  // m/s^2

uint32_t hash_text(const std::string& text) {
  uint32_t h = 0;
  for (const char c : text) h = shared::hash_pair(h, uint32_t(uint8_t(c)));
  return h;
}

float inverse_or_zero(float value) {
  return value > 0.0f ? 1.0f / value : 0.0f;
}

/// Drag as shaders/effects/ballistic.glsl takes it, exact for weak drag too.
struct Decay {
  double per_tick, share = 1.0, lag = 0.5;
};
Decay decay_of(double drag) {
  const double q = drag / kTicksPerSecond;
  if (q == 0.0) return {.per_tick = 0.0};
  const double per_tick = std::log1p(q), share = per_tick / q;
  // (1 - share) / q cancels; its series is 1/2 - q/3 + q^2/4 - ...
  return {.per_tick = per_tick,
          .share = share,
          .lag = q < 1e-3 ? 0.5 - q / 3.0 + q * q / 4.0 - q * q * q / 5.0 : (1.0 - share) / q};
}

}  // namespace

float camera_offset_m(const Call& call, const Emitter& emitter) {
  const auto here = std::ranges::find(call.layers, emitter.look.layer, &Layer::name);
  const auto own = std::ranges::find(call.effect->layers, emitter.look.layer, &Layer::name);
  if (here == call.layers.end() || own == call.effect->layers.end()) return emitter.look.camera_offset_m;
  return emitter.look.camera_offset_m + here->camera_offset_m - own->camera_offset_m;
}

shared::EmitterData emitter_data(const Call& call, uint32_t index, uint32_t scene_seed, glm::vec3 wind,
                                 MeshTable& meshes) {
  const Emitter& emitter = call.effect->emitters[index];
  const auto& [name, parent, spawn, shape, motion, look] = emitter;
  const float yaw = glm::radians(call.yaw_deg), yaw_sin = std::sin(yaw), yaw_cos = std::cos(yaw);
  const auto turn = [&](glm::vec3 v) {
    return glm::vec3(v.x * yaw_cos + v.z * yaw_sin, v.y, v.z * yaw_cos - v.x * yaw_sin);
  };
  // Named, not numbered: adding an emitter or an instance leaves the others as they were.
  const uint32_t seed = shared::hash_pair(hash_text(call.effect->id + "/" + name),
                                          shared::hash_pair(hash_text(call.name) ^ call.seed, scene_seed));
  const glm::vec3 origin = call.position + turn(shape.offset_m);
  const double orbit_angle = glm::radians(360.0 * double(motion.orbit) / kTicksPerSecond);
  const Collision collision = motion.collision.value_or(Collision{});
  const Displacement& displacement = motion.curl_displacement;
  const Decay decay = decay_of(motion.drag);
  const uint32_t per_parent = births_a_parent(call.effect->emitters, index);
  const uint32_t look_mesh = look.meshes.empty() ? 0 : meshes.add(*call.effect, look.meshes);
  const uint32_t cards_each = look.opaque           ? 0
                              : look.ribbon         ? 2
                              : look.meshes.empty() ? 1
                                                    : meshes.most_triangles(look_mesh, look.meshes.size());
  return {.seed = seed,
          .shape = uint32_t(shape.kind),
          .life_min = spawn.life_ticks.min,
          .life_max = spawn.life_ticks.max,
          .curl_octaves = motion.curl.strength != 0.0f ? motion.curl.octaves : 0,
          .texture_kind = uint32_t(look.texture),
          .flags = (look.lit ? shared::kEmitterLit : 0) |
                   (look.layer.empty() ? 0 : shared::kEmitterSetApart) |
                   (motion.field && motion.field->use == VectorField::Use::kVelocity
                        ? shared::kEmitterFieldIsVelocity
                        : 0) |
                   (casts_shadow(look) ? shared::kEmitterCasts : 0),
          .origin = origin,
          .yaw_sin = yaw_sin,
          .size = shape.kind == ShapeKind::kLine ? shape.to_m : shape.size_m,
          .yaw_cos = yaw_cos,
          .radius = shape.kind == ShapeKind::kMesh ? shape.scale : shape.radius_m,
          .thickness = shape.thickness,
          .cone_angle = glm::radians(shape.angle_deg),
          .speed_min = motion.speed.min,
          .speed_max = motion.speed.max,
          .velocity = turn(motion.velocity),
          .gravity = {0.0f, -kStandardGravity * motion.gravity, 0.0f},
          .drag = motion.drag,
          .decay = float(decay.per_tick),
          .decay_share = float(decay.share),
          .decay_lag = float(decay.lag),
          .wind = wind * motion.wind,
          .buoyancy = motion.buoyancy,
          .inv_cooling = inverse_or_zero(motion.cooling_s),
          .floor_y = motion.floor_y,
          .curl_strength = motion.curl.strength,
          .curl_inv_scale = inverse_or_zero(motion.curl.scale_m),
          .curl_speed = motion.curl.speed,
          .vortex_strength = motion.vortex.strength,
          .vortex_inv_radius = inverse_or_zero(motion.vortex.radius_m),
          .vortex_pull = motion.vortex.pull,
          .orbit_sin = float(std::sin(orbit_angle)),
          .orbit_cos_less = float(std::cos(orbit_angle) - 1.0),
          .field_strength = motion.field ? motion.field->strength : 0.0f,
          .response = uint32_t(collision.response),
          .restitution = collision.bounce,
          .friction = collision.friction,
          .body_radius = collision.radius_m,
          .event_speed = collision.event_speed,
          .displacement_m = displacement.amplitude_m,
          .displacement_inv_m = inverse_or_zero(displacement.scale_m),
          .displacement_speed = displacement.speed,
          .displacement_per_tick =
              displacement.grow_s > 0.0f ? 1.0f / (displacement.grow_s * float(kTicksPerSecond)) : 1.0f,
          .displacement_octaves = displacement.amplitude_m != 0.0f ? displacement.octaves : 0,
          .radius_scale_min = look.radius_scale.min,
          .radius_scale_max = look.radius_scale.max,
          .cross_section = look.cross_section_m2.value_or(0.0f),
          .inv_feather = inverse_or_zero(look.feather_m),
          .inv_near_fade = inverse_or_zero(look.near_fade_m),
          .camera_offset = camera_offset_m(call, emitter),
          .frames_per_tick = look.flipbook_fps / float(kTicksPerSecond),
          .spin_min = glm::radians(look.spin_deg_s.min),
          .spin_max = glm::radians(look.spin_deg_s.max),
          .stretch = look.stretch_s,
          .transmission = look.transmission,
          .distortion = glm::radians(look.distortion_deg),
          .diffusion = glm::radians(look.diffusion_deg),
          .generation = lineage_of(call.effect->emitters, index).generation,
          .parent = 0,  // where it stands is known when its table is made
          .per_parent = per_parent,
          .birth_event = parent ? uint32_t(parent->event) : shared::kBornOfBirth,
          .birth_count = parent ? parent->count : 1,
          .birth_first = parent ? parent->first_tick : 0,
          .birth_every = parent ? parent->every_ticks : 1,
          .inherit_velocity = parent ? parent->inherit_velocity : 0.0f,
          .path_first = 0,
          .path_count = 0,
          .shape_mesh = shape.kind == ShapeKind::kMesh ? meshes.add(*call.effect, {&shape.mesh, 1}) : 0,
          .look_mesh = look_mesh,
          .look_meshes = uint32_t(look.meshes.size()),
          .cards_each = cards_each,
          .tumble_min = glm::radians(look.tumble_deg_s.min),
          .tumble_max = glm::radians(look.tumble_deg_s.max),
          .gloss = look.gloss,
          .strand_births = parent ? per_parent : look.ribbon_births,  // siblings are a strand
          .frames_a_life = look.flipbook_loops * float(shared::kPuffFrames)};
}

uint32_t features_of(const Call& call, uint32_t index) {
  const std::vector<Emitter>& emitters = call.effect->emitters;
  uint32_t features = features_of(emitters[index]) | (call.path ? shared::kUsesPath : 0);
  for (const Emitter* emitter = &emitters[index];; emitter = &emitters[emitter->parent->index]) {
    features |= features_of(*emitter) & ~shared::kIsAnalytic;  // what a child's slot carries is stepped
    if (emitter->shape.kind == ShapeKind::kMesh) features |= shared::kUsesMeshShape;
    if (!emitter->parent) return features;
    features |= shared::kUsesLineage;
  }
}

CurveTable bake_curves(const Look& look) {
  CurveTable table;
  for (uint32_t i = 0; i < shared::kCurveSamples; ++i) {
    const float life = float(i) / float(shared::kCurveSamples - 1);
    const float alpha = look.opacity ? look.opacity->at(life) : 0.0f;
    table[i] = {look.radius_m.at(life), look.fade.at(life), alpha, 0.0f};
    table[shared::kCurveSamples + i] = glm::vec4(look.color.at(life), 0.0f);
    table[2 * shared::kCurveSamples + i] = glm::vec4(look.emission.at(life), 0.0f);
  }
  return table;
}

}  // namespace plume
