// Synchronization validation: it sees hazards where there are some, and none in what every method draws.
// scripts/validate.sh draws much more with it. Accesses through buffer addresses it cannot see.
#include <regex>

#include "renderer/radix_sort.h"
#include "tests/gpu/environment.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

/// Newer layers (1.4.309) look at what shaders do with buffers and images only when asked.
class WhatShadersDo {
  const EnvironmentVariable asked_{"VK_LAYER_SYNCVAL_SHADER_ACCESSES_HEURISTIC", "1"};
};

class SynchronizationTest : private WhatShadersDo, private EnvironmentVariable, public GpuTest {
 protected:
  SynchronizationTest() : EnvironmentVariable("PLUME_TEST_SYNCHRONIZATION", "1") {}
};

TEST_F(SynchronizationTest, EveryMethodDrawsWithoutHazards) {
  constexpr glm::uvec2 kSize{48, 27};
  const Targets targets(device, kSize);
  for (const char* scene : {"glass", "interleaved"}) {
    Stage stage(device, pipelines, library, library.scene(scene));
    stage.go_to(stage.scene().default_tick, kSize);
    for (const std::string& id : method_ids()) {
      MethodInstance method = instance(id);
      const size_t before = device.validation_messages().size();
      draw(stage, targets, method);
      EXPECT_EQ(before, device.validation_messages().size()) << id << " on " << scene;
    }
  }
}

/// A pass that adds up counts after they were filled, with something between.
class HazardTest : private WhatShadersDo, public testing::Test {
 protected:
  std::vector<std::string> messages(const std::function<void(gpu::Pass&, const gpu::Buffer&)>& record) {
    gpu::Device device({.validate = true, .synchronization_validation = true});
    gpu::Pipelines pipelines(device, shaders_);
    const gpu::Buffer counts(device, {.owner = "test", .label = "counts", .bytes = 4096});
    const auto work = gpu::make_buffer(device, "test", "work", std::vector{shared::workload_of(4)});
    gpu::Frame frame(device, pipelines);
    frame.pass("hazard", [&](gpu::Pass& pass) {
      pass.fill(counts, 0);
      record(pass, counts);
      pass.dispatch(pipelines.compute("sort/scan.comp"), {{"Counts", &counts}, {"Work", &work}}, 0u,
                    {1, 1, 1});
    });
    frame.finish();
    return device.validation_messages();
  }

 private:
  const gpu::Shaders shaders_;
};

TEST_F(HazardTest, AMissingBarrierIsSeen) {
  const auto found = messages([](gpu::Pass&, const gpu::Buffer&) {});
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(std::regex_search(found[0], std::regex("WRITE.AFTER.WRITE")))
      << found[0];  // - or _, by version
}

TEST_F(HazardTest, ABarrierIsEnough) {
  EXPECT_EQ(messages([](gpu::Pass& pass, const gpu::Buffer&) { pass.barrier(); }),
            std::vector<std::string>());
}

}  // namespace
}  // namespace plume
