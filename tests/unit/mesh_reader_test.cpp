// OBJ files: what is read, and what a mistake says.
#include <gtest/gtest.h>

#include "sandbox/effects/mesh_table.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/read_mesh.h"

namespace plume {
namespace {

std::vector<std::string> mistakes_of(std::string_view text) {
  std::vector<std::string> result;
  try {
    read_mesh_text(text, "m.obj");
  } catch (const FileErrors& errors) {
    for (const Diagnostic& d : errors.diagnostics()) result.push_back(to_string(d));
  }
  return result;
}

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(MeshReader, CutsPolygonsIntoFansAndTakesEveryFormOfCorner) {
  const Mesh mesh = read_mesh_text("# a square\nvn 0 0 1\nusemtl glass\r\n" + std::string(kSquare) +
                                       "f 1/1/1 2//1 3/2 4  # twice\nf -4 -3 -2\n",
                                   "meshes/square.obj");
  EXPECT_EQ("square", mesh.id);
  ASSERT_EQ(3u, mesh.triangles.size());
  EXPECT_EQ((std::array<glm::vec3, 3>{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}), mesh.triangles[1]);
  EXPECT_EQ(mesh.triangles[0], mesh.triangles[2]);
}

TEST(MeshReader, NamesThePlaceAndTheRemedyOfEveryMistake) {
  EXPECT_EQ(mistakes_of("v 0 0\nv 1 x nan\n  quad 1 2\nf 1 2\nf 1 2 9\n"),
            (std::vector<std::string>{
                "m.obj:1:1: `v` with 2 numbers, expected 3: x y z",
                "m.obj:2:5: `x`, expected a number from -1000 to 1000",
                "m.obj:2:7: `nan`, expected a number from -1000 to 1000",
                "m.obj:3:3: unknown statement `quad`, expected `v` or `f`",
                "m.obj:4:1: `f` with 2 corners, expected 3 to 64",
                "m.obj:5:7: `9`, expected a vertex from 1 to 2, the number of `v` so far",
            }));
  EXPECT_EQ(mistakes_of(std::string(kSquare) + "f 1 2 2"),
            std::vector<std::string>{
                "m.obj:5:1: a face without area, expected corners that are apart and not in a line"});
  EXPECT_EQ(mistakes_of(std::string(kSquare) + "f 0 1 2\nf -5 1 2\nf 1 2 3x\nv 1 2y 3"),
            (std::vector<std::string>{
                "m.obj:5:3: `0`, expected a vertex from 1 to 4, the number of `v` so far",
                "m.obj:6:3: `-5`, expected a vertex from 1 to 4, the number of `v` so far",
                "m.obj:7:7: `3x`, expected a vertex from 1 to 4, the number of `v` so far",
                "m.obj:8:5: `2y`, expected a number from -1000 to 1000",
            }));
  std::string many_corners = std::string(kSquare) + "f";
  for (int i = 0; i < 65; ++i) many_corners += " 1";
  EXPECT_EQ(mistakes_of(many_corners),
            std::vector<std::string>{"m.obj:5:1: `f` with 65 corners, expected 3 to 64"});
  EXPECT_EQ(
      mistakes_of(kSquare),
      std::vector<std::string>{"m.obj:1:1: the file has no face, expected `v x y z` for the corners and "
                               "`f` for the faces of a mesh"});
}

TEST(MeshReader, StopsAtTooManyTrianglesAndAtTooManyMistakes) {
  std::string large(kSquare);
  for (size_t i = 0; i < kMaxMeshTriangles; ++i) large += "f 1 2 3\n";
  EXPECT_EQ(kMaxMeshTriangles, read_mesh_text(large, "m.obj").triangles.size());
  EXPECT_EQ(mistakes_of(large + "f 1 2 3\nf 1 2 3"),
            std::vector<std::string>{
                "m.obj:4101:1: more than 4096 triangles, expected at most 4096: simplify the mesh"});
  std::string binary(100'000, '\n');
  for (size_t i = 0; i < binary.size(); i += 2) binary[i] = char(i % 251 + 1);
  EXPECT_LE(mistakes_of(binary).size(), 21u);
}

TEST(MeshReader, TheTableSumsAreasUpToOneAndStartsOppositeTheLongestEdge) {
  const auto table = mesh_triangles(
      {.id = "m", .triangles = {{{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}}, {{{3, 3, 0}, {0, 0, 0}, {3, 0, 0}}}}});
  ASSERT_EQ(2u, table.size());
  EXPECT_FLOAT_EQ(1.0f / 5.5f, table[0].area_until);
  EXPECT_EQ(1.0f, table[1].area_until);
  EXPECT_EQ(glm::vec3(3, 0, 0), table[1].corner);
  EXPECT_EQ(glm::vec3(0, 3, 0), table[1].edge_u);
  EXPECT_EQ(glm::vec3(-3, 0, 0), table[1].edge_v);
}

TEST(MeshReader, EveryShippedMeshIsReadAndNoEffectNamesOneThatIsNotThere) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  const auto ids = library.ids(PresetKind::kMesh);
  EXPECT_GE(ids.size(), 7u);
  for (const std::string& id : ids) EXPECT_FALSE(library.mesh(id).triangles.empty()) << id;
}

}  // namespace
}  // namespace plume
