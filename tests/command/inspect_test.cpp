// plume inspect: a view of one frame as numbers and as a picture.
#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class InspectTest : public ProgramTest {
 protected:
  Outcome inspect(Arguments more) {
    Arguments all{"inspect", "street", "--size", "96x54"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(InspectTest, ListsTheViewsOfAMethodAsItIsSet) {
  const Outcome avboit = run({"inspect", "--list", "--json"});
  ASSERT_EQ(avboit.exit_code, 0) << avboit.err;
  std::vector<std::string> ids;
  for (const json& view : json::parse(avboit.out)) ids.push_back(view.at("id"));
  EXPECT_EQ(ids, (std::vector<std::string>{"flip", "difference", "overdraw", "shaded", "zero_transmittance",
                                           "culling_depth", "first_overflow", "occupancy", "occupied",
                                           "extinction", "integral", "slice_map"}));
  const Outcome off = run({"inspect", "--list", "--set", "avboit.zero_depth=off"});
  EXPECT_EQ(off.out.find("culling_depth"), std::string::npos);
  EXPECT_NE(off.out.find("zero_transmittance"), std::string::npos);
  EXPECT_EQ(json::parse(run({"inspect", "--list", "--json", "--method", "wboit"}).out).size(), 4u);
}

TEST_F(InspectTest, WritesTheNumbersItTellsOf) {
  const Outcome outcome = inspect({"--view", "overdraw", "--validate", "--out", "f.exr", "--out", "f.png"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  const Image numbers = read_exr(at("f.exr"));
  double sum = 0, most = 0;
  size_t pixels = 0;
  for (const glm::vec3& pixel : numbers.pixels) {
    if (std::isnan(pixel.r)) continue;
    ++pixels;
    sum += double(pixel.r);
    most = std::max(most, double(pixel.r));
  }
  EXPECT_GT(sum, 1000);
  EXPECT_EQ(told.at("sum"), sum);
  EXPECT_EQ(told.at("most"), most);
  EXPECT_EQ(told.at("pixels"), pixels);
  EXPECT_FALSE(told.at("slices").empty());
  const DisplayImage picture = read_png(at("f.png"));
  EXPECT_EQ(picture.width, 96);
  EXPECT_EQ(picture.height, 54);
}

TEST_F(InspectTest, OnlyTheReferenceHasNoError) {
  const Outcome none = inspect({"--view", "difference", "--method", "reference"});
  ASSERT_EQ(none.exit_code, 0) << none.err;
  EXPECT_EQ(json::parse(none.out).at("most"), 0.0);
  const Outcome some = inspect({"--view", "flip", "--method", "wboit"});
  ASSERT_EQ(some.exit_code, 0) << some.err;
  EXPECT_GT(json::parse(some.out).at("most"), 0.02);
}

TEST_F(InspectTest, RefusesWhatIsNotThere) {
  const auto refuses = [&](const Arguments& arguments, const std::string& with) {
    const Outcome outcome = inspect(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(with), std::string::npos) << outcome.err;
  };
  refuses({"--view", "overdraft"}, "did you mean `overdraw`?");
  refuses({"--view", "culling_depth", "--set", "avboit.zero_depth=off"}, "has no such view");
  refuses({"--view", "extinction", "--slice", "128"}, "expected 0 to 127");
  refuses({"--view", "overdraw", "--slice", "1"}, "has no slices");
  refuses({"--view", "overdraw", "--out", "f.jpg"}, "expected a name that ends in .png");
  refuses({"--view", "overdraw", "--range", "2", "2"}, "--range 2 2");
  refuses({}, "plume inspect --list");
}

}  // namespace
}  // namespace plume
