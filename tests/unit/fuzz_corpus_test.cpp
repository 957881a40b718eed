// What fuzzers start from and what they once found holds in every build: each file is read as a fuzzer reads
// it. And their dictionary has every word that effects and scenes can have.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/value_path.h"
#include "tests/fuzz/checks.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string name;
  std::string (*check)(fuzz::Bytes);
};
const Target kTargets[] = {{"effect", fuzz::check_effect},
                           {"scene", fuzz::check_scene},
                           {"replay", fuzz::check_replay},
                           {"png", fuzz::check_png},
                           {"exr", fuzz::check_exr}};

/// As in scripts/fuzz.sh.
std::vector<fs::path> files_of(const Target& target) {
  std::vector<fs::path> files;
  for (const fs::path& folder : {fs::path(PLUME_SOURCE_TESTS) / "fuzz/corpus" / target.name,
                                 fs::path(PLUME_SOURCE_PRESETS) / (target.name + "s"),
                                 fs::path(PLUME_SOURCE_TESTS) / "malformed" / (target.name + "s")})
    if (fs::is_directory(folder))
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

class FuzzCorpus : public testing::TestWithParam<Target> {};

TEST_P(FuzzCorpus, IsReadOrRefusedAsItShould) {
  const auto files = files_of(GetParam());
  EXPECT_GE(files.size(), 25u);
  std::set<std::string> ends;
  for (const fs::path& file : files) try {
      ends.insert(GetParam().check(read_file(file)));
    } catch (const std::exception& error) {
      ADD_FAILURE() << file.string() << ": " << error.what();
    }
  EXPECT_GE(ends.size(), 2u) << "all are read, or none";
}

INSTANTIATE_TEST_SUITE_P(, FuzzCorpus, testing::ValuesIn(kTargets),
                         [](const auto& target) { return target.param.name; });

/// Tables, keys, and the texts that these can have.
std::set<std::string> words_of(const std::vector<Field>& fields) {
  std::set<std::string> words;
  for (const Field& field : fields) {
    const std::string pattern = pattern_of(field.path);
    if (pattern.starts_with("instance.layers.")) continue;  // whatever an effect calls them
    if (std::holds_alternative<Group>(field.value))
      words.insert("[" + pattern + "]");
    else if (std::holds_alternative<Groups>(field.value))
      words.insert("[[" + pattern + "]]");
    else
      words.insert(pattern.substr(pattern.rfind('.') + 1));
    if (field.names.empty()) words.insert(field.options.begin(), field.options.end());
  }
  return words;
}

TEST(FuzzDictionary, HasEveryWordOfEffectsAndScenes) {
  std::set<std::string> words;
  for (const auto& [folder, fields] :
       {std::pair{"effects", &effect_fields}, std::pair{"scenes", &scene_fields}})
    for (const auto& entry : fs::directory_iterator(fs::path(PLUME_SOURCE_PRESETS) / folder))
      words.merge(words_of(fields(load_text(entry.path()), entry.path().string())));
  const std::string dictionary = load_text(fs::path(PLUME_SOURCE_TESTS) / "fuzz/toml.dict");
  std::string missing;
  for (const std::string& word : words)
    if (dictionary.find('"' + word + '"') == dictionary.npos) missing += '"' + word + "\"\n";
  EXPECT_EQ(missing, "") << "to be added to tests/fuzz/toml.dict";
}

}  // namespace
}  // namespace plume
