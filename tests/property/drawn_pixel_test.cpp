// A picture that stands can be asked as well as a frame that is being drawn.
#include "renderer/drawn_pixel.h"

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class DrawnPixelProperties : public GpuTest, public testing::WithParamInterface<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, DrawnPixelProperties, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

TEST_P(DrawnPixelProperties, APictureThatStandsTellsWhatItsFrameTold) {
  const glm::uvec2 size{66, 34}, pixel{33, 17};
  Stage stage(device, pipelines, library, library.scene("three_cards"));
  const Targets targets(device, size);
  stage.go_to(0, size);
  MethodInstance method = instance(GetParam());
  const Probe probe(device, pixel, std::vector<float>{1.0f, 4.0f, 6.5f, 8.0f, 8.5f, 9.5f, 10.5f, 20.0f});
  render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method, &probe);
  const auto of_frame = probe.read_answer(device);
  for (int again = 0; again < 2; ++again)
    EXPECT_EQ(transmittance_at(device, pipelines, targets, stage.transparents(), method, probe), of_frame);
}

}  // namespace
}  // namespace plume
