// What --help prints.
#include <sstream>

#include "tests/command/program.h"

namespace plume {
namespace {

class HelpTest : public ProgramTest, public testing::WithParamInterface<const char*> {};

INSTANTIATE_TEST_SUITE_P(Commands, HelpTest,
                         testing::Values("open", "compare", "replay", "probe", "inspect", "merge", "diff",
                                         "check", "list", "stress"),
                         [](const auto& command) { return std::string(command.param); });

TEST_P(HelpTest, NamesValuesAndFitsATerminal) {
  const Outcome outcome = run({GetParam(), "--help"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* type : {"TEXT", "UINT", "INT in", "FLOAT", "[["})
    EXPECT_EQ(outcome.out.find(type), std::string::npos) << type << " in\n" << outcome.out;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(ProgramTest, HelpTellsLimitsAndWhatIsWithout) {
  const std::string help = run({"compare", "--help"}).out;
  EXPECT_NE(help.find("--at TICK                 tick, 1/60 s; otherwise the scene's own (0 to 20000000)\n"),
            std::string::npos)
      << help;
  EXPECT_NE(help.find("--frames N                timed repetitions of each method (1 to 10000) [5]\n"),
            std::string::npos)
      << help;
}

}  // namespace
}  // namespace plume
