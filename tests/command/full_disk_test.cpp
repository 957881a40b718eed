// A disk that becomes full, or a folder that takes nothing: at each operation of a command in turn. The file
// is named, the exit code is 2, nothing that is not whole stands under its final name, and once there is room
// all is as if nothing had been.
#include "tests/faults/full_disk.h"

#include <sys/mman.h>

#include <cerrno>
#include <cstring>
#include <functional>
#include <new>
#include <set>

#include "sandbox/measure/image_io.h"
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

class FullDiskTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("script.toml", street_script("[20, 40]", "[capture]\nhdr = true\n[[method]]\nid = 'sorted'\n"));
    write("log", std::string(sizeof(FullDiskLog), '\0'));
    const int file = open(at("log").c_str(), O_RDWR);
    void* log = mmap(nullptr, sizeof(FullDiskLog), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    ASSERT_NE(log, MAP_FAILED);
    log_ = static_cast<FullDiskLog*>(log);
  }
  void TearDown() override {
    munmap(log_, sizeof(FullDiskLog));
    ProgramTest::TearDown();
  }

  /// Runs where nothing goes onto the disk any more from operation `at` on; 0: everything does.
  Outcome run_until_full(const Arguments& arguments, uint64_t at, int error, Environment environment = {}) {
    log_->operations = 0;
    std::memset(log_->first_failed, 0, sizeof log_->first_failed);
    const char* asan = getenv("ASAN_OPTIONS");  // which wants to be loaded before all others
    environment.merge(
        Environment{{"LD_PRELOAD", PLUME_FULL_DISK},
                    {"FULL_DISK_AT", std::to_string(at)},
                    {"FULL_DISK_ERROR", std::to_string(error)},
                    {"FULL_DISK_LOG", this->at("log").string()},
                    {"ASAN_OPTIONS", std::string(asan ? asan : "") + ":verify_asan_link_order=0"}});
    return run(arguments, environment);
  }
  /// The final name of what the first operation that failed was about; empty: none failed.
  fs::path failed() const {
    const std::string path = log_->first_failed;
    return path.substr(0, path.find(".tmp-"));
  }

  std::map<std::string, std::string> all_files(const fs::path& folder) const {
    std::map<std::string, std::string> found;
    if (fs::exists(at(folder)))
      for (const auto& entry : fs::recursive_directory_iterator(at(folder)))
        if (entry.is_regular_file())
          found[entry.path().lexically_relative(at(folder)).string()] = read(entry.path());
    return found;
  }

  static void expect_whole(const fs::path& file, const std::string& bytes,
                           const std::map<std::string, std::string>& right) {
    EXPECT_EQ(file.string().find(".tmp-"), std::string::npos) << file;
    const std::string kind = file.extension();
    if (kind == ".png" || kind == ".exr") {
      ASSERT_TRUE(right.contains(file)) << file;
      EXPECT_TRUE(bytes == right.at(file)) << file;
    }
    if (kind == ".json") {
      EXPECT_TRUE(json::accept(bytes)) << file;
    }
    if (kind == ".csv" || kind == ".html" || kind == ".toml") {
      EXPECT_TRUE(bytes.ends_with("\n")) << file;
    }
    if (kind == ".html") {
      EXPECT_TRUE(bytes.ends_with("</html>\n")) << file;
    }
  }

  struct Command {
    Arguments arguments;
    fs::path writes_into;
    std::string when_free;  ///< added to the same command once there is room; "": it is simply run again
    bool makes_its_folder = true;
    Environment environment = {};
  };
  /// How many operations there were; those of `stride` were tried.
  uint64_t fill_at_each(const Command& command, uint64_t stride, int error = ENOSPC) {
    if (!command.makes_its_folder) fs::create_directory(at(command.writes_into));
    const Outcome undisturbed = run_until_full(command.arguments, 0, error, command.environment);
    EXPECT_EQ(undisturbed.exit_code, 0) << undisturbed.err;
    const auto right = all_files(command.writes_into);
    const uint64_t operations = log_->operations;
    for (uint64_t at = 1; at <= operations; at += stride) {
      SCOPED_TRACE("operation " + std::to_string(at) + " of " + std::to_string(operations));
      fs::remove_all(this->at(command.writes_into));
      if (!command.makes_its_folder) fs::create_directory(this->at(command.writes_into));
      const Outcome full = run_until_full(command.arguments, at, error, command.environment);
      if (failed().empty()) break;  // results are written more or less often, as time allows
      EXPECT_EQ(full.exit_code, 2);
      EXPECT_EQ(full.out.find("report: "), std::string::npos) << full.out;
      const std::string last_line = full.err.substr(full.err.rfind("plume: "));
      EXPECT_TRUE(says(last_line, {failed().filename(), std::strerror(error)}));
      EXPECT_FALSE(says(last_line, {".tmp-"}));
      for (const auto& [name, bytes] : all_files(command.writes_into)) expect_whole(name, bytes, right);

      if (fs::exists(this->at(command.writes_into / "results.json"))) {
        const json all = json::parse(right.at("results.json"));
        for (const json& frame : frames(command.writes_into)) {
          EXPECT_EQ(std::ranges::count(without_times(all["frames"]), without_times(frame)), 1) << frame;
          for (const char* file : {"image", "error_map", "hdr"})
            if (frame[file].is_string()) {
              EXPECT_TRUE(fs::exists(this->at(command.writes_into) / frame[file].get<std::string>()));
            }
        }
      }

      Arguments again = command.arguments;
      if (!command.when_free.empty()) again.push_back(command.when_free);
      const Outcome free = run(again, command.environment);
      EXPECT_EQ(free.exit_code, 0) << free.err;
      expect_same(all_files(command.writes_into), right);
      if (HasFailure()) break;
    }
    return operations;
  }

  /// But for times, and what they make of reports.
  static void expect_same(const std::map<std::string, std::string>& now,
                          const std::map<std::string, std::string>& right) {
    std::set<std::string> names, right_names;
    for (const auto& [name, bytes] : now) names.insert(name);
    for (const auto& [name, bytes] : right) right_names.insert(name);
    EXPECT_EQ(names, right_names);
    for (const auto& [name, bytes] : now) {
      if (!right.contains(name)) continue;
      if (name.ends_with("results.json")) {
        EXPECT_EQ(without_times(json::parse(bytes)), without_times(json::parse(right.at(name))));
      } else if (name.ends_with("stress.json")) {
        EXPECT_EQ(json::parse(bytes)["rows"], json::parse(right.at(name))["rows"]);
      } else if (!name.ends_with(".csv") && !name.ends_with(".html")) {
        EXPECT_TRUE(bytes == right.at(name)) << name;
      }
    }
  }

  FullDiskLog* log_ = nullptr;
};

