// A folder of presets of a test's own, and workspaces on it.
#ifndef PLUME_TESTS_WORKSPACE_TEST_H
#define PLUME_TESTS_WORKSPACE_TEST_H

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "sandbox/workspace/workspace.h"
#include "tests/gpu/gpu_test.h"

namespace plume {

class WorkspaceTest : public GpuTest {
 protected:
  explicit WorkspaceTest(bool validate = true) : GpuTest(validate) {
    std::filesystem::remove_all(root_);
    for (const char* folder : {"effects", "scenes"}) std::filesystem::create_directories(root_ / folder);
  }
  ~WorkspaceTest() override { std::filesystem::remove_all(root_); }

  void write(const std::filesystem::path& name, std::string_view text) const {
    std::ofstream(root_ / name) << text;
  }
  std::string read(const std::filesystem::path& name) const {
    std::ifstream file(root_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static std::string with(std::string_view text, std::string_view old, std::string_view by) {
    std::string changed(text);
    return changed.replace(changed.find(old), old.size(), by);
  }

  Workspace open(Scene scene, uint32_t tick = 50) {
    return {device, pipelines, presets_, std::move(scene), Playback(tick, 200, false)};
  }
  /// Draws, and gives the state of all particles that are seen.
  uint64_t seen(Workspace& workspace) {
    workspace.draw(kSize);
    return workspace.stage().simulation().state_hash();
  }

  static constexpr glm::uvec2 kSize{96, 54};
  const std::filesystem::path root_ =
      std::filesystem::path(testing::TempDir()) / fmt::format("plume_presets_{}", ::getpid());
  const PresetLibrary presets_{root_};
};

}  // namespace plume
#endif
