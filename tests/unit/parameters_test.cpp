#include "renderer/parameters.h"

#include <gtest/gtest.h>

#include "renderer/methods/method.h"

namespace plume {
namespace {

class Example : public Method {
 public:
  float bias = 0.1f;
  int slices = 64;
  bool fine = true;
  int warp = 1;

  std::string_view id() const override { return "example"; }
  Traits traits() const override { return {}; }
  Needs needs(glm::uvec2, const Transparents&) const override { return {}; }
  void record(const Picture&) override {}
  void probe(const Picture&, const Probe&) const override {}
  void visit(ParameterVisitor& visitor) override {
    static constexpr std::string_view kWarps[] = {"linear", "log", "sqrt"};
    visitor.number("bias_m", bias, {-1.5, 1.5, "m", "Trades leaks for detachment."});
    visitor.integer("slices", slices, {8, 256, "", "Trades memory for accuracy."});
    visitor.toggle("fine", fine, "Trades time for accuracy.");
    visitor.choice("warp", warp, kWarps, "Where slices are dense.");
  }
};

std::string error_of(std::string_view name, std::string_view value) {
  Example method;
  try {
    set_parameter(method, name, value);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Parameters, AreSetFromText) {
  Example method;
  set_parameter(method, "bias_m", "-0.25");
  set_parameter(method, "slices", "256");
  set_parameter(method, "fine", "false");
  set_parameter(method, "warp", "sqrt");
  EXPECT_EQ(method.bias, -0.25f);
  EXPECT_EQ(method.slices, 256);
  EXPECT_FALSE(method.fine);
  EXPECT_EQ(method.warp, 2);
}

TEST(Parameters, AreListedWithTypeRangeUnitAndValue) {
  Example method;
  const nlohmann::json list = parameter_list(method);
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0], nlohmann::json::parse(
                         R"({"name": "bias_m", "type": "number", "min": -1.5, "max": 1.5, "unit": "m",
                                               "help": "Trades leaks for detachment.", "value": 0.1})"));
  EXPECT_EQ(list[1]["type"], "integer");
  EXPECT_EQ(list[1].at("max").dump(), "256");
  EXPECT_EQ(list[2]["value"], true);
  EXPECT_EQ(list[3]["options"], nlohmann::json({"linear", "log", "sqrt"}));
  EXPECT_EQ(list[3]["value"], "log");
}

TEST(Parameters, ValuesReadBackAsTheyWereSet) {
  Example method;
  set_parameter(method, "bias_m", "0.7");
  EXPECT_EQ(parameter_values(method).dump(), R"({"bias_m":0.7,"fine":true,"slices":64,"warp":"log"})");
}

TEST(Parameters, ErrorsSayWhatWouldBeRight) {
  EXPECT_EQ(error_of("bias_m", "2"), "`bias_m` is 2, expected a number from -1.5 to 1.5 m");
  EXPECT_EQ(error_of("bias_m", "nan"), "`bias_m` is nan, expected a number from -1.5 to 1.5 m");
  EXPECT_EQ(error_of("bias_m", "1 m"), "`bias_m` is 1 m, expected a number from -1.5 to 1.5 m");
  EXPECT_EQ(error_of("slices", "8.5"), "`slices` is 8.5, expected a whole number from 8 to 256");
  EXPECT_EQ(error_of("slices", "7"), "`slices` is 7, expected a whole number from 8 to 256");
  EXPECT_EQ(error_of("slices", "99999999999999999999"),
            "`slices` is 99999999999999999999, expected a whole number from 8 to 256");
  EXPECT_EQ(error_of("fine", "yes"), "`fine` is yes, expected true or false");
  EXPECT_EQ(error_of("warp", "cubic"), "`warp` is cubic, expected one of linear, log, sqrt");
  EXPECT_EQ(error_of("slcies", "8"), "unknown parameter `slcies` of example, did you mean `slices`?");
  EXPECT_EQ(error_of("x", "8"),
            "unknown parameter `x` of example, expected one of `bias_m`, `slices`, `fine`, `warp`");
}

TEST(Parameters, AWrongValueChangesNothing) {
  Example method;
  EXPECT_THROW(set_parameter(method, "slices", "1000"), ParameterError);
  EXPECT_EQ(method.slices, 64);
}

TEST(Nearest, CountsASwapOfNeighboursAsOneEdit) {
  // Two replacements would be too many for words this short.
  EXPECT_EQ(nearest("ot", std::vector<std::string>{"to"}), "to");
  EXPECT_EQ(nearest("ax", std::vector<std::string>{"to"}), "");
}

TEST(Nearest, IsEmptyWhenTheBestIsAPoorMatch) {
  const std::vector<std::string> words = {"wboit", "avboit", "reference"};
  EXPECT_EQ(nearest("avbot", words), "avboit");
  EXPECT_EQ(nearest("refrenc", words), "reference");
  EXPECT_EQ(nearest("depth", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest("wboit", std::vector<std::string>{}), "");
  EXPECT_EQ(nearest(std::string(1 << 22, 'w'), words), "");
}

TEST(Nearest, TakesTheFirstOfEquals) {
  EXPECT_EQ(nearest("cat", std::vector<std::string>{"bat", "rat"}), "bat");
}

}  // namespace
}  // namespace plume
