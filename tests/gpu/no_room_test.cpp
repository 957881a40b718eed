// Device memory that runs out at each allocation of a picture in turn: it is named, all that was taken is
// given back, and the next picture is as if nothing had been.
#include "renderer/gpu/errors.h"
#include "tests/faults/every.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class NoRoomTest : public GpuTest, public testing::WithParamInterface<std::string> {
 protected:
  DrawnPicture picture() {
    Stage stage(device, pipelines, library, library.scene("street"));
    return draw(stage, 200, {32, 18}, GetParam());
  }
};

TEST_P(NoRoomTest, CostsThePictureAndNothingElse) {
  if (!instance(GetParam()).method->missing(device).empty()) GTEST_SKIP() << "the device lacks what it needs";
  const DrawnPicture right = picture();
  const uint64_t taken = device.memory().total_bytes();
  for (uint64_t at = 1;; at += every(GetParam() == "avboit" ? 4 : 17)) {
    device.memory().refuse(at);
    try {
      const DrawnPicture drawn = picture();
      device.memory().refuse(0);
      EXPECT_GT(at, 50u);
      EXPECT_EQ(drawn.display.pixels, right.display.pixels);
      RecordProperty("allocations", int(at - 1));
      break;
    } catch (const gpu::DeviceFailure& failure) {
      const std::string text = failure.what();
      EXPECT_TRUE(text.starts_with("out of device memory: ") && text.find('.') < text.find(" needs "))
          << text;
      EXPECT_EQ(device.memory().total_bytes(), taken) << text;
    }
  }
  device.memory().refuse(0);
  EXPECT_EQ(picture().display.pixels, right.display.pixels);
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, NoRoomTest, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

TEST(DeviceNeedsTest, EachIsNamedWhereItIsMissing) {
  for (const gpu::DeviceNeed& need : gpu::device_needs()) {
    const gpu::DeviceOptions without{.fault = std::string("missing@") + need.name};
    if (!need.required) {
      EXPECT_NO_THROW(gpu::Device{without}) << need.name;
      continue;
    }
    try {
      const gpu::Device device(without);
      ADD_FAILURE() << need.name << " was not missed";
    } catch (const gpu::NoUsableDevice& error) {
      EXPECT_NE(std::string(error.what()).find(need.name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace plume
