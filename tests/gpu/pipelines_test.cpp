// Pipelines are kept while there is room, and what is dropped is made again for whoever asks.
#include "renderer/gpu/pipelines.h"

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class PipelinesTest : public GpuTest {
 protected:
  static constexpr const char* kShaders[] = {"post/display.comp", "sort/count.comp", "sort/scan.comp"};
};

TEST_F(PipelinesTest, ThoseAskedForLastAreKeptOnceNoFrameUsesThem) {
  gpu::Pipelines two(device, shaders, {}, 2);
  const auto ask = [&](std::initializer_list<int> wanted) {
    const gpu::Pipelines::Use use(two);
    for (const int i : wanted) two.compute(kShaders[i]);
    EXPECT_GE(two.count(), std::set(wanted).size()) << "dropped while in use";
  };
  ask({0, 1, 2, 0});
  EXPECT_EQ(two.count(), 2u);
  EXPECT_EQ(two.made(), 3u);
  ask({0, 2});
  EXPECT_EQ(two.made(), 3u) << "one of the two that were asked for last was dropped";
  ask({1});
  EXPECT_EQ(two.made(), 4u);
  EXPECT_EQ(two.count(), 2u);
  ask({2});
  EXPECT_EQ(two.made(), 4u);
  ask({0});
  EXPECT_EQ(two.made(), 5u);
}

TEST_F(PipelinesTest, AFrameInsideAnotherDropsNothing) {
  gpu::Pipelines one(device, shaders, {}, 1);
  {
    gpu::Frame outer(device, one);
    one.compute(kShaders[0]);
    { gpu::Frame inner(device, one); }
    one.compute(kShaders[1]);
    { gpu::Frame inner(device, one); }
    EXPECT_EQ(one.count(), 2u);
  }
  EXPECT_EQ(one.count(), 1u);
}

TEST_F(PipelinesTest, PicturesAreTheSameWhereAllAreDroppedEachTime) {
  gpu::Pipelines none(device, shaders, {}, 0);
  const glm::uvec2 size{64, 36};
  const auto shot = [&](gpu::Pipelines& kept) {
    Stage stage(device, kept, library, library.scene("street"));
    const Targets targets(device, size);
    stage.go_to(40, size);
    MethodInstance method = instance("avboit");
    for (int i = 0; i < 2; ++i)
      render_frame(device, kept, targets, stage.prelude(), stage.transparents(), method);
    return read_picture(device, targets).linear;
  };
  const Image picture = shot(none);
  EXPECT_EQ(none.count(), 0u);
  EXPECT_GT(none.made(), 20u);
  EXPECT_EQ(picture.pixels, shot(pipelines).pixels);
}

}  // namespace
}  // namespace plume
