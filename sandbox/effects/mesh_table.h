// The meshes of a scene's effects on the GPU: triangles with their shares of area, and the ranges of them
// that emitters choose from. Nothing is allocated where no emitter names a mesh.
#ifndef PLUME_EFFECTS_MESH_TABLE_H
#define PLUME_EFFECTS_MESH_TABLE_H

#include <map>
#include <span>

#include "renderer/gpu/resources.h"
#include "sandbox/effects/effect.h"
#include "shaders/shared/mesh.h"

namespace plume {

/// As shaders/shared/mesh.h says. A mesh without triangles gives none.
std::vector<shared::MeshTriangle> mesh_triangles(const Mesh& mesh);

class MeshTable {
 public:
  /// The index of the first of names.size() ranges that follow each other, one for each name. The effect has
  /// these meshes; those of one id are one mesh, whatever effect brings it.
  uint32_t add(const Effect& effect, std::span<const MeshName> names);
  /// Of one that was added.
  uint32_t most_triangles(uint32_t first_range, size_t ranges) const;
  void upload(gpu::Device& device);

  bool empty() const { return ranges_.empty(); }
  /// Without memory when empty.
  const gpu::Buffer& ranges() const { return range_buffer_; }
  const gpu::Buffer& triangles() const { return triangle_buffer_; }

 private:
  std::map<std::string, shared::MeshRange> known_;
  std::vector<shared::MeshRange> ranges_;
  std::vector<shared::MeshTriangle> triangles_;
  gpu::Buffer range_buffer_, triangle_buffer_;
};

}  // namespace plume
#endif
