#include "sandbox/workspace/accuracy_log.h"

#include <gtest/gtest.h>

#include "renderer/methods/methods.h"
#include "renderer/parameters.h"

namespace plume {
namespace {

/// One grey everywhere, in light and as it is displayed.
DrawnPicture grey(float light, uint8_t shown) {
  constexpr int kSide = 16;
  return {
      .linear = {kSide, kSide, std::vector<glm::vec3>(kSide * kSide, glm::vec3(light))},
      .display = {kSide, kSide, std::vector<std::array<uint8_t, 3>>(kSide * kSide, {shown, shown, shown})}};
}

MethodInstance method(std::string_view id) {
  return {.method = make_method(id), .owner = std::string(id), .resources = {}};
}

TEST(AccuracyLogTest, ErrorsAreAgainstTheReference) {
  AccuracyLog log;
  const DrawnPicture exact = grey(0.5f, 100);
  log.add(method("wboit"), grey(0.75f, 120), exact, 3);
  log.add(method("sorted"), grey(0.5f, 100), exact, 2);
  ASSERT_EQ(log.entries().size(), 2u);
  EXPECT_NEAR(log.entries()[0].rmse, 0.25, 1e-6);
  EXPECT_GT(log.entries()[0].flip, 0.01);
  EXPECT_EQ(log.entries()[0].ms, 3);
  EXPECT_EQ(log.entries()[1].rmse, 0);
  EXPECT_EQ(log.entries()[1].flip, 0);
}

TEST(AccuracyLogTest, EachSettingOfAMethodHasOneEntry) {
  AccuracyLog log;
  const DrawnPicture exact = grey(0.5f, 100);
  MethodInstance wboit = method("wboit");
  log.add(wboit, grey(0.6f, 110), exact, 3);
  set_parameter(*wboit.method, "weight", "eq9");
  EXPECT_FALSE(log.has(wboit)) << "as it is set now it was not seen";
  log.add(wboit, grey(0.7f, 120), exact, 4);
  EXPECT_EQ(log.entries().size(), 2u);
  log.add(wboit, grey(0.8f, 130), exact, 5);
  ASSERT_EQ(log.entries().size(), 2u) << "measured anew";
  EXPECT_NEAR(log.entries()[1].rmse, 0.3, 1e-6);
  EXPECT_EQ(log.entries()[1].ms, 5);
  EXPECT_TRUE(log.has(wboit));
  EXPECT_TRUE(log.has(method("wboit")));
  EXPECT_FALSE(log.has(method("coloured")));
  EXPECT_EQ(log.entries()[1].settings.at("weight"), "eq9");
}

TEST(AccuracyLogTest, AnotherPictureForgetsAll) {
  AccuracyLog log;
  const DrawnPicture exact = grey(0.5f, 100);
  log.add(method("wboit"), grey(0.6f, 110), exact, 3);
  log.clear();
  EXPECT_TRUE(log.entries().empty());
  EXPECT_FALSE(log.has(method("wboit")));
}

}  // namespace
}  // namespace plume
