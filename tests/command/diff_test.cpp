// plume diff: metrics of two pictures, tolerances, and pictures that are none.
#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class DiffTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write_png(at("a.png"), ramp(40, 30, 0));
    write_png(at("b.png"), ramp(40, 30, 60));
    write_png(at("small.png"), ramp(20, 30, 0));
    write_exr(at("a.exr"), to_linear(ramp(40, 30, 0)));
    write("not a picture.png", "neither");
    write("cut.png", read("a.png").substr(0, read("a.png").size() / 2));
    write("cut.exr", read("a.exr").substr(0, read("a.exr").size() / 2));
  }
  static DisplayImage ramp(int width, int height, int more_red) {
    DisplayImage image;
    image.width = width;
    image.height = height;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        image.pixels.push_back({static_cast<uint8_t>(x == 7 && y == 5 ? 100 + 2 * more_red : 100 + more_red),
                                static_cast<uint8_t>(3 * x), static_cast<uint8_t>(5 * y)});
    return image;
  }
  void expect_refused(const Arguments& arguments, const std::vector<std::string>& parts) {
    Arguments all{"diff"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    SCOPED_TRACE(testing::PrintToString(all));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(says(outcome.err, parts));
  }
};

TEST_F(DiffTest, IdenticalPicturesDifferByNothing) {
  const Outcome outcome = run({"diff", "a.png", "a.png"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(json::parse(outcome.out),
            json::parse(R"({"rmse": 0.0, "max": 0.0, "max_at": [0, 0], "psnr_db": null,
                                                      "ssim": 1.0, "flip": 0.0, "exceeded": []})"));
}

TEST_F(DiffTest, IdenticalPicturesMeetTheStrictestTolerances) {
  EXPECT_EQ(run({"diff", "a.png", "a.png", "--max-rmse", "0", "--max-abs", "0", "--max-flip", "0",
                 "--min-psnr", "200", "--min-ssim", "1"})
                .exit_code,
            0);
}

TEST_F(DiffTest, DifferentPicturesAreMeasuredAndAllowed) {
  const Outcome outcome = run({"diff", "a.png", "b.png"});
  EXPECT_EQ(outcome.exit_code, 0);
  const json metrics = json::parse(outcome.out);
  EXPECT_GT(metrics["rmse"], 0.0);
  EXPECT_GT(metrics["max"], metrics["rmse"]);
  EXPECT_EQ(metrics["max_at"], json::parse("[7, 5]"));
  EXPECT_GT(metrics["psnr_db"], 5.0);
  EXPECT_LT(metrics["psnr_db"], 30.0);
  EXPECT_LT(metrics["ssim"], 1.0);
  EXPECT_GT(metrics["flip"], 0.0);
  EXPECT_EQ(metrics["exceeded"], json::array());
}

TEST_F(DiffTest, EachToleranceThatIsExceededIsNamed) {
  const json metrics = json::parse(run({"diff", "a.png", "b.png"}).out);
  const struct {
    const char *flag, *metric;
    double slack;  // towards what is allowed
  } tolerances[] = {{"--max-rmse", "rmse", 1e-3},
                    {"--max-abs", "max", 1e-3},
                    {"--max-flip", "flip", 1e-3},
                    {"--min-psnr", "psnr_db", -1e-3},
                    {"--min-ssim", "ssim", -1e-3}};
  for (const auto& [flag, metric, slack] : tolerances) {
    SCOPED_TRACE(flag);
    const double value = metrics[metric];
    EXPECT_EQ(run({"diff", "a.png", "b.png", flag, std::to_string(value + slack)}).exit_code, 0);
    const Outcome over = run({"diff", "a.png", "b.png", flag, std::to_string(value - slack)});
    EXPECT_EQ(over.exit_code, 1);
    const json exceeded = json::parse(over.out)["exceeded"];
    ASSERT_EQ(exceeded.size(), 1u);
    EXPECT_TRUE(exceeded[0].get<std::string>().starts_with(metric));
  }
}

TEST_F(DiffTest, EveryToleranceIsChecked) {
  const Outcome outcome = run({"diff", "a.png", "b.png", "--max-rmse", "0", "--max-abs", "0", "--max-flip",
                               "0", "--min-psnr", "100", "--min-ssim", "1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(json::parse(outcome.out)["exceeded"].size(), 5u);
}

TEST_F(DiffTest, PngMatchesTheExrItCameFrom) {
  const Outcome outcome = run({"diff", "a.png", "a.exr", "--max-rmse", "1e-6"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
  EXPECT_EQ(json::parse(outcome.out)["flip"], 0.0);
  EXPECT_EQ(run({"diff", "b.png", "a.exr", "--max-rmse", "1e-6"}).exit_code, 1);
}

TEST_F(DiffTest, ErrorMapIsAPictureOfTheSameSize) {
  ASSERT_EQ(run({"diff", "a.png", "b.png", "--error-map", "the map.png"}).exit_code, 0);
  const DisplayImage map = read_png(at("the map.png"));
  EXPECT_EQ(map.width, 40);
  EXPECT_EQ(map.height, 30);
  ASSERT_EQ(run({"diff", "a.png", "a.png", "--error-map", "none.png"}).exit_code, 0);
  EXPECT_NE(read("the map.png"), read("none.png"));
}

TEST_F(DiffTest, ErrorMapThatCannotBeWrittenIsNamed) {
  expect_refused({"a.png", "b.png", "--error-map", "nowhere/map.png"},
                 {"nowhere/map.png: No such file or directory"});
}

TEST_F(DiffTest, SizesMustBeEqual) {
  expect_refused({"a.png", "small.png"}, {"a.png is 40x30", "small.png is 20x30"});
}

TEST_F(DiffTest, UnreadablePicturesAreNamedWithTheReason) {
  expect_refused({"a.png", "none.png"}, {"none.png: No such file or directory"});
  expect_refused({"none.exr", "a.png"}, {"none.exr: No such file or directory"});
  expect_refused({"a.png", "not a picture.png"}, {"not a picture.png: not a PNG"});
  expect_refused({"cut.png", "a.png"}, {"cut.png: "});
  expect_refused({"a.png", "cut.exr"}, {"cut.exr: "});
}

TEST_F(DiffTest, ToleranceMustBeANumber) {
  for (const char* text : {"x", "nan", "inf", ""})
    expect_refused({"a.png", "b.png", "--max-rmse", text}, {"--max-rmse", "a number such as 0.01"});
}

}  // namespace
}  // namespace plume
