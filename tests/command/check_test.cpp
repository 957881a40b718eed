// plume check: every mistake of every file at once.
#include "tests/command/program.h"

namespace plume {
namespace {

class CheckTest : public ProgramTest {};

constexpr std::string_view kGood = "name = 'S'\ncamera = {position = [0, 1, 5], target = [0, 1, 0]}\n";
constexpr std::string_view kThreeMistakes =
    "name = 'S'\ncamera = {position = [0, 1, 5], target = [0, 1, 0]}\n"
    "durations_ticks = 3\nexposure = nan\nwind = 'strong'\n";

TEST_F(CheckTest, EveryShippedPresetIsGood) {
  Arguments arguments{"check"};
  for (const auto& entry : fs::recursive_directory_iterator(PLUME_SOURCE_PRESETS))
    if (entry.path().extension() == ".toml") arguments.push_back(entry.path().string());
  ASSERT_GT(arguments.size(), 1u);
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  for (size_t i = 1; i < arguments.size(); ++i) EXPECT_TRUE(says(outcome.out, {arguments[i] + ": ok\n"}));
}

TEST_F(CheckTest, ReportsEveryMistakeWithItsPlace) {
  write("bad.toml", kThreeMistakes);
  const Outcome outcome = run({"check", "bad.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.out, {"bad.toml:3:1: ", "`durations_ticks`", "`duration_ticks`",
                                 "bad.toml:4:", "`exposure`", "bad.toml:5:", "`wind`"}));
  EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 3);
}

TEST_F(CheckTest, ReportsEveryFileAndNotOnlyTheFirst) {
  write("good scene.toml", kGood);
  write("bad.toml", kThreeMistakes);
  const Outcome outcome = run({"check", "nowhere.toml", "bad.toml", "good scene.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(
      says(outcome.out, {"nowhere.toml:1:1: there is no such file", "bad.toml:5:", "good scene.toml: ok"}));
}

TEST_F(CheckTest, TellsProgramsFileLineColumnAndMessage) {
  write("bad.toml", kThreeMistakes);
  write("good.toml", kGood);
  const Outcome outcome = run({"check", "bad.toml", "good.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 2);
  const json mistakes = json::parse(outcome.out);
  ASSERT_EQ(mistakes.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(keys(mistakes[i]), (std::vector<std::string>{"column", "file", "line", "message"}));
    EXPECT_EQ(mistakes[i]["file"], "bad.toml");
    EXPECT_EQ(mistakes[i]["line"], 3 + i);
  }
}

TEST_F(CheckTest, TellsProgramsOfNoMistakeWithAnEmptyList) {
  write("good.toml", kGood);
  const Outcome outcome = run({"check", "good.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(json::parse(outcome.out), json::array());
}

TEST_F(CheckTest, FindsAScriptsUnknownSceneAndMethod) {
  write("script.toml", "name = 'R'\nscene = 'streat'\nticks = [0]\n[[method]]\nid = 'wboit'\n");
  EXPECT_TRUE(says(run({"check", "script.toml"}).out, {"script.toml:2:", "did you mean `street`?"}));
  write("script.toml", "name = 'R'\nscene = 'street'\nticks = [0]\n[[method]]\nid = 'wboi'\n");
  EXPECT_TRUE(says(run({"check", "script.toml"}).out, {"script.toml:5:", "did you mean `wboit`?"}));
}

TEST_F(CheckTest, DrawingABadFileSaysTheSame) {
  write("bad.toml", kThreeMistakes);
  const Outcome outcome = run({"compare", "./bad.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"bad.toml:3:1: ", "bad.toml:4:", "bad.toml:5:"}));
  EXPECT_EQ(outcome.out, "");
}

TEST_F(CheckTest, NamesWithBytesThatAreNotUtf8DoNotBreakJson) {
  const Outcome outcome = run({"check", "caf\xe9.toml", "--json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(json::parse(outcome.out).size(), 1u);
}

}  // namespace
}  // namespace plume
