// plume probe: one pixel, its fragments and what methods believe of it.
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
