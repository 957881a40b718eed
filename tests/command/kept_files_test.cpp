// What the program keeps in the user's folders, and what it does when something is wrong with it.
#include <sys/stat.h>

#include <functional>

#include "tests/command/program.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

class KeptPipelinesTest : public ProgramTest {
 protected:
  Outcome draw(const Environment& environment = {}) {
    fs::remove_all(at("out"));
    return run(compare_quickly("quads_mcguire", {"--methods", "wboit"}), environment);
  }
  fs::path file() const { return "cache/" + files("cache").at(0); }
};

TEST_F(KeptPipelinesTest, AreReadAgainAndNotWrittenAgain) {
  ASSERT_EQ(draw().exit_code, 0);
  ASSERT_EQ(files("cache").size(), 1u);
  const auto written = fs::last_write_time(at(file()));
  const Outcome again = draw();
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.err.find("pipelines"), std::string::npos) << again.err;
  EXPECT_EQ(fs::last_write_time(at(file())), written);
}

TEST_F(KeptPipelinesTest, ThatAreDamagedAreToldOfAndMadeAnew) {
  ASSERT_EQ(draw().exit_code, 0);
  const std::string whole = read(file());
  const auto pictures_before = pictures();
  std::string flipped = whole, foreign = whole;
  flipped.back() ^= 1;
  foreign[30] ^= 1;
  std::vector<std::string> all{"x",     whole.substr(0, whole.size() / 2), whole + "more", flipped,
                               foreign, std::string(100'000, '\xff')};
  for (size_t length = 2; every(2) == 1 && length < whole.size(); length += 1 + length / 4)
    all.push_back(whole.substr(0, length));
  for (const std::string& broken : all) {
    write(file(), broken);
    const Outcome outcome = draw();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(says(outcome.err, {"note: ", file().filename().string(), "pipelines are made anew"}));
    EXPECT_EQ(read(file()), whole);
    EXPECT_EQ(pictures(), pictures_before);
  }
}

TEST_F(KeptPipelinesTest, ThatAreNoFileAreMadeAnew) {
  ASSERT_EQ(draw().exit_code, 0);
  const fs::path name = file(), kept = at(name);
  const std::string whole = read(name);
  const auto put = [&](const std::function<void()>& make) {
    fs::remove_all(kept);
    make();
    const Outcome outcome = draw();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  put([&] { write(name, ""); });
  EXPECT_EQ(read(name), whole);
  put([&] { fs::create_symlink("nowhere", kept); });
  EXPECT_EQ(read(name), whole);
  put([&] { fs::create_symlink("/dev/zero", kept); });
  EXPECT_EQ(read(name), whole);
  put([&] { ASSERT_EQ(mkfifo(kept.c_str(), 0666), 0); });
  EXPECT_EQ(read(name), whole);
  put([&] { write(name, whole), fs::permissions(kept, fs::perms::none); });
  if (geteuid() != 0) {  // who may read everything reads this too
    EXPECT_EQ(read(name), whole);
  }
  const std::string told = put([&] { fs::create_directory(kept); });
  EXPECT_TRUE(says(told, {"note: pipelines are not kept", kept.filename()}));
  EXPECT_EQ(files("cache").size(), 1u);
}

TEST_F(KeptPipelinesTest, ThatCannotBeKeptAreDoneWithout) {
  write("cache", "a file where the folder should be");
  const Outcome outcome = draw();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(says(outcome.err, {"note: pipelines are not kept"}));
  EXPECT_EQ(read("cache"), "a file where the folder should be");
}

TEST_F(KeptPipelinesTest, AreNotKeptWhereThatIsOffOrThereIsNoPlace) {
  EXPECT_EQ(draw({{"PLUME_CACHE", "off"}}).exit_code, 0);
  EXPECT_EQ(draw({{"PLUME_CACHE", ""}, {"XDG_CACHE_HOME", "relative"}, {"HOME", ""}}).exit_code, 0);
  EXPECT_FALSE(fs::exists(at("cache")));
  EXPECT_FALSE(fs::exists(at("relative/plume")));
}

TEST_F(KeptPipelinesTest, LieWhereTheDesktopKeepsCaches) {
  EXPECT_EQ(draw({{"PLUME_CACHE", ""}, {"XDG_CACHE_HOME", at("xdg").string()}}).exit_code, 0);
  EXPECT_EQ(files("xdg/plume").size(), 1u);
}

TEST_F(KeptPipelinesTest, AreWholeWhenTwoProgramsEndAtOnce) {
  const Arguments arguments = compare_quickly("quads_mcguire", {"--methods", "wboit"});
  Arguments other = arguments;
  other.insert(other.end(), {"--out", "other"});
  const pid_t first = start(arguments), second = start(other);
  EXPECT_EQ(wait(first).exit_code, 0);
  EXPECT_EQ(wait(second).exit_code, 0);
  ASSERT_EQ(files("cache").size(), 1u);  // no temporary file is left either
  EXPECT_EQ(draw().err.find("pipelines"), std::string::npos);
}

}  // namespace
}  // namespace plume
