// A mesh from a Wavefront OBJ file: `v x y z` and `f`, whose polygons are convex and are cut into fans.
// Texture coordinates, normals, groups, objects and materials may be there and are not used; anything else is
// an error.
#ifndef PLUME_PRESETS_READ_MESH_H
#define PLUME_PRESETS_READ_MESH_H

#include <filesystem>
#include <string_view>

#include "sandbox/effects/mesh.h"

namespace plume {

/// Throws FileErrors with everything wrong in the file, in its order.
Mesh read_mesh_text(std::string_view text, const std::string& file);
Mesh read_mesh(const std::filesystem::path& path);

}  // namespace plume
#endif
