#include "sandbox/effects/mesh_table.h"

#include <algorithm>
#include <stdexcept>

namespace plume {
namespace {

double area_of(const std::array<glm::vec3, 3>& t) {
  return 0.5 *
         glm::length(glm::cross(glm::dvec3(t[1]) - glm::dvec3(t[0]), glm::dvec3(t[2]) - glm::dvec3(t[0])));
}

/// The corner opposite the longest edge: a card's centre is then nearest to the middle of its triangle.
size_t first_corner(const std::array<glm::vec3, 3>& t) {
  const auto opposite = [&](size_t i) { return glm::distance(t[(i + 1) % 3], t[(i + 2) % 3]); };
  return std::ranges::max(std::array<size_t, 3>{0, 1, 2}, {}, opposite);
}

float radius_of(const Mesh& mesh) {
  float farthest = 0;
  for (const auto& triangle : mesh.triangles)
    for (const glm::vec3& corner : triangle) farthest = std::max(farthest, glm::length(corner));
  return farthest;
}

float below(const Mesh& mesh) {
  float least = 0;
  for (const auto& triangle : mesh.triangles)
    for (const glm::vec3& corner : triangle) least = std::min(least, corner.z);
  return -least;
}

}  // namespace

std::vector<shared::MeshTriangle> mesh_triangles(const Mesh& mesh) {
  double whole = 0, until = 0;
  for (const auto& triangle : mesh.triangles) whole += area_of(triangle);
  std::vector<shared::MeshTriangle> result;
  for (const auto& triangle : mesh.triangles) {
    const size_t first = first_corner(triangle);
    const glm::vec3 corner = triangle[first];
    until += area_of(triangle);
    result.push_back({.corner = corner,
                      .area_until = float(until / whole),
                      .edge_u = triangle[(first + 1) % 3] - corner,
                      .edge_v = triangle[(first + 2) % 3] - corner});
  }
  if (!result.empty()) result.back().area_until = 1.0f;  // whatever the sum was rounded to
  return result;
}

uint32_t MeshTable::add(const Effect& effect, std::span<const MeshName> names) {
  const uint32_t first = uint32_t(ranges_.size());
  for (const MeshName& name : names) {
    if (!known_.contains(name.id)) {
      const auto mesh = std::ranges::find(effect.meshes, name.id, &Mesh::id);
      if (mesh == effect.meshes.end() || mesh->triangles.empty())
        throw std::invalid_argument("effect " + effect.id + " names the mesh " + name.id + " but has none");
      const auto triangles = mesh_triangles(*mesh);
      known_[name.id] = {.first = uint32_t(triangles_.size()),
                         .count = uint32_t(triangles.size()),
                         .inv_radius = 1.0f / radius_of(*mesh),
                         .below = below(*mesh)};
      triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    }
    ranges_.push_back(known_.at(name.id));
  }
  return first;
}

uint32_t MeshTable::most_triangles(uint32_t first_range, size_t ranges) const {
  const std::span<const shared::MeshRange> chosen(ranges_.data() + first_range, ranges);
  return chosen.empty() ? 0 : std::ranges::max(chosen, {}, &shared::MeshRange::count).count;
}

void MeshTable::upload(gpu::Device& device) {
  if (empty()) return;
  range_buffer_ = gpu::make_buffer(device, "simulation", "mesh ranges", ranges_);
  triangle_buffer_ = gpu::make_buffer(device, "simulation", "mesh triangles", triangles_);
}

}  // namespace plume