TEST_F(FullDiskTest, ReplayGoesOnOnceThereIsRoom) {
  const uint64_t operations = fill_at_each({{"replay", "script.toml"}, "out", "--resume"}, every(7));
  EXPECT_GT(operations, 30u);
}

TEST_F(FullDiskTest, AFolderThatTakesNothingIsNamed) {
  for (const int error : {EACCES, EROFS})
    fill_at_each({{"replay", "script.toml"}, "out", "--resume"}, every(1000), error);
}

TEST_F(FullDiskTest, IsolatedReplayGoesOnOnceThereIsRoom) {
  fill_at_each({{"replay", "script.toml", "--isolate"}, "out", "--resume"}, every(29));
}

TEST_F(FullDiskTest, CompareGoesOnOnceThereIsRoom) {
  fill_at_each({compare_quickly("quads_mcguire", {"--methods", "wboit,sorted"}), "out", "--resume"},
               every(11));
}

TEST_F(FullDiskTest, PartsAreMergedOnceThereIsRoom) {
  for (const char* part : {"0", "1"})
    ASSERT_EQ(run({"replay", "script.toml", "--shard", part + std::string("/2"), "--out", part}).exit_code,
              0);
  fill_at_each({{"merge", "0", "1", "--out", "all"}, "all", ""}, every(3));
}

TEST_F(FullDiskTest, StressWritesAllOrNothing) {
  fill_at_each({{"stress", "three_cards", "--methods", "sorted", "--out", "stress"}, "stress", ""}, every(3));
}

TEST_F(FullDiskTest, ViewsOfInspectAreWholeOrNotThere) {
  fill_at_each({.arguments = {"inspect", "quads_mcguire", "--view", "overdraw", "--size", "48x27", "--out",
                              "views/overdraw.png", "--out", "views/overdraw.exr"},
                .writes_into = "views",
                .when_free = "",
                .makes_its_folder = false},
               every(2));
}

TEST_F(FullDiskTest, PipelinesThatDoNotFitAreDoneWithout) {
  const Arguments draw = compare_quickly("quads_mcguire", {"--methods", "wboit"});
  ASSERT_EQ(run_until_full(draw, 0, ENOSPC).exit_code, 0);
  int kept = 0;  // last of all: the folder, the file, a write and the name
  for (uint64_t at = log_->operations + 2;; --at) {
    fs::remove_all(this->at("out"));
    fs::remove_all(this->at("cache"));
    const Outcome outcome = run_until_full(draw, at, ENOSPC);
    if (failed().empty()) continue;
    if (!says(failed().string(), {"cache"})) break;
    ++kept;
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(
        says(outcome.err, {"note: pipelines are not kept", failed().filename(), std::strerror(ENOSPC)}));
    EXPECT_TRUE(all_files("cache").empty());
    EXPECT_TRUE(fs::exists(this->at("out/report.html")));
  }
  EXPECT_EQ(kept, 4);
}

}  // namespace
}  // namespace plume
