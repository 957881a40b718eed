// Shaders from disk instead of the embedded ones.
#include <filesystem>
#include <fstream>

#include "renderer/gpu/errors.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

class ShadersTest : public GpuTest {
 protected:
  fs::path folder = fs::temp_directory_path() / ("plume_shaders_" + std::to_string(getpid()));
  void SetUp() override { fs::copy(PLUME_SOURCE_SHADERS, folder, fs::copy_options::recursive); }
  void TearDown() override {
    fs::remove_all(folder);
    GpuTest::TearDown();
  }
  void replace_in(const fs::path& file, const std::string& from, const std::string& to) {
    std::ifstream in(folder / file);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    const size_t at = text.find(from);
    ASSERT_NE(std::string::npos, at) << file;
    std::ofstream(folder / file) << text.replace(at, from.size(), to);
  }
};

TEST_F(ShadersTest, EveryEmbeddedShaderCompilesFromItsFolder) {
  const gpu::Shaders from_disk(folder);
  for (const gpu::EmbeddedShader& shader : gpu::embedded_shaders())
    EXPECT_FALSE(from_disk.load(shader.name).empty()) << shader.name;
}

TEST_F(ShadersTest, ReloadTakesTheChangeAndAFailureKeepsTheOldPipeline) {
  const gpu::Shaders from_disk(folder);
  gpu::Pipelines reloadable(device, from_disk);
  Stage stage(device, reloadable, library, library.scene("street"));
  const Targets targets(device, {64, 36});
  stage.go_to(0, targets.size);
  MethodInstance method = instance("sorted");
  const auto shot = [&] {
    render_frame(device, reloadable, targets, stage.prelude(), stage.transparents(), method);
    return read_picture(device, targets).display.at(32, 30);
  };
  const auto before = shot();

  replace_in("post/display.comp", "vec4(srgb(clamp(color, 0.0, 1.0)), 1.0)", "vec4(1.0, 0.0, 0.0, 1.0)");
  reloadable.reload();
  const std::array<uint8_t, 3> red{255, 0, 0};
  EXPECT_NE(before, red);
  EXPECT_EQ(shot(), red);

  replace_in("post/display.comp", "imageStore(", "imageStroe(");
  try {
    reloadable.reload();
    FAIL() << "a broken shader was accepted";
  } catch (const gpu::ShaderError& error) {
    EXPECT_NE(std::string(error.what()).find("post/display.comp"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("imageStroe"), std::string::npos) << error.what();
  }
  EXPECT_EQ(shot(), red) << "the working pipeline is gone";
}

}  // namespace
}  // namespace plume
