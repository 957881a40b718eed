// What particles look like: their cards on the host, and scenes from a preset folder of the test's own.
#ifndef PLUME_TESTS_PARTICLE_LOOKS_H
#define PLUME_TESTS_PARTICLE_LOOKS_H

#include <fstream>

#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/gpu/gpu_test.h"

namespace plume {

class ParticleCards : public GpuTest {
 protected:
  using Triangle = std::array<glm::dvec3, 3>;

  Simulation simulate(const Effect& effect, uint32_t tick, glm::vec3 position = {0, 3, 0}) {
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = position, .yaw_deg = 0, .seed = 1}}, 1,
        {});
    simulation.seek(tick);
    return simulation;
  }
  std::vector<shared::Card> cards_of(const Simulation& simulation, const Light& light = {}) {
    Scene scene;
    scene.light = light;
    scene.camera = {{.tick = 0, .position = {0, 1, 10}, .target = {0, 1, 0}, .vertical_fov_deg = 50}};
    const auto view =
        gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, scene.camera[0], {64, 36}, 0)});
    const gpu::Buffer cards(
        device, {.owner = "test", .label = "cards", .bytes = simulation.cards() * sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    return gpu::read<shared::Card>(device, cards);
  }
  static Triangle corners(const shared::Card& card) {
    const glm::dvec3 c(card.center), u(card.axis_u), v(card.axis_v);
    return {c - u - v, c + u - v, c - u + v};
  }
};

class PresetFolderTest : public GpuTest {
 protected:
  void SetUp() override {
    root_ = std::filesystem::path(testing::TempDir()) /
            (std::string("plume_looks_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(root_);
  }
  void TearDown() override {
    std::filesystem::remove_all(root_);
    GpuTest::TearDown();
  }
  void write(const std::string& path, std::string_view text) {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  std::filesystem::path root_;
};

}  // namespace plume
#endif
