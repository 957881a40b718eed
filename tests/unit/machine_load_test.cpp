#include "sandbox/runs/machine_load.h"

#include <gtest/gtest.h>

#include <fstream>

namespace plume {
namespace {

namespace fs = std::filesystem;

/// A machine of which only what is written here is known.
class MachineLoadTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string folder = (fs::temp_directory_path() / "plume machine XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    root_ = folder;
  }
  void TearDown() override { fs::remove_all(root_); }
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name) << text;
  }
  MachineLoad load() const { return read_machine_load(root_); }

  fs::path root_;
};

constexpr const char* kTwoCoresFourThreads =
    "processor\t: 0\nmodel name\t: Example CPU @ 3.0GHz\ncpu MHz\t\t: 3000.000\nphysical id\t: 0\ncore "
    "id\t\t: 0\n\n"
    "processor\t: 1\nmodel name\t: Example CPU @ 3.0GHz\ncpu MHz\t\t: 2000.000\nphysical id\t: 0\ncore "
    "id\t\t: 1\n\n"
    "processor\t: 2\nmodel name\t: Example CPU @ 3.0GHz\ncpu MHz\t\t: 3000.000\nphysical id\t: 0\ncore "
    "id\t\t: 0\n\n"
    "processor\t: 3\nmodel name\t: Example CPU @ 3.0GHz\ncpu MHz\t\t: 2000.000\nphysical id\t: 0\ncore "
    "id\t\t: 1\n"
    "flags\t\t:\n";

TEST_F(MachineLoadTest, ReadsTheProcessor) {
  write("proc/cpuinfo", kTwoCoresFourThreads);
  const Processor processor = read_processor(root_);
  EXPECT_EQ(processor.name, "Example CPU @ 3.0GHz");
  EXPECT_EQ(processor.threads, 4u);
  EXPECT_EQ(processor.cores, 2u);
}

TEST_F(MachineLoadTest, AMachineThatTellsNothingGivesNoNotes) {
  const Processor processor = read_processor(root_);
  EXPECT_EQ(processor.name, "unknown");
  EXPECT_EQ(processor.cores, 1u);
  EXPECT_TRUE(load_notes(load(), load(), 1).empty());
}

TEST_F(MachineLoadTest, ReadsTicksPastAnyProgramName) {
  write("proc/stat", "cpu  100 20 30 400 50 6 7 8 90 10\ncpu0 1 1 1 1 1 1 1 1 0 0\n");
  write("proc/self/stat", "77 (a) b (c) R 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n");
  const MachineLoad::Ticks ticks = load().ticks.value();
  EXPECT_EQ(ticks.busy, 163u);  // guests are among the user's
  EXPECT_EQ(ticks.stolen, 8u);
  EXPECT_EQ(ticks.total, 621u);
  EXPECT_EQ(ticks.own, 11u + 12u + 13u + 14u);
}

TEST_F(MachineLoadTest, ReadsTheClockWhereItIsTold) {
  write("proc/cpuinfo", kTwoCoresFourThreads);
  EXPECT_DOUBLE_EQ(load().mhz.value(), 2500.0);
  for (int cpu = 0; cpu < 2; ++cpu)
    write("sys/devices/system/cpu/cpu" + std::to_string(cpu) + "/cpufreq/scaling_cur_freq",
          std::to_string(1'000'000 * (cpu + 1)) + "\n");
  write("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "schedutil\n");
  EXPECT_DOUBLE_EQ(load().mhz.value(), 1500.0);
  EXPECT_EQ(load().governor, "schedutil");
}

std::vector<std::string> texts(const std::vector<Note>& notes) {
  std::vector<std::string> list;
  for (const Note& note : notes) list.push_back(note.what + ": " + note.text);
  return list;
}

/// An idle machine of two threads, and 1000 ticks later a program that had it to itself.
MachineLoad idle() {
  return {.load_average = 0.2, .governor = "performance", .mhz = 2300.0, .ticks = MachineLoad::Ticks{}};
}
MachineLoad alone() {
  return {.load_average = 2.9,
          .governor = "performance",
          .mhz = 2301.0,
          .ticks = MachineLoad::Ticks{.own = 900, .busy = 920, .stolen = 0, .total = 1000}};
}

TEST(LoadNotesTest, AMachineOfItsOwnGivesNone) {
  EXPECT_EQ(texts(load_notes(idle(), alone(), 2)), std::vector<std::string>{});
}

TEST(LoadNotesTest, ABusyMachineIsNamed) {
  MachineLoad before = idle();
  before.load_average = 2.4;
  EXPECT_EQ(texts(load_notes(before, alone(), 2)),
            std::vector<std::string>{"load: The load average was 2.4 before and 2.9 after on 2 processor "
                                     "threads: more wanted to run than could."});
  MachineLoad after = alone();
  after.load_average = 3.4;
  EXPECT_EQ(load_notes(idle(), after, 2).size(), 1u);
}

TEST(LoadNotesTest, OtherProcessesAreNamedWithTheirShare) {
  MachineLoad after = alone();
  after.ticks = MachineLoad::Ticks{.own = 500, .busy = 870, .stolen = 30, .total = 1000};
  EXPECT_EQ(
      texts(load_notes(idle(), after, 2)),
      (std::vector<std::string>{"processes: Other processes used 37 % of the processors' time, this one "
                                "50 %: on a CPU device times are longer for it.",
                                "host: The host gave 3 % of the processors' time to other machines."}));
}

TEST(LoadNotesTest, AClockThatFollowsTheLoadOrChangedIsNamed) {
  MachineLoad after = alone();
  after.governor = "powersave";
  after.mhz = 1800.0;
  const auto notes = texts(load_notes(idle(), after, 2));
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_TRUE(notes[0].starts_with("clock: The processors' frequency governor is powersave")) << notes[0];
  EXPECT_EQ(notes[1], "clock: The processors' clock was 2300 MHz before and 1800 MHz after.");
}

TEST(LoadNotesTest, ThisMachineIsRead) {
  const MachineLoad now = read_machine_load();
  EXPECT_TRUE(now.load_average.has_value());
  ASSERT_TRUE(now.ticks.has_value());
  EXPECT_LE(now.ticks->own, now.ticks->busy);
  EXPECT_LT(now.ticks->busy, now.ticks->total);
  EXPECT_NE(read_processor().name, "");
}

}  // namespace
}  // namespace plume
