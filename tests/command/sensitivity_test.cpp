// plume compare --sensitivity: what each parameter buys.
#include "sandbox/runs/sensitivity.h"

#include <set>

#include "renderer/methods/methods.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class SensitivityRunTest : public ProgramTest {};

TEST_F(SensitivityRunTest, MovesEveryParameterAndTellsWhatItDid) {
  const Outcome outcome = run({"compare", "quads_mcguire", "--size", "16x9", "--frames", "4", "--methods",
                               "wboit", "--set", "wboit.weight=eq9", "--sensitivity"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.out, {"wboit on quads_mcguire tick 0, RMSE "}));
  const json all = results();
  const auto method = make_method("wboit");
  set_parameter(*method, "weight", "eq9");
  std::set<std::pair<std::string, std::string>> expected, found;
  for (const auto& move : moved_parameters(*method)) expected.insert(move);
  for (const json& change : all["sensitivity"]) {
    SCOPED_TRACE(change.dump());
    const json& to = change["to"];
    found.emplace(change["parameter"], to.is_string() ? to.get<std::string>() : to.dump());
    EXPECT_EQ(change["method"], "wboit");
    EXPECT_EQ(change["error_before"], all["frames"][0]["error"]["rmse"]);
    EXPECT_EQ(change["ms_before"], all["frames"][0]["transparency_ms"]);
    if (change["parameter"] == "weight") {
      EXPECT_EQ(change["from"], "eq9");
    }
  }
  EXPECT_EQ(all["sensitivity"].size(), expected.size());
  for (const auto& [name, value] : expected)
    EXPECT_TRUE(std::ranges::any_of(found, [&](const auto& f) { return f.first == name; })) << name << value;
  EXPECT_TRUE(pictures().empty());
}

TEST_F(SensitivityRunTest, NeedsRepetitionsEnough) {
  const Outcome outcome = run(compare_quickly("quads_mcguire", {"--methods", "wboit", "--sensitivity"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"expected --frames 4 or more"}));
}

}  // namespace
}  // namespace plume
