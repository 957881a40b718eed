// AVBOIT's stages against a model of each on the CPU.
#include <cmath>
#include <random>

#include "shaders/methods/avboit/volume.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr uint32_t kSlices = 128;
constexpr double kA = 6.5, kB = 813.0;  // the defaults

class AvboitTest : public GpuTest {
 protected:
  struct Layer {
    float z;  // view depth, m
    float alpha;
  };
  struct Volume {
    std::vector<uint32_t> extinction, overflow;
    std::vector<uint8_t> integral;
    glm::uvec2 cells;
    uint32_t field(size_t ray, uint32_t slice) const {
      return extinction[ray * kSlices / 4 + slice / 4] >> (8 * (slice % 4)) & 255;
    }
    /// Transmittance behind a slice, or before the first with slice -1.
    double transmittance(size_t ray, int slice) const {
      return integral[size_t(slice + 1) * cells.x * cells.y + ray] / 255.0;
    }
  };

  /// Full-screen cards in front of the camera, and what the splat and the integration make of them.
  Volume render(const std::vector<Layer>& layers, glm::uvec2 size = {40, 24}) {
    Scene scene;
    scene.id = "layers";
    scene.camera = {{.tick = 0, .position = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = 50}};
    for (const Layer& layer : layers)
      scene.panes.push_back(
          {.position = {0, 0, -layer.z}, .size_m = glm::vec2(layer.z * 10), .coverage = layer.alpha});
    Stage stage(device, pipelines, library, scene);
    const Targets targets(device, size);
    stage.go_to(0, size);
    MethodInstance method = instance("avboit");
    draw(stage, targets, method);
    return {.extinction = gpu::read<uint32_t>(device, method.resources.buffer("extinction")),
            .overflow = gpu::read<uint32_t>(device, method.resources.buffer("overflow")),
            .integral = gpu::read<uint8_t>(device, method.resources.image("integral")),
            .cells = (size + 7u) / 8u};
  }

  static double slice_of(double z) { return kSlices * std::log2(1 + z / kA) / std::log2(1 + kB / kA); }
  static uint32_t quantise(double tau) {
    return uint32_t(std::clamp(tau / std::log(255.0), 0.0, 1.0) * 255 + 0.5);
  }
};

TEST_F(AvboitTest, SplatSharesOpticalDepthBetweenTheTwoNearestSlices) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> depth(0.5f, 300.0f), alpha(0.05f, 0.6f);
  std::vector<Layer> layers;
  std::vector<double> fields(kSlices + 1, 0.0);
  for (int i = 0; i < 12; ++i) {
    layers.push_back({depth(random), alpha(random)});
    const double position = slice_of(layers.back().z), tau = -std::log(1.0 - double(layers.back().alpha));
    const uint32_t slice = uint32_t(position);
    fields[slice] += quantise(tau * (1 - (position - slice)));
    fields[slice + 1] += quantise(tau * (position - slice));
  }
  const Volume volume = render(layers);
  for (size_t ray = 0; ray < volume.overflow.size(); ++ray) {
    EXPECT_EQ(shared::kNoOverflow, volume.overflow[ray]);
    for (uint32_t slice = 0; slice < kSlices;
         ++slice)  // a share at a rounding boundary may fall to either side
      EXPECT_NEAR(fields[slice], volume.field(ray, slice), 1.0) << "ray " << ray << " slice " << slice;
  }
}

TEST_F(AvboitTest, IntegralIsTheTransmittanceOfTheFieldsBeforeIt) {
  const Volume volume = render({{2.0f, 0.3f}, {8.0f, 0.5f}, {9.0f, 0.2f}, {60.0f, 0.7f}});
  for (size_t ray = 0; ray < volume.overflow.size(); ++ray) {
    double tau = 0;
    EXPECT_EQ(1.0, volume.transmittance(ray, -1));
    for (uint32_t slice = 0; slice < kSlices; ++slice) {
      tau += volume.field(ray, slice) * std::log(255.0) / 255;
      EXPECT_NEAR(std::exp(-tau), volume.transmittance(ray, int(slice)), 0.6 / 255) << "slice " << slice;
    }
  }
}

TEST_F(AvboitTest, OverflowKeepsTheFirstSliceAndNothingPassesIt) {
  // Forty layers of alpha 0.9 in one slice are far more than eight bits; one thin layer lies before and one
  // behind.
  std::vector<Layer> layers{{3.0f, 0.2f}, {100.0f, 0.2f}};
  for (int i = 0; i < 40; ++i) layers.push_back({20.0f, 0.9f});
  const Volume volume = render(layers);
  const uint32_t slice = uint32_t(slice_of(20.0));
  for (size_t ray = 0; ray < volume.overflow.size(); ++ray) {
    EXPECT_EQ(slice, volume.overflow[ray]);
    EXPECT_NEAR(0.8, volume.transmittance(ray, int(slice) - 1), 3.0 / 255);
    for (uint32_t behind = slice; behind < kSlices; ++behind)
      ASSERT_EQ(0.0, volume.transmittance(ray, int(behind)));
  }
}

TEST_F(AvboitTest, ACellIsNotLostAtTheEdgeOfAPictureThatCellsDoNotDivide) {
  const Volume volume = render({{5.0f, 0.5f}}, {17, 9});
  ASSERT_EQ(glm::uvec2(3, 2), volume.cells);
  const int behind = int(slice_of(5.0)) + 1;
  for (size_t ray = 0; ray < 6; ++ray)
    EXPECT_NEAR(0.5, volume.transmittance(ray, behind), 3.0 / 255) << "ray " << ray;
}

TEST_F(AvboitTest, OpaqueCardHidesEverythingBehindIt) {
  Scene scene;
  scene.id = "cards";
  scene.tonemap = Tonemap::kNone;
  scene.light.sky = false;
  scene.light.horizon = {0, 0, 0};
  scene.camera = {{.tick = 0, .position = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = 50}};
  const glm::vec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 3; ++i)  // 3 m apart: more than the two slices of bias at 8 m
    scene.panes.push_back({.position = {0, 0, -8.0f - 3.0f * float(i)},
                           .size_m = {100, 100},
                           .color = colors[i],
                           .coverage = 1.0f});
  Stage stage(device, pipelines, library, scene);
  const DrawnPicture picture = draw(stage, 0, {40, 24}, "avboit");
  for (const auto& pixel : picture.display.pixels) {
    EXPECT_EQ(255, pixel[0]);
    EXPECT_LE(pixel[1], 2);
    EXPECT_LE(pixel[2], 2);
  }
}

}  // namespace
}  // namespace plume
