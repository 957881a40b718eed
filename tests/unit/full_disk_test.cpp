// Files that do not fit, for each writer of the library: what is there stays as it was, and nothing else
// comes to be. A limit on the size of files stands for the disk: a write that crosses it takes what fits, the
// next fails.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>

#include "sandbox/measure/image_io.h"
#include "sandbox/presets/preset_document.h"
#include "sandbox/runs/manifest.h"
#include "sandbox/workspace/settings.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScene = "name = \"S\"\n[camera]\nposition = [0, 1, 5]\ntarget = [0, 1, 0]\n";

class FilesThatDoNotFit : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "scenes");
    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
  }
  void TearDown() override {
    setrlimit(RLIMIT_FSIZE, &before_);
    fs::remove_all(folder_);
  }

  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      std::ifstream in(entry.path(), std::ios::binary);
      if (entry.is_regular_file())
        found[entry.path().lexically_relative(folder_)] = {std::istreambuf_iterator<char>(in), {}};
    }
    return found;
  }

  /// Writes where only so many bytes of any file fit, from none on until all of `file` do.
  void fail_at_each_size(const fs::path& file, const std::function<void()>& write) {
    const auto before = files();
    for (rlim_t size = 0;; size += 1 + size / 3) {
      const rlimit limit{size, before_.rlim_max};
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
      try {
        write();
        setrlimit(RLIMIT_FSIZE, &before_);
        EXPECT_GT(size, 0u);
        EXPECT_GE(size, fs::file_size(folder_ / file));
        return;
      } catch (const FileError& error) {
        setrlimit(RLIMIT_FSIZE, &before_);
        EXPECT_EQ(std::string(error.what()).find(".tmp-"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("File too large"), std::string::npos) << error.what();
      }
      ASSERT_EQ(files(), before) << size;
    }
  }

  const fs::path folder_ =
      fs::path(testing::TempDir()) / ("plume files that do not fit " + std::to_string(getpid()));
  rlimit before_{};
};

TEST_F(FilesThatDoNotFit, LeavePicturesAsTheyWere) {
  std::ofstream(folder_ / "a.png") << "of before";
  const DisplayImage picture{32, 32, std::vector<std::array<uint8_t, 3>>(1024)};
  const Image linear{32, 32, std::vector<glm::vec3>(1024, glm::vec3(0.5f))};
  fail_at_each_size("a.png", [&] { write_png(folder_ / "a.png", picture); });
  fail_at_each_size("a.exr", [&] { write_exr(folder_ / "a.exr", linear); });
  EXPECT_EQ(read_png(folder_ / "a.png").pixels, picture.pixels);
  EXPECT_EQ(read_exr(folder_ / "a.exr").pixels, linear.pixels);
}

TEST_F(FilesThatDoNotFit, LeaveSettingsAsTheyWere) {
  Settings settings;
  save_settings(folder_ / "settings.toml", settings);
  settings.scene = "another";
  fail_at_each_size("settings.toml", [&] { save_settings(folder_ / "settings.toml", settings); });
  EXPECT_EQ(load_settings(folder_ / "settings.toml").scene, "another");
}

TEST_F(FilesThatDoNotFit, LeavePresetsAsTheyWereAndEditsUnsaved) {
  const fs::path file = folder_ / "scenes/s.toml";
  std::ofstream(file) << kScene;
  PresetDocument document(file, PresetKind::kScene, PresetLibrary(folder_));
  document.set("name", std::string("T"));
  fail_at_each_size("scenes/s.toml", [&] {
    EXPECT_TRUE(document.is_changed());
    document.save();
  });
  EXPECT_FALSE(document.is_changed());
  document.set("name", std::string("U"));
  fail_at_each_size("scenes/u.toml", [&] {
    EXPECT_EQ(document.path(), file);
    document.save_as(folder_ / "scenes/u.toml");
  });
  EXPECT_EQ(document.path(), folder_ / "scenes/u.toml");
}

TEST_F(FilesThatDoNotFit, LeaveResultsAsTheyWere) {
  Results results;
  results.command = "first";
  write_results(folder_, results);
  results.command = "a second one";
  fail_at_each_size("results.json", [&] { write_results(folder_, results); });
}

TEST_F(FilesThatDoNotFit, AreFollowedByNothingOfAKilledProcess) {
  const pid_t dead = fork();
  if (dead == 0) _exit(0);
  int status = 0;
  waitpid(dead, &status, 0);
  std::ofstream(folder_ / ("a.toml.tmp-" + std::to_string(dead) + "-0")) << "half";
  replace_file(folder_ / "a.toml", "whole");
  EXPECT_EQ(files(), (std::map<std::string, std::string>{{"a.toml", "whole"}}));
}

}  // namespace
}  // namespace plume
