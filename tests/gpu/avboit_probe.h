// A small compute shader of a test's own beside the real ones, to ask a function of a shared shader file
// directly.
#ifndef PLUME_TESTS_AVBOIT_PROBE_H
#define PLUME_TESTS_AVBOIT_PROBE_H

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/gpu/avboit_scene.h"

namespace plume {

class AvboitProbe : public AvboitTest {
 protected:
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("plume_probe_" + std::to_string(getpid()));
  gpu::Shaders probe_shaders{folder};
  std::unique_ptr<gpu::Pipelines> probes;

  void SetUp() override {
    const char* other = std::getenv("PLUME_TEST_SHADERS");
    std::filesystem::copy(other ? other : PLUME_SOURCE_SHADERS, folder,
                          std::filesystem::copy_options::recursive);
    probes = std::make_unique<gpu::Pipelines>(device, probe_shaders);
  }
  void TearDown() override {
    std::filesystem::remove_all(folder);
    AvboitTest::TearDown();
  }
  void write_probe(const std::string& name, const std::string& text) {
    std::ofstream(folder / name) << "#version 460\n#extension GL_GOOGLE_include_directive : require\n"
                                 << text;
  }
  template <class Push>
  void ask(const char* shader, const gpu::Constants& constants, const gpu::Bindings& bindings,
           const Push& push, uint32_t groups_x) {
    gpu::Frame frame(device, *probes);
    frame.pass(shader, [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute(shader, constants), bindings, push, {groups_x, 1, 1});
    });
    frame.finish();
  }
};

}  // namespace plume
#endif
