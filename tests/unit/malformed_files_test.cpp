// Every file in tests/malformed says at its top, in lines `# expect: LINE:COLUMN: part of the message`, what
// is wrong in it. The reader must find all of that, nothing else, and say of each what would be right.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "sandbox/presets/check.h"
#include "sandbox/presets/diagnostics.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> malformed_files() {
  std::vector<fs::path> files;
  std::error_code absent;  // then AreManyOfEachKind fails
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(PLUME_SOURCE_TESTS) / "malformed", absent))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

struct Expectation {
  std::string position, part;
};

std::vector<Expectation> expectations(const fs::path& file) {
  constexpr std::string_view kMark = "# expect: ";
  std::vector<Expectation> found;
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line) && line.starts_with(kMark);) {
    line = line.substr(kMark.size());
    const size_t gap = line.find(": ");
    found.push_back({line.substr(0, gap), gap == line.npos ? "" : line.substr(gap + 2)});
  }
  return found;
}

class MalformedFile : public testing::TestWithParam<fs::path> {};

TEST_P(MalformedFile, IsReportedWhereAndAsItSays) {
  std::vector<Diagnostic> found = check_file(GetParam());
  const std::vector<Expectation> expected = expectations(GetParam());
  ASSERT_FALSE(expected.empty()) << "the file does not say what to expect";
  std::string all;
  for (const Diagnostic& d : found) all += to_string(d) + "\n";
  for (const Expectation& e : expected) {
    ASSERT_FALSE(e.part.empty());
    const auto match = std::ranges::find_if(found, [&](const Diagnostic& d) {
      return std::to_string(d.line) + ":" + std::to_string(d.column) == e.position &&
             d.message.find(e.part) != d.message.npos;
    });
    if (match == found.end())
      ADD_FAILURE() << "not reported: " << e.position << ": " << e.part << "\nbut:\n" << all;
    else
      found.erase(match);
  }
  for (const Diagnostic& d : found) ADD_FAILURE() << "not expected: " << to_string(d);
}

TEST_P(MalformedFile, IsToldWhatWouldBeRight) {
  for (const Diagnostic& d : check_file(GetParam())) {
    EXPECT_GT(d.line, 0u);
    EXPECT_GT(d.column, 0u);
    EXPECT_EQ(d.file, GetParam().string());
    const size_t right = std::min(d.message.find(", expected "), d.message.find(", did you mean "));
    ASSERT_NE(right, d.message.npos) << to_string(d);
    EXPECT_GT(right, 5u) << to_string(d);
    EXPECT_EQ(d.message.find('\n'), d.message.npos) << to_string(d);
  }
}

INSTANTIATE_TEST_SUITE_P(, MalformedFile, testing::ValuesIn(malformed_files()), [](const auto& file) {
  std::string name = file.param.parent_path().filename().string() + "_" + file.param.stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
});

TEST(MalformedFiles, AreManyOfEachKind) {
  std::map<std::string, int> count;
  for (const fs::path& file : malformed_files()) ++count[file.parent_path().filename().string()];
  EXPECT_GE(count["effects"], 25);
  EXPECT_GE(count["scenes"], 20);
  EXPECT_GE(count["replays"], 12);
}

}  // namespace
}  // namespace plume
