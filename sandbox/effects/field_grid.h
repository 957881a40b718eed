// A vector field on a regular grid, as artists' tools write it in FGA files.
#ifndef PLUME_EFFECTS_FIELD_GRID_H
#define PLUME_EFFECTS_FIELD_GRID_H

#include <glm/glm.hpp>
#include <vector>

namespace plume {

struct FieldGrid {
  glm::uvec3 size{0};            ///< cells along x, y, z
  glm::vec3 low{0}, high{0};     ///< corners of the grid
  std::vector<glm::vec3> cells;  ///< at the cells' centres; x fastest, then y
  bool operator==(const FieldGrid&) const = default;
};

}  // namespace plume
#endif
