// scripts/farm_parallel.sh: shards by GNU parallel on this machine, one of which dies on the way.
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class FarmTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v parallel > /dev/null") != 0)
      GTEST_SKIP() << "GNU parallel is not installed (scripts/packages.txt)";
    write("script.toml",
          "name = 'R'\nscene = 'three_cards'\nsize = [32, 18]\nframes = 1\nwarmup = 0\nticks = {first = 0, "
          "last = 5}\n"
          "[[method]]\nid = 'wboit'\n");
  }
  int farm(const std::string& arguments) {
    const std::string script =
        (fs::path(PLUME_SOURCE_TESTS).parent_path() / "scripts/farm_parallel.sh").string();
    return std::system(("cd '" + at("").string() + "' && PLUME_CACHE=off PARALLEL_HOME='" +
                        at("parallel").string() + "' PLUME=./plume '" + script + "' " + arguments +
                        " > farm.out 2> farm.err")
                           .c_str());
  }
};

TEST_F(FarmTest, KilledShardIsGoneOnWith) {
  fs::create_directory(at("parallel"));
  write("parallel/will-cite", "");
  ASSERT_EQ(run({"replay", "script.toml", "--out", "whole"}).exit_code, 0);
  // The second shard's program is killed the first time it has drawn something.
  write("plume",
        "#!/bin/bash\ncase \"$*\" in *'--shard 1/2'*)\n  if mkdir killed 2> /dev/null; then\n    "
        "'" PLUME_PROGRAM
        "' \"$@\" 2> >(grep -m1 '^\\[1/' > /dev/null; touch drawn) &\n"
        "    while [ ! -e drawn ]; do sleep 0.01; done; kill -9 $!; wait $!; exit\n  fi;;\nesac\n"
        "exec '" PLUME_PROGRAM "' \"$@\"\n");
  fs::permissions(at("plume"), fs::perms::owner_all);
  ASSERT_EQ(farm("2 out replay script.toml"), 0) << read("farm.err");
  EXPECT_TRUE(fs::exists(at("drawn")));
  json merged = without_times(results()), whole = without_times(results("whole"));
  EXPECT_EQ(merged, whole);
  EXPECT_EQ(pictures(), pictures("whole"));
}

}  // namespace
}  // namespace plume
