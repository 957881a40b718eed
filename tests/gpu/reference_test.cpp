// The exact reference against the same fragments composited on the CPU in double precision.
#include <glm/gtc/packing.hpp>

#include "tests/gpu/fragment_lists.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

using shared::FragmentNode;

class ReferenceTest : public GpuTest {
 protected:
  struct Captured {
    DrawnPicture picture;
    std::vector<glm::vec4> background;  // linear
    FragmentLists lists;
  };

  Captured capture(const std::string& scene, uint32_t tick, glm::uvec2 size) {
    Stage stage(device, pipelines, library, library.scene(scene));
    const Targets targets(device, size);
    stage.go_to(tick, size);
    MethodInstance reference = instance("reference");
    DrawnPicture picture = draw(stage, targets, reference);
    Captured result{.picture = std::move(picture), .background = {}, .lists = {device, reference.resources}};
    for (const uint64_t texel : gpu::read<uint64_t>(device, targets.opaque_color))
      result.background.push_back(glm::unpackHalf4x16(texel));
    return result;
  }

  /// Sorts for itself, whatever the GPU left in the links.
  static glm::dvec3 composite(std::vector<FragmentNode> list, glm::dvec3 background) {
    std::ranges::sort(list, [](const FragmentNode& a, const FragmentNode& b) {
      return a.depth != b.depth ? a.depth < b.depth : a.id < b.id;
    });
    glm::dvec3 light(0.0), through(1.0);
    for (const FragmentNode& f : list) {
      light += glm::dvec3(f.light) * through;
      through *= glm::dvec3(f.transmittance);
    }
    return light + background * through;
  }
};

TEST_F(ReferenceTest, EqualsTheCompositeInDoublePrecisionOnTheStreet) {
  const Scene street = library.scene("street");
  const glm::uvec2 size{640, 360};
  const Captured c = capture("street", street.default_tick, size);
  double brightest = 0, worst = 0;
  size_t captured = 0, deepest = 0;
  for (size_t pixel = 0; pixel < c.lists.heads.size(); ++pixel) {
    const auto list = c.lists.of(pixel);
    captured += list.size();
    deepest = std::max(deepest, list.size());
    const glm::dvec3 exact = composite(list, c.background[pixel]);
    for (int k = 0; k < 3; ++k) {
      brightest = std::max(brightest, exact[k]);
      worst = std::max(worst, std::abs(exact[k] - double(c.picture.linear.pixels[pixel][k])));
    }
  }
  EXPECT_EQ(c.lists.count, captured) << "fragments were lost";
  EXPECT_GT(deepest, 30u) << "the scene is too thin to prove anything";
  EXPECT_LT(worst, 1e-3 * brightest);
  RecordProperty("worst_over_brightest", std::to_string(worst / brightest));
  RecordProperty("fragments", std::to_string(captured));
  RecordProperty("deepest_pixel", std::to_string(deepest));
}

TEST_F(ReferenceTest, ListsAreLeftSortedByDepthThenCard) {
  const Captured c = capture("street", 150, {160, 90});
  for (size_t pixel = 0; pixel < c.lists.heads.size(); ++pixel) {
    const auto list = c.lists.of(pixel);
    for (size_t i = 1; i < list.size(); ++i)
      ASSERT_TRUE(list[i - 1].depth < list[i].depth ||
                  (list[i - 1].depth == list[i].depth && list[i - 1].id < list[i].id));
  }
}

TEST_F(ReferenceTest, GrowsInsteadOfTruncating) {
  Stage stage(device, pipelines, library, library.scene("street"));
  const glm::uvec2 size{640, 360};
  const Targets targets(device, size);
  stage.go_to(library.scene("street").default_tick, size);
  MethodInstance reference = instance("reference");
  const FrameReport first =
      render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), reference);
  const FrameReport second =
      render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), reference);
  EXPECT_EQ(1u, first.redraws);
  EXPECT_EQ(0u, second.redraws);
  const auto pool = gpu::read<shared::FragmentPool>(device, reference.resources.buffer("pool"))[0];
  EXPECT_LE(pool.count, pool.capacity);
}

}  // namespace
}  // namespace plume
