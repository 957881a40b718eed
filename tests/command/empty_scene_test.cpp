// A scene without effects and without anything transparent, in every command that draws.
#include "tests/command/program.h"

namespace plume {
namespace {

class EmptySceneTest : public ProgramTest {};

TEST_F(EmptySceneTest, IsComparedWithoutErrorAndWithoutInstances) {
  const Outcome outcome =
      run(compare_quickly("empty", {"--methods", "sorted,wboit,moments,avboit", "--validate"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 4u);
  for (const json& frame : all["frames"]) EXPECT_EQ(frame["error"]["rmse"], 0.0) << frame["method"];
  EXPECT_TRUE(all["moments"][0]["demand"]["instances"].empty());
}

TEST_F(EmptySceneTest, IsReplayedAndProbed) {
  write("empty.toml",
        "name = 'E'\nscene = 'empty'\nsize = [32, 18]\nframes = 1\nwarmup = 0\nticks = [0, 600]\n"
        "[[method]]\nid = 'avboit'\n");
  const Outcome replayed = run({"replay", "./empty.toml"});
  ASSERT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_EQ(results()["frames"].size(), 2u);

  const Outcome probed = run({"probe", "empty", "--size", "32x18", "--pixel", "16,9", "--depths", "5",
                              "--methods", "reference,moments,avboit", "--validate"});
  ASSERT_EQ(probed.exit_code, 0) << probed.err;
  const json told = json::parse(probed.out);
  EXPECT_TRUE(told.at("fragments").empty());
  for (const json& method : told.at("methods"))
    for (const json& through : method.at("transmittance"))
      EXPECT_EQ(through, json::parse("[1.0, 1.0, 1.0]")) << method["method"];
}

}  // namespace
}  // namespace plume
