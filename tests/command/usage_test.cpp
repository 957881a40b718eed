// Arguments: what the program says when it is asked for help, and what it says when it is asked wrongly.
#include "tests/command/program.h"

namespace plume {
namespace {

class UsageTest : public ProgramTest {
 protected:
  /// Exit code 2, nothing on standard output, nothing drawn, and a message with all of `parts`.
  void expect_refused(const Arguments& arguments, const std::vector<std::string>& parts) {
    const Outcome outcome = run(arguments);
    SCOPED_TRACE(testing::PrintToString(arguments));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("plume: ")) << outcome.err;
    EXPECT_TRUE(says(outcome.err, parts));
    EXPECT_FALSE(fs::exists(at("out")));
  }
  void expect_street_refused(const Arguments& flags, const std::vector<std::string>& parts) {
    Arguments arguments{"compare", "street"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    expect_refused(arguments, parts);
  }
};

TEST_F(UsageTest, HelpNamesEveryCommand) {
  const Outcome outcome = run({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(says(outcome.out, {"open", "compare", "replay", "diff", "check", "list"}));
}

TEST_F(UsageTest, HelpOfACommandNamesItsFlags) {
  const Outcome outcome = run({"compare", "--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(says(outcome.out, {"SCENE", "--methods", "--at", "--frames", "--out", "--size", "--seed",
                                 "--device", "--set", "--shard", "--resume", "--validate", "--json"}));
}

TEST_F(UsageTest, NoArgumentsWithoutADisplayNameTheCommandsThatNeedNone) {
  const Outcome outcome = run({}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
  EXPECT_TRUE(says(outcome.err, {"compare", "replay"}));
  EXPECT_EQ(outcome.out, "");
  const bool has_window = outcome.err.find("a command is missing") == std::string::npos;
  EXPECT_EQ(outcome.exit_code, has_window ? 3 : 2);
}

TEST_F(UsageTest, UnknownCommandNamesTheNearest) {
  expect_refused({"compair", "street"}, {"unknown command `compair`", "did you mean `compare`?"});
  expect_refused({"zzz"}, {"unknown command `zzz`", "`compare`", "`list`"});
}

TEST_F(UsageTest, UnknownFlagNamesTheNearest) {
  expect_street_refused({"--sise", "3x4"}, {"unknown flag `--sise` of compare", "did you mean `--size`?"});
  expect_street_refused({"--sise=3x4"}, {"unknown flag `--sise` of compare", "did you mean `--size`?"});
  expect_refused({"diff", "a", "b", "--max-rmze", "1"},
                 {"unknown flag `--max-rmze`", "did you mean `--max-rmse`?"});
}

TEST_F(UsageTest, FlagBeforeTheCommandIsToldItsPlace) {
  expect_refused({"--json", "list", "methods"}, {"--json stands before list, expected after it"});
}

TEST_F(UsageTest, MissingArgumentIsNamed) {
  expect_refused({"compare"}, {"SCENE"});
  expect_refused({"replay"}, {"SCRIPT"});
  expect_refused({"diff", "a.png"}, {"B"});
  expect_refused({"check"}, {"FILE"});
  expect_refused({"list"}, {"WHAT"});
  expect_street_refused({"--size"}, {"--size"});
  expect_street_refused({"--out", ""}, {"--out: expected the name of a folder"});
}

TEST_F(UsageTest, UnknownMethodNamesTheNearest) {
  expect_street_refused({"--methods", "wboi"}, {"unknown method `wboi`", "did you mean `wboit`?"});
  expect_street_refused({"--methods", "avboit,zzzzzz"}, {"unknown method `zzzzzz`", "`avboit`", "`wboit`"});
}

TEST_F(UsageTest, UnknownSceneNamesTheNearest) {
  expect_refused({"compare", "streat"}, {"unknown scene `streat`", "did you mean `street`?"});
  expect_refused({"compare", "nowhere/street.toml"}, {"there is no file nowhere/street.toml"});
}

TEST_F(UsageTest, UnknownReplayIsRefused) {
  expect_refused({"replay", "nope.toml"}, {"there is no file nope.toml"});
}

TEST_F(UsageTest, UnknownListNamesTheNearest) {
  expect_refused({"list", "scense"}, {"unknown list `scense`", "did you mean `scenes`?"});
}

TEST_F(UsageTest, UnknownSettingNamesTheNearest) {
  expect_street_refused({"--set", "wbot.weight=eq9"}, {"unknown method `wbot`", "did you mean `wboit`?"});
  expect_street_refused({"--set", "wboit.wight=eq9"},
                        {"unknown parameter `wight` of wboit", "did you mean `weight`?"});
}

TEST_F(UsageTest, BadSettingSaysWhatWouldBeRight) {
  expect_street_refused({"--set", "wboit"}, {"--set wboit", "method.parameter=value"});
  expect_street_refused({"--set", "wboit.weight"}, {"method.parameter=value"});
  expect_street_refused({"--set", "wboit.weight=eq99"}, {"`weight` is eq99", "eq7", "eq10"});
  expect_street_refused({"--set", "wboit.depth_scale=0"}, {"`depth_scale` is 0", "from 0.001 to 1000"});
  expect_street_refused({"--set", "wboit.depth_scale=nan"}, {"`depth_scale` is nan", "a number"});
}

TEST_F(UsageTest, SettingThatChangesNothingIsRefused) {
  expect_street_refused({"--methods", "avboit", "--set", "wboit.weight=eq9"},
                        {"--set wboit.weight=eq9", "changes nothing", "not drawn"});
  expect_street_refused({"--set", "wboit.weight=eq9", "--set", "wboit.weight=eq8"},
                        {"--set wboit.weight=eq8", "set already"});
}

TEST_F(UsageTest, BadSizeSaysWhatWouldBeRight) {
  for (const char* size :
       {"640", "640x", "x360", "0x360", "640x0", "-1x1", "640X360", "20000x1", "1.5x2", "640x360x2", ""})
    expect_street_refused({"--size", size}, {std::string("--size ") + size, "WxH", "640x360"});
}

TEST_F(UsageTest, BadShardSaysWhatWouldBeRight) {
  for (const char* shard : {"1", "2/2", "1/0", "-1/2", "a/b", "1/2/3", "/2"})
    expect_street_refused({"--shard", shard}, {std::string("--shard ") + shard, "I/N", "0/4"});
}

TEST_F(UsageTest, BadNumberSaysTheRange) {
  expect_street_refused({"--at", "soon"}, {"--at", "soon", "0 to 20000000"});
  expect_street_refused({"--at", "-1"}, {"--at", "-1", "0 to 20000000"});
  expect_street_refused({"--at", "20000001"}, {"--at", "20000001", "0 to 20000000"});
  expect_street_refused({"--frames", "0"}, {"--frames", "1 to 10000"});
  expect_street_refused({"--seed", "-1"}, {"--seed", "-1", "0 to 4294967295"});
  expect_street_refused({"--seed", "4294967296"}, {"--seed", "4294967296", "0 to 4294967295"});
  expect_street_refused({"--memory-limit", "much"}, {"--memory-limit", "much", "1 to"});
}

TEST_F(UsageTest, FlagsMayStandBeforeTheScene) {
  const Outcome outcome = run({"compare", "--methods", "sorted,wboit", "--set", "wboit.weight=eq8",
                               "quads_mcguire", "--size", "16x9", "--frames", "1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results()["frames"].size(), 2u);
}

TEST_F(UsageTest, FullStandardOutputIsAnError) {
  const std::string command = std::string("'") + PLUME_PROGRAM + "' list methods > /dev/full 2> /dev/null";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
}  // namespace plume
