// The small pictures that presets are picked by.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "sandbox/measure/image_io.h"
#include "sandbox/measure/small_picture.h"
#include "sandbox/presets/library.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

TEST(PresetPictures, EveryShippedSceneAndEffectHasOneOfTheRightSize) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  uintmax_t bytes = 0;
  size_t count = 0;
  for (const PresetKind kind : {PresetKind::kScene, PresetKind::kEffect})
    for (const std::string& id : library.ids(kind)) {
      const auto file = library.picture(kind, id);
      ASSERT_TRUE(file) << id << " has none; run scripts/gallery.sh preset_pictures";
      const DisplayImage picture = read_png(*file);
      EXPECT_EQ(glm::uvec2(picture.width, picture.height), kPictureSize) << *file;
      bytes += fs::file_size(*file);
      ++count;
    }
  EXPECT_LT(bytes, 500'000u);
  size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(PLUME_SOURCE_PRESETS) / "pictures"))
    files += entry.is_regular_file();
  EXPECT_EQ(files, count) << "pictures of presets that are gone";
}

TEST(PresetPictures, StandBesideTheFolderOfTheirPresets) {
  const fs::path root = fs::path(testing::TempDir()) / fmt::format("plume_pictures_{}", ::getpid());
  for (const char* folder : {"scenes", "effects", "pictures/scenes"}) fs::create_directories(root / folder);
  for (const char* file : {"scenes/a.b.toml", "effects/a.b.toml", "pictures/scenes/a.b.png"})
    std::ofstream(root / file) << "";
  const PresetLibrary library(root);
  EXPECT_EQ(library.picture(PresetKind::kScene, "a.b"), root / "pictures/scenes/a.b.png");
  EXPECT_EQ(library.picture(PresetKind::kEffect, "a.b"), std::nullopt);
  EXPECT_EQ(library.picture(PresetKind::kScene, "gone"), std::nullopt);
  EXPECT_EQ(PresetLibrary("nowhere").picture(PresetKind::kScene, (root / "scenes/a.b.toml").string()),
            root / "pictures/scenes/a.b.png")
      << "of a file anywhere";
  fs::remove_all(root);
}

TEST(SmallPicture, IsTheMeanOfTheMiddleInLinearLight) {
  DisplayImage wide{8, 2, {}};
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 8; ++x)
      wide.pixels.push_back(x < 2 || x >= 6 ? std::array<uint8_t, 3>{255, 0, 255}  // cut off
                            : x < 4         ? std::array<uint8_t, 3>{0, 255, 0}
                                            : std::array<uint8_t, 3>{uint8_t(255 * y), 0, 0});
  const DisplayImage small = small_picture(wide, {2, 1});
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  EXPECT_EQ(small.at(0, 0), (std::array<uint8_t, 3>{0, 255, 0}));
  EXPECT_EQ(small.at(1, 0), (std::array<uint8_t, 3>{188, 0, 0})) << "half the light of 255 is 188, not 128";
  EXPECT_EQ(small_picture(small, {4, 2}).at(3, 1), small.at(1, 0)) << "larger repeats";
  EXPECT_THROW(small_picture({}, {2, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace plume
