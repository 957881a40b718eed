// The built program, run as a user runs it: arguments in; exit code, standard output and standard error out.
#ifndef PLUME_TESTS_PROGRAM_H
#define PLUME_TESTS_PROGRAM_H

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

namespace plume {

namespace fs = std::filesystem;
using nlohmann::json;
using Arguments = std::vector<std::string>;
using Environment = std::map<std::string, std::string>;

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when a signal ended it, as a shell says
  std::string out, err;
};

/// Runs the program in a fresh folder, which is its working directory and has a space in its name.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string folder = (fs::temp_directory_path() / "plume test XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    folder_ = folder;
  }
  void TearDown() override {
    if (!folder_.empty()) fs::remove_all(folder_);
  }

  Outcome run(const Arguments& arguments, const Environment& environment = {}) {
    return wait(start(arguments, environment));
  }
  pid_t start(const Arguments& arguments, const Environment& environment = {}) {
    std::vector<char*> argv{const_cast<char*>(PLUME_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const int out = creat(at("stdout").c_str(), 0666), err = creat(at("stderr").c_str(), 0666);
    const pid_t child = fork();
    if (child == 0) {
      // The user's own folders are neither read nor written.
      setenv("PLUME_CACHE", at("cache").c_str(), 1);
      setenv("PLUME_CONFIG", at("config").c_str(), 1);
      for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
      if (chdir(folder_.c_str()) == 0 && dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0)
        execv(PLUME_PROGRAM, argv.data());
      _exit(127);
    }
    close(out);
    close(err);
    return child;
  }
  Outcome wait(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return {.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
            .out = read("stdout"),
            .err = read("stderr")};
  }

  fs::path at(const fs::path& name) const { return folder_ / name; }
  void write(const fs::path& name, std::string_view text) const {
    fs::create_directories(at(name).parent_path());
    std::ofstream(at(name), std::ios::binary) << text;
  }
  std::string read(const fs::path& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  json results(const fs::path& folder = "out") const { return json::parse(read(folder / "results.json")); }
  /// A copy, which a loop may go over: a part of results() is gone before the loop begins.
  json frames(const fs::path& folder = "out") const { return results(folder)["frames"]; }
  json demand_of_first(const fs::path& folder = "out") const {
    return results(folder).at("moments").at(0).at("demand");
  }

  /// The pictures below `folder` by name, as bytes.
  std::map<std::string, std::string> pictures(const fs::path& folder = "out") const {
    std::map<std::string, std::string> found;
    for (const auto& entry : fs::directory_iterator(at(folder)))
      if (entry.path().extension() == ".png" || entry.path().extension() == ".exr")
        found[entry.path().filename().string()] = read(entry.path());
    return found;
  }
  std::vector<std::string> files(const fs::path& folder = "out") const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(at(folder)))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }

 private:
  fs::path folder_;
};

/// What to type after `plume compare SCENE` to be done in a moment.
inline Arguments compare_quickly(const std::string& scene, const Arguments& more = {}) {
  Arguments arguments{"compare", scene, "--size", "48x27", "--frames", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// A replay script of the street; `rest` may replace nothing and must add at least one [[method]].
inline std::string street_script(const std::string& ticks, const std::string& rest) {
  return "name = 'R'\nscene = 'street'\nsize = [48, 27]\nframes = 1\nwarmup = 0\nticks = " + ticks + "\n" +
         rest;
}

inline std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

/// One of the messages a person reads: an assertion with all of it when a part is not there.
inline testing::AssertionResult says(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    if (text.find(part) == std::string::npos)
      return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
  return testing::AssertionSuccess();
}

}  // namespace plume
#endif
