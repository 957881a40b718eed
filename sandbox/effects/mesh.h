// A surface of triangles: what particles are born on, and what they look like. Read from
// presets/meshes/*.obj.
#ifndef PLUME_EFFECTS_MESH_H
#define PLUME_EFFECTS_MESH_H

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace plume {

constexpr size_t kMaxMeshTriangles = 4096;

struct Mesh {
  std::string id;  ///< file name without extension
  /// Counter-clockwise from outside; each has an area.
  std::vector<std::array<glm::vec3, 3>> triangles;
};

/// A mesh by name, and where a file names it.
struct MeshName {
  std::string id;
  std::string file;
  uint32_t line = 1, column = 1;
  bool operator==(const MeshName& other) const { return id == other.id; }
};

}  // namespace plume
#endif
