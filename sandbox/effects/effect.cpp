#include "sandbox/effects/effect.h"

#include <algorithm>

namespace plume {

bool VectorField::operator==(const VectorField& other) const {
  const bool same_grid = grid == other.grid || (grid && other.grid && *grid == *other.grid);
  return same_grid && id == other.id && use == other.use && strength == other.strength &&
         scale == other.scale && offset_m == other.offset_m;
}

namespace {

/// Of a name that both have, the same triangles.
bool same_meshes(const std::vector<Mesh>& a, const std::vector<Mesh>& b) {
  return std::ranges::all_of(a, [&](const Mesh& mesh) {
    const auto other = std::ranges::find(b, mesh.id, &Mesh::id);
    return other == b.end() || other->triangles == mesh.triangles;
  });
}

bool same_motion(const std::vector<Emitter>& a, size_t i, const std::vector<Emitter>& b, size_t j) {
  const Emitter &x = a.at(i), &y = b.at(j);
  if (x.name != y.name || x.parent.has_value() != y.parent.has_value()) return false;
  if (x.parent) {
    Parent parent = *x.parent;
    parent.index = y.parent->index;  // others may have come before it
    if (parent != *y.parent || !same_motion(a, x.parent->index, b, y.parent->index)) return false;
  }
  return x.spawn == y.spawn && x.shape == y.shape && x.motion == y.motion && x.look.ribbon == y.look.ribbon &&
         x.look.opaque == y.look.opaque;
}

}  // namespace

bool same_states(const Effect& a, size_t i, const Effect& b, size_t j) {
  return same_meshes(a.meshes, b.meshes) && same_motion(a.emitters, i, b.emitters, j);
}

}  // namespace plume
