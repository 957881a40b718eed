// What the driver made, kept between runs in a file that anything may have happened to.
#include "renderer/gpu/pipeline_cache.h"

#include <random>

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class PipelineCacheTest : public GpuTest {
 protected:
  using Bytes = std::vector<uint8_t>;
  std::string refused(const Bytes& kept) { return gpu::PipelineCache(device, kept).refused(); }
  Bytes filled() {
    pipelines.compute("post/display.comp");
    return pipelines.cache().bytes();
  }
};

TEST_F(PipelineCacheTest, TakesBackWhatItGave) {
  const Bytes kept = filled();
  EXPECT_EQ(refused(kept), "");
  EXPECT_EQ(gpu::PipelineCache(device, kept).bytes(), kept);
  EXPECT_EQ(refused({}), "");
}

TEST_F(PipelineCacheTest, RefusesWhatIsCutShortDamagedOrHasGrown) {
  const Bytes kept = filled();
  for (size_t length = 1; length < kept.size(); length += 1 + length / 8)
    EXPECT_NE(refused({kept.begin(), kept.begin() + std::ptrdiff_t(length)}), "") << length;
  for (size_t at = 0; at < kept.size(); at += 1 + at / 16) {
    Bytes damaged = kept;
    damaged[at] ^= 0x10;
    EXPECT_NE(refused(damaged), "") << at;
  }
  Bytes grown = kept;
  grown.push_back(0);
  EXPECT_NE(refused(grown), "");
  std::mt19937 random(1);
  Bytes garbage(10'000);
  for (uint8_t& byte : garbage) byte = uint8_t(random());
  EXPECT_NE(refused(garbage), "");
}

TEST_F(PipelineCacheTest, PipelinesAreMadeAnewWhereItIsRefused) {
  Bytes damaged = filled();
  damaged.back() ^= 1;
  gpu::Pipelines fresh(device, shaders, damaged);
  EXPECT_NE(fresh.cache().refused(), "");
  EXPECT_TRUE(*fresh.compute("post/display.comp").pipeline);
  EXPECT_EQ(refused(fresh.cache().bytes()), "");
}

TEST_F(PipelineCacheTest, FileNameIsThatOfTheDeviceAndDriver) {
  const std::string name = gpu::PipelineCache::file_name(device);
  EXPECT_TRUE(name.starts_with("pipelines-") && name.ends_with(".bin")) << name;
  EXPECT_EQ(name.find('/'), name.npos);
}

}  // namespace
}  // namespace plume
