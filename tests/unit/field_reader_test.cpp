#include <gtest/gtest.h>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_field.h"

namespace plume {
namespace {

std::string mistake_in(std::string_view text) {
  try {
    read_field_text(text, "f.fga");
  } catch (const FileErrors& errors) {
    return errors.what();
  }
  return "";
}

TEST(FieldReader, ReadsSizeBoundsAndVectorsWithXFastest) {
  const FieldGrid grid =
      read_field_text("2,1,2,\n-1,0,-2,\n1,3,2,\n1,2,3,\n4,5,6,\n7,8,9,\n-1,-2.5,1e1,\n", "f.fga");
  EXPECT_EQ(grid.size, glm::uvec3(2, 1, 2));
  EXPECT_EQ(grid.low, glm::vec3(-1, 0, -2));
  EXPECT_EQ(grid.high, glm::vec3(1, 3, 2));
  ASSERT_EQ(grid.cells.size(), 4u);
  EXPECT_EQ(grid.cells[1], glm::vec3(4, 5, 6));
  EXPECT_EQ(grid.cells[3], glm::vec3(-1, -2.5f, 10));
}

TEST(FieldReader, NeedsNoCommaOrLineAtTheEnd) {
  EXPECT_EQ(read_field_text("1 1 1 0 0 0 1 1 1 5 6 7", "f.fga").cells[0], glm::vec3(5, 6, 7));
}

TEST(FieldReader, NamesThePlaceOfWhatIsWrongAndWhatWouldBeRight) {
  EXPECT_EQ(mistake_in(""),
            "f.fga:1:1: the file ends here, expected cells along a side: a whole number from 1 to 32");
  EXPECT_EQ(mistake_in("1,33,1"),
            "f.fga:1:3: \"33\" is no such number, expected cells along a side: a whole number from 1 to 32");
  EXPECT_EQ(mistake_in("1,1.5,1"),
            "f.fga:1:3: \"1.5\" is no such number, expected cells along a side: a whole number from 1 to 32");
  EXPECT_EQ(mistake_in("1,1,1,\n0,0,0,\n1,-1,1,\n0,0,0"),
            "f.fga:3:3: \"-1\" is no such number, expected high corner of the bounds, 0.001 or more above "
            "the low one: a "
            "number from 0.001 to 10000");
  EXPECT_EQ(mistake_in("1,1,1,\n0,0,0,\n1,1,1,\n0,nan,0"),
            "f.fga:4:3: \"nan\" is no such number, expected vector 1 of 1: a number from -10000 to 10000");
  EXPECT_EQ(mistake_in("1,1,1,\n0,0,0,\n1,1,1,\n0,0x1,0"),
            "f.fga:4:3: \"0x1\" is no such number, expected vector 1 of 1: a number from -10000 to 10000");
  EXPECT_EQ(mistake_in("1,1,1,\n0,0,0,\n1,1,1,\n0,0,\n"),
            "f.fga:5:1: the file ends here, expected vector 1 of 1: a number from -10000 to 10000");
  EXPECT_EQ(mistake_in("1,1,1,\n0,0,0,\n1,1,1,\n0,0,0,\n4"),
            "f.fga:5:1: there are more numbers than the size says, expected the end of the file");
}

}  // namespace
}  // namespace plume
