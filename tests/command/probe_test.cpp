// plume probe: one pixel, its fragments and what methods believe of it.
#include <sstream>

#include "renderer/methods/methods.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class ProbeTest : public ProgramTest {
 protected:
  Arguments probe_street(Arguments more = {}) {
    Arguments all{"probe", "street", "--size", "96x54", "--pixel", "40,30", "--depths", "33"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(ProbeTest, TellsTheFragmentsAndEveryMethodsTransmittance) {
  const Outcome outcome = run(probe_street({"--validate"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  ASSERT_GT(told.at("fragments").size(), 3u);
  EXPECT_EQ(told.at("depths_m").size(), 33u);
  std::vector<std::string> methods;
  for (const json& method : told.at("methods")) {
    methods.push_back(method.at("method"));
    if (method.at("status") == "ok") {
      EXPECT_EQ(method.at("transmittance").size(), 33u) << methods.back();
    }
  }
  EXPECT_EQ(methods, method_ids());

  // The reference's curve is the product of the fragments that are listed.
  for (size_t i = 0; i < 33; ++i) {
    double through = 1.0;
    for (const json& fragment : told["fragments"])
      if (fragment.at("depth_m") < told["depths_m"][i])
        through *= fragment.at("transmittance")[0].get<double>();
    EXPECT_NEAR(told["methods"][0]["transmittance"][i][0].get<double>(), through, 1e-5);
  }
}

TEST_F(ProbeTest, TellsWhoseFragmentsAreAndWhatMethodsWeighThemBy) {
  const Outcome outcome = run(probe_street({"--methods", "reference,avboit"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json told = json::parse(outcome.out);
  const json& fragments = told.at("fragments");
  for (const json& fragment : fragments) {
    if (fragment.contains("pane")) {
      EXPECT_LT(fragment["pane"], 3);
    } else {
      EXPECT_FALSE(fragment.at("effect").get<std::string>().empty());
      EXPECT_FALSE(fragment.at("emitter").get<std::string>().empty());
      EXPECT_TRUE(fragment.at("particle").is_number_unsigned());
    }
    EXPECT_GE(fragment.at("alpha"), 0.0);
  }
  EXPECT_TRUE(told.at("opaque_depth_m").is_number());
  for (const json& method : told.at("methods")) {
    ASSERT_EQ(method.at("weights").size(), fragments.size());
    ASSERT_EQ(method.at("weight_errors").size(), fragments.size());
  }
  for (size_t i = 0; i < fragments.size(); ++i)
    EXPECT_NEAR(told["methods"][0]["weights"][i][0].get<double>(), fragments[i]["weight"][0].get<double>(),
                1e-5);
  const json& marks = told["methods"][1].at("marks");
  EXPECT_GT(marks.at("slices_m").size(), 4u);
  EXPECT_TRUE(marks.contains("zero_transmittance_m"));
  EXPECT_TRUE(marks.contains("overflow_m"));
}

TEST_F(ProbeTest, WritesOneCsvLineForEachFragment) {
  const Outcome outcome = run({"probe", "three_cards", "--size", "96x54", "--pixel", "48,27",
                               "--csv-fragments", "--methods", "avboit"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("depth_m,pane,effect,instance,emitter,particle,color_r"));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1 + 15);
  std::istringstream lines(outcome.out);
  std::string header, line;
  std::getline(lines, header);
  while (std::getline(lines, line))
    EXPECT_EQ(std::ranges::count(line, ','), std::ranges::count(header, ',')) << line;
  EXPECT_EQ(run({"probe", "three_cards", "--pixel", "1,1", "--csv", "--csv-fragments"}).exit_code, 2);
}

TEST_F(ProbeTest, WritesOneCsvLineForEachDepth) {
  const Outcome outcome = run(probe_street({"--csv", "--methods", "reference,avboit", "--range", "2", "20"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(
      outcome.out.starts_with("depth_m,reference_r,reference_g,reference_b,avboit_r,avboit_g,avboit_b\n2,"));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 34);
}

TEST_F(ProbeTest, RefusesWhatIsOutsideThePicture) {
  const Outcome outcome = run({"probe", "street", "--size", "96x54", "--pixel", "96,3"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the picture ends at 95,53"), std::string::npos) << outcome.err;
  EXPECT_EQ(run({"probe", "street", "--pixel", "1,2", "--range", "5", "2"}).exit_code, 2);
  EXPECT_EQ(run({"probe", "street"}).exit_code, 2);
}

}  // namespace
}  // namespace plume
