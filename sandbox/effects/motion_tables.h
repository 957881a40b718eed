// What emitters move by and meet beyond their own few numbers: attractors, kill volumes, vector fields and
// colliders in tables on the GPU, made once per scene. Instances of one effect share their entries.
#ifndef PLUME_EFFECTS_MOTION_TABLES_H
#define PLUME_EFFECTS_MOTION_TABLES_H

#include <map>
#include <vector>

#include "renderer/gpu/frame.h"
#include "sandbox/effects/bounds.h"
#include "sandbox/effects/effect.h"
#include "sandbox/scene/scene.h"
#include "shaders/shared/motion_tables.h"
#include "shaders/shared/particle.h"

namespace plume {

/// What the emitter's motion is made of: shared::kUses…
uint32_t features_of(const Emitter& emitter);

/// First every emitter's fill(), then upload(), then bindings().
class MotionTables {
 public:
  explicit MotionTables(const std::vector<Solid>& solids);

  /// Enters what the emitter needs and writes the ranges into `data`. The emitter outlives the tables. Where
  /// it is known what its particles can ever reach, solids beyond are not looked at again.
  void fill(const Emitter& emitter, shared::EmitterData& data, const Bounds* reach = nullptr);
  void upload(gpu::Device& device);
  /// Buffers of shaders/effects/{forces,collide}.glsl.
  gpu::Bindings bindings() const;

 private:
  struct Range {
    uint32_t first, count;
  };
  struct Ranges {
    Range attractors, kill;
    uint32_t field_first;
  };
  /// Colliders of one kind: those of the scene, and the lists of them that emitters meet.
  template <class Collider>
  struct Colliders {
    std::vector<Collider> all;
    std::vector<Bounds> extents;
    std::vector<Collider> lists;
    std::map<std::vector<uint32_t>, Range> known;  // by indices into `all`

    Range list_within(const Bounds* reach, float margin);
  };
  Ranges enter(const Emitter& emitter);

  std::map<const Emitter*, Ranges> entered_;
  std::vector<shared::AttractorData> attractors_;
  std::vector<shared::KillVolumeData> kill_volumes_;
  std::vector<glm::vec3> field_cells_;
  Colliders<shared::BoxCollider> boxes_;
  Colliders<shared::RoundCollider> rounds_;
  gpu::Buffer attractor_buffer_, kill_buffer_, field_buffer_, box_buffer_, round_buffer_;
};

}  // namespace plume
#endif
