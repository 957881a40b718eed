#include "sandbox/runs/sensitivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "renderer/methods/methods.h"

namespace plume {
namespace {

using Kind = ParameterChange::Kind;

std::map<std::string, std::vector<std::string>> moves_of(Method& method) {
  std::map<std::string, std::vector<std::string>> moves;
  for (const auto& [name, value] : moved_parameters(method)) moves[name].push_back(value);
  return moves;
}

/// One parameter of each kind.
struct Parameters : Method {
  int slices = 64, layers = 2, off = 0;
  float scale = 0.8f, bias = 0.0f;
  bool rgb = true;
  int filter = 1;

  std::string_view id() const override { return "parameters"; }
  Traits traits() const override { return {}; }
  Needs needs(glm::uvec2, const Transparents&) const override { return {}; }
  void record(const Picture&) override {}
  void probe(const Picture&, const Probe&) const override {}
  void visit(ParameterVisitor& visitor) override {
    static constexpr std::array<std::string_view, 3> kFilters{"nearest", "linear", "cubic"};
    visitor.integer("slices", slices, {.min = 8, .max = 100, .unit = "", .help = ""});
    visitor.integer("layers", layers, {.min = 0, .max = 8, .unit = "", .help = ""});
    visitor.integer("off", off, {.min = 0, .max = 100, .unit = "", .help = ""});
    visitor.number("scale", scale, {.min = 0.0, .max = 1.0, .unit = "", .help = ""});
    visitor.number("bias", bias, {.min = 0.0, .max = 0.1, .unit = "", .help = ""});
    visitor.toggle("rgb", rgb, "");
    visitor.choice("filter", filter, kFilters, "");
  }
};

TEST(SensitivityTest, MovesEachParameterWithinItsLimits) {
  Parameters method;
  const std::map<std::string, std::vector<std::string>> expected{
      {"slices", {"32", "100"}},       {"layers", {"1", "3"}}, {"off", {"1"}},
      {"scale", {"0.4", "1"}},         {"bias", {"0.01"}},     {"rgb", {"false"}},
      {"filter", {"nearest", "cubic"}}};
  EXPECT_EQ(moves_of(method), expected);
}

TEST(SensitivityTest, EveryMoveOfEveryMethodIsOneThatItTakes) {
  for (const std::string& id : method_ids()) {
    const auto unmoved = parameter_values(*make_method(id));
    for (const auto& [name, value] : moved_parameters(*make_method(id))) {
      const auto method = make_method(id);
      ASSERT_NO_THROW(set_parameter(*method, name, value)) << id << " " << name << " " << value;
      auto values = parameter_values(*method);
      EXPECT_NE(values[name], unmoved[name]) << id << " " << name << " " << value;
      values[name] = unmoved[name];
      EXPECT_EQ(values, unmoved);
    }
  }
}

TEST(SensitivityTest, AMethodIsFollowedByItselfWithOneParameterMoved) {
  Replay replay;
  replay.methods = {{.id = "sorted", .settings = {}}, {.id = "wboit", .settings = {{"weight", "eq9"}}}};
  const size_t of_sorted = moved_parameters(*make_method("sorted")).size();
  add_moved_parameters(replay);
  const MethodRun& unmoved = replay.methods.at(1 + of_sorted);
  EXPECT_EQ(unmoved.id, "wboit");
  EXPECT_EQ(unmoved.settings, (std::map<std::string, std::string>{{"weight", "eq9"}}));
  for (size_t i = 2 + of_sorted; i < replay.methods.size(); ++i) {
    const MethodRun& run = replay.methods[i];
    EXPECT_EQ(run.id, "wboit");
    if (run.settings.size() == 1) {
      EXPECT_NE(run.settings.at("weight"), "eq9");
    } else {
      EXPECT_EQ(run.settings.at("weight"), "eq9");
      EXPECT_EQ(run.settings.size(), 2u);
    }
  }
}

/// With a parameter at a value, its error and its own time, give or take 0.25 ms.
FrameResult drawn(const std::string& parameter, int value, double rmse, double ms, double reach = 0.25) {
  FrameResult frame{.scene = "street", .method = "m"};
  frame.settings = {{"a", 1}, {"b", 1}, {"c", 1}, {"d", 1}, {"e", 1}};
  frame.settings[parameter] = value;
  frame.error = ErrorSummary{.rmse = rmse};
  frame.transparency_ms = {.median = ms, .low = ms - reach, .high = ms + reach, .samples = 9};
  return frame;
}

TEST(SensitivityTest, WhatIsFreeComesFirstThenWhatBuysMostPerMillisecond) {
  const Results results{.frames = {drawn("a", 1, 0.100, 10), drawn("a", 0, 0.100, 10.2),  // nothing
                                   drawn("b", 0, 0.120, 12), drawn("b", 2, 0.080, 14),    // worse; 0.005 a ms
                                   drawn("c", 2, 0.090, 11), drawn("d", 2, 0.095, 8),     // 0.01 a ms; free
                                   drawn("e", 0, 0.110, 5),
                                   drawn("e", 2, 0.100, 7)}};  // saves at 0.002; at 0
  const auto changes = best_first(parameter_changes(results));
  std::vector<std::string> order;
  for (const ParameterChange& c : changes)
    order.push_back(c.parameter + " " + std::string(kParameterChangeKinds[size_t(c.kind())]));
  EXPECT_EQ(order, (std::vector<std::string>{"d free", "c buys", "b buys", "e saves", "e saves", "b worse",
                                             "a nothing"}));
  EXPECT_NEAR(changes[1].accuracy_per_ms().value(), 0.01, 1e-12);
  EXPECT_NEAR(changes[2].accuracy_per_ms().value(), 0.005, 1e-12);
  EXPECT_EQ(changes[3].accuracy_per_ms(), 0.0);
  EXPECT_NEAR(changes[4].accuracy_per_ms().value(), 0.002, 1e-12);
  EXPECT_EQ(changes[0].accuracy_per_ms(), std::nullopt);
  for (size_t i = 0; i < 5; ++i) EXPECT_TRUE(changes[i].sure()) << i;

  const nlohmann::json told = to_json(changes);
  EXPECT_EQ(told[1]["from"], 1);
  EXPECT_EQ(told[1]["to"], 2);
  EXPECT_EQ(told[1]["error_before"], 0.1);
  EXPECT_EQ(told[1]["ms_after"], 11.0);
  EXPECT_EQ(told[1]["sure"], true);
  const std::string table = to_table(parameter_changes(results));
  EXPECT_NE(table.find("c buys most accuracy per millisecond"), std::string::npos) << table;
  EXPECT_NE(table.find("gains neither: b=0"), std::string::npos) << table;
  EXPECT_NE(table.find("no difference to be told: a=0"), std::string::npos) << table;
}

TEST(SensitivityTest, NothingIsSureWhereTimesMeet) {
  const auto changes = best_first(parameter_changes(
      {.frames = {drawn("a", 1, 0.1, 10, 3), drawn("a", 2, 0.08, 12, 3), drawn("b", 2, 0.08, 9, 3)}}));
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].kind(), Kind::kFree);
  EXPECT_EQ(changes[1].kind(), Kind::kBuys);
  EXPECT_FALSE(changes[0].sure());
  EXPECT_FALSE(changes[1].sure());
  EXPECT_NE(to_table(changes).find("no parameter buys accuracy for certain"), std::string::npos);
}

TEST(SensitivityTest, FloatNoiseIsNoDifferenceOfError) {
  const auto changes = parameter_changes(
      {.frames = {drawn("a", 1, 0.1, 10), drawn("a", 2, 0.09995, 10), drawn("b", 2, 0.09995, 8)}});
  EXPECT_EQ(changes[0].kind(), Kind::kNothing);
  EXPECT_EQ(changes[1].kind(), Kind::kSaves);
}

TEST(SensitivityTest, MomentsAndMethodsDoNotMix) {
  Results results{.frames = {drawn("a", 1, 0.1, 10), drawn("a", 2, 0.05, 12), drawn("a", 1, 0.3, 10),
                             drawn("a", 2, 0.2, 12)}};
  results.frames[2].tick = results.frames[3].tick = 7;
  const auto changes = parameter_changes(results);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NEAR(changes[0].error_lost(), 0.05, 1e-12);
  EXPECT_NEAR(changes[1].error_lost(), 0.1, 1e-12);
}

}  // namespace
}  // namespace plume
