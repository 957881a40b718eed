// Particles that nothing can be drawn of: a picture comes without them, and it is said whose they are. What
// files can ask for is finite; what falls for a quarter of an hour is farther away than anything can be
// drawn.
#include "tests/command/far_particles.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class BadParticlesTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("presets/effects/far.toml", kFarEffect);
    write("presets/scenes/far.toml", kFarScene);
  }
  Outcome compare(const char* tick) {
    return run(compare_quickly("far", {"--methods", "wboit,avboit", "--at", tick}),
               {{"PLUME_PRESETS", at("presets")}});
  }
};

TEST_F(BadParticlesTest, AreCountedAndToldOfWithTheirEmitter) {
  const Outcome outcome = compare(kTooFarTick);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json expected{
      {"count", 4}, {"first", {{"effect", "far"}, {"instance", "it"}, {"emitter", "runaway"}, {"birth", 0}}}};
  ASSERT_EQ(results()["frames"].size(), 2u);
  for (const json& frame : frames()) {
    EXPECT_EQ(frame["bad_particles"], expected);
    EXPECT_TRUE(says(frame["shortfalls"].back(), {"4 particles are not finite", "`runaway` in far.toml",
                                                  "what it inherits of its parent, gravity"}));
  }
  EXPECT_TRUE(says(outcome.err, {"far tick 42000: 4 particles are not finite", "far (it) / runaway #0",
                                 "2 of 2 pictures"}));
  EXPECT_TRUE(says(outcome.out, {"4 bad particles"}));
  EXPECT_TRUE(says(read("out/report.html"), {"4 particles are not finite"}));
}

TEST_F(BadParticlesTest, AreNotToldOfWhereThereAreNone) {
  const Outcome outcome = compare("10");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const json& frame : frames())
    EXPECT_EQ(frame["bad_particles"], (json{{"count", 0}, {"first", nullptr}}));
  EXPECT_EQ(outcome.err.find("not finite"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out.find("bad particles"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace plume
