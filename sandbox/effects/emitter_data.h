// An emitter of a called instance as the GPU reads it.
#ifndef PLUME_EFFECTS_EMITTER_DATA_H
#define PLUME_EFFECTS_EMITTER_DATA_H

#include <array>
#include <optional>

#include "sandbox/effects/clock.h"
#include "sandbox/effects/effect.h"
#include "sandbox/effects/mesh_table.h"
#include "sandbox/effects/path.h"
#include "shaders/shared/particle.h"

namespace plume {

/// An effect called in a scene.
struct Call {
  std::string name;  ///< of the instance
  const Effect* effect;
  uint32_t tick;                           ///< of the scene
  std::optional<uint32_t> stop_tick = {};  ///< of the scene: nothing is born from here on
  std::vector<Freeze> freezes = {};
  glm::vec3 position;
  std::optional<Path> path = {};  ///< that it goes from there
  float yaw_deg;
  uint32_t seed;
  int draw_order = 0;         ///< added to that of its emitters
  std::vector<Layer> layers;  ///< instead of the effect's of the same name
};

/// Metres towards the camera by which an emitter of a call is drawn nearer than it is.
float camera_offset_m(const Call& call, const Emitter& emitter);

/// All but the ranges that MotionTables fill in. Adds the meshes it needs to `meshes`.
shared::EmitterData emitter_data(const Call& call, uint32_t emitter, uint32_t scene_seed, glm::vec3 wind,
                                 MeshTable& meshes);

/// What moving the particles of an emitter takes, with that of its ancestors: kUses...
uint32_t features_of(const Call& call, uint32_t emitter);

using CurveTable = std::array<glm::vec4, shared::kCurvesPerEmitter * shared::kCurveSamples>;
/// The curves of an emitter, sampled evenly over normalised life; rows as shaders/shared/particle.h says.
CurveTable bake_curves(const Look& look);

}  // namespace plume
#endif
