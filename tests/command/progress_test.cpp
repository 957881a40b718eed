// How far a run is: one line that is rewritten on a terminal, plain lines in a pipe.
#include <regex>

#include "tests/command/program.h"

namespace plume {
namespace {

class ProgressTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("script.toml",
          "name = 'R'\nscene = 'three_cards'\nsize = [32, 18]\nframes = 1\nwarmup = 0\nticks = [0, 1, 2, 3]\n"
          "[[method]]\nid = 'sorted'\n");
  }
  /// Gives what the program prints on a terminal. script(1) is part of every Debian and gives it one.
  std::string on_a_terminal(const std::string& script) {
    const std::string command = "cd '" + at("").string() +
                                "' && PLUME_CACHE=off script -qec \"'" PLUME_PROGRAM "' replay " + script +
                                " > table\" /dev/null < /dev/null > terminal";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return read("terminal");
  }
  static bool has_terminals() {
    return std::system("script -qec true /dev/null < /dev/null > /dev/null 2>&1") == 0;
  }
  /// Less the notes, which a busy machine adds.
  static testing::AssertionResult matches(const std::string& all, const std::string& pattern) {
    const std::string text = std::regex_replace(all, std::regex("plume: note: [^\n]*\n"), "");
    if (std::regex_match(text, std::regex(pattern))) return testing::AssertionSuccess();
    return testing::AssertionFailure() << text << " is not " << pattern;
  }
};

TEST_F(ProgressTest, IsPlainLinesInAPipe) {
  EXPECT_TRUE(matches(run({"replay", "script.toml"}).err,
                      "\\[1/4\\] three_cards tick 0 · \\d+s left\n\\[2/4\\] three_cards tick 1 · \\d+s left\n"
                      "\\[3/4\\] three_cards tick 2 · \\d+s left\n"
                      "\\[4/4\\] three_cards tick 3 · done in \\d+s\n"));
}

TEST_F(ProgressTest, IsOneLineOnATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal: /dev/pts is not mounted";
  EXPECT_TRUE(matches(on_a_terminal("script.toml"),
                      "(\r\x1b\\[K\\[[123]/4\\] three_cards tick [012] · \\d+s left){3}"
                      "\r\x1b\\[K\\[4/4\\] three_cards tick 3 · done in \\d+s\r\n"));
}

TEST_F(ProgressTest, TellsOnATerminalHowMuchOfAMomentIsDrawn) {
  if (!has_terminals()) GTEST_SKIP() << "no pseudo-terminal: /dev/pts is not mounted";
  write("long.toml",
        "name = 'L'\nscene = 'three_cards'\nsize = [32, 18]\nframes = 200\nwarmup = 0\nticks = [0]\n"
        "[[method]]\nid = 'sorted'\n");
  EXPECT_TRUE(matches(on_a_terminal("long.toml"),
                      "(\r\x1b\\[K\\[0/1\\] three_cards tick 0, \\d+ % of it · [^\r]* left)+"
                      "\r\x1b\\[K\\[1/1\\] three_cards tick 0 · done in \\d+s\r\n"));
}

TEST_F(ProgressTest, TellsWhatIsLeftFromWhatWasDrawnNow) {
  ASSERT_EQ(run({"replay", "script.toml", "--shard", "0/2"}).exit_code, 0);
  EXPECT_TRUE(matches(run({"replay", "script.toml", "--resume"}).err,
                      "\\[2/4\\] kept from an earlier run\n\\[3/4\\] three_cards tick 1 · \\d+s left\n"
                      "\\[4/4\\] three_cards tick 3 · done in \\d+s\n"));
  EXPECT_TRUE(matches(run({"replay", "script.toml", "--resume"}).err,
                      "\\[4/4\\] kept from an earlier run · done in \\d+s\n"));
}

}  // namespace
}  // namespace plume
