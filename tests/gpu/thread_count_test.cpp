// Pictures by one thread of llvmpipe and by two are the same to the bit, where 2/255 would be allowed:
// llvmpipe gives a tile of 64 x 64 pixels to one thread, which draws its primitives in their order, so
// blends, lists and spinlocks of one pixel see the same order; what pixels and work groups share is added in
// integers, or sorted by keys that do not depend on who came first.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "tests/gpu/environment.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{136, 72};  // six tiles

/// Of this process, those that draw.
int rasterizer_threads() {
  int count = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm") >> std::ws, name);
    count += name.rfind("llvmpipe", 0) == 0;
  }
  return count;
}

struct Case {
  std::string scene, method;
  std::map<std::string, std::string> settings;
};

std::vector<DrawnPicture> pictures(const std::vector<Case>& cases, int threads) {
  const EnvironmentVariable count("LP_NUM_THREADS", std::to_string(threads));
  const int before = rasterizer_threads();
  gpu::Device device({});
  const gpu::Shaders shaders;
  gpu::Pipelines pipelines(device, shaders);
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  std::map<std::string, std::unique_ptr<Stage>> stages;
  std::vector<DrawnPicture> drawn;
  for (const auto& [scene, id, settings] : cases) {
    std::unique_ptr<Stage>& stage = stages[scene];
    if (!stage) {
      stage = std::make_unique<Stage>(device, pipelines, library, library.scene(scene));
      stage->go_to(stage->scene().default_tick, kSize);
    }
    MethodInstance method{.method = make_method(id), .owner = id, .resources = {}};
    for (const auto& [name, value] : settings) set_parameter(*method.method, name, value);
    const Targets targets(device, kSize, stage->post());
    render_frame(device, pipelines, targets, stage->prelude(), stage->transparents(), method);
    drawn.push_back(read_picture(device, targets));
  }
  EXPECT_EQ(before + threads, rasterizer_threads());  // they name themselves once they run
  return drawn;
}

TEST(ThreadCountTest, PicturesAreTheSameByOneThreadAndByTwo) {
  if (gpu::list_devices().empty() || !gpu::list_devices()[0].is_cpu) GTEST_SKIP() << "needs llvmpipe";
  std::vector<Case> cases;
  for (const std::string& id : method_ids()) {
    cases.push_back({"street", id, {}});
    if (id == "linked_list") cases.back().settings = {{"fragments", "256"}};  // room for all
  }
  for (const char* splat : {"packed8", "packed8_exchange", "packed8_overflow", "words32", "raster"})
    cases.push_back({"street", "avboit", {{"splat", splat}}});
  const auto one = pictures(cases, 1), two = pictures(cases, 2);
  for (size_t i = 0; i < cases.size(); ++i) {
    int most = 0, differ = 0;
    float linear = 0;
    for (size_t p = 0; p < one[i].display.pixels.size(); ++p) {
      for (int c = 0; c < 3; ++c) {
        const int of_255 =
            std::abs(one[i].display.pixels[p][size_t(c)] - two[i].display.pixels[p][size_t(c)]);
        most = std::max(most, of_255);
        linear = std::max(linear, std::abs(one[i].linear.pixels[p][c] - two[i].linear.pixels[p][c]));
      }
      differ += one[i].linear.pixels[p] != two[i].linear.pixels[p];
    }
    const std::string name = fmt::format("{} on {} {}", cases[i].method, cases[i].scene,
                                         cases[i].settings.empty() ? "" : cases[i].settings.begin()->second);
    EXPECT_LE(most, 2) << name;
    EXPECT_EQ(differ, 0) << name << ": pixels differ, by " << most << "/255 or " << linear << " of light";
  }
}

}  // namespace
}  // namespace plume
