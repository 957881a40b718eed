// plume list: everything there is, for people and for programs.
#include "renderer/methods/methods.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class ListTest : public ProgramTest {
 protected:
  json listed(const std::string& what, const Environment& environment = {}) {
    const Outcome outcome = run({"list", what, "--json"}, environment);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
};

std::vector<std::string> ids(const json& list) {
  std::vector<std::string> found;
  for (const json& entry : list) found.push_back(entry.at("id"));
  return found;
}

std::vector<std::string> shipped(const std::string& folder) {
  std::vector<std::string> found;
  if (!fs::exists(fs::path(PLUME_SOURCE_PRESETS) / folder)) return found;
  for (const auto& entry : fs::directory_iterator(fs::path(PLUME_SOURCE_PRESETS) / folder))
    if (entry.path().extension() == ".toml") found.push_back(entry.path().stem().string());
  std::ranges::sort(found);
  return found;
}

TEST_F(ListTest, DescribesEveryMethodAndParameter) {
  const json methods = listed("methods");
  EXPECT_EQ(ids(methods), method_ids());
  size_t parameters = 0;
  for (const json& method : methods) {
    SCOPED_TRACE(method.dump());
    for (const char* key : {"title", "source", "transmission", "emission", "outputs", "limits"})
      EXPECT_FALSE(method.at(key).get<std::string>().empty()) << key;
    EXPECT_GE(method.at("memory").at("bytes"), 0);
    if (!method.at("exact")) {
      EXPECT_GT(method.at("street_rmse"), 0);
    }
    for (const json& parameter : method.at("parameters")) {
      ++parameters;
      SCOPED_TRACE(parameter.dump());
      EXPECT_FALSE(parameter.at("name").get<std::string>().empty());
      EXPECT_FALSE(parameter.at("help").get<std::string>().empty());
      const std::string type = parameter.at("type");
      const json& standard = parameter.at("value");
      if (type == "number" || type == "integer") {
        EXPECT_TRUE(parameter.at("unit").is_string());
        EXPECT_LE(parameter.at("min").get<double>(), standard.get<double>());
        EXPECT_GE(parameter.at("max").get<double>(), standard.get<double>());
      } else if (type == "choice") {
        const std::vector<std::string> options = parameter.at("options");
        EXPECT_EQ(std::ranges::count(options, standard.get<std::string>()), 1);
      } else {
        EXPECT_EQ(type, "toggle");
        EXPECT_TRUE(standard.is_boolean());
      }
    }
  }
  EXPECT_GT(parameters, 0u);
}

TEST_F(ListTest, ShowsPeopleHowToSetEachParameter) {
  const Outcome outcome = run({"list", "methods"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const json& method : listed("methods")) {
    const std::string id = method["id"];
    EXPECT_TRUE(says(outcome.out, {id, method["title"], method["source"]}));
    for (const json& parameter : method["parameters"])
      EXPECT_TRUE(says(outcome.out, {"--set " + id + "." + parameter["name"].get<std::string>() + "=",
                                     parameter["help"].get<std::string>()}));
  }
}

TEST_F(ListTest, NamesEveryEffectOfThePresets) {
  const json effects = listed("effects");
  EXPECT_EQ(ids(effects), shipped("effects"));
  for (const json& effect : effects) {
    EXPECT_GT(effect.at("capacity"), 0u) << effect;
    EXPECT_FALSE(effect.at("emitters").empty()) << effect;
  }
  EXPECT_TRUE(says(run({"list", "effects"}).out, shipped("effects")));
}

TEST_F(ListTest, NamesEverySceneOfThePresets) {
  const json scenes = listed("scenes");
  EXPECT_EQ(ids(scenes), shipped("scenes"));
  for (const json& scene : scenes)
    EXPECT_LE(scene.at("default_tick").get<int>(), scene.at("duration_ticks").get<int>()) << scene;
  EXPECT_TRUE(says(run({"list", "scenes"}).out, shipped("scenes")));
}

TEST_F(ListTest, NamesEveryReplayOfThePresets) {
  EXPECT_EQ(ids(listed("replays")), shipped("replays"));
}

TEST_F(ListTest, ReadsThePresetFolderItIsGiven) {
  write("my presets/replays/mine.toml",
        street_script("[3, 5]", "[[method]]\nid = 'wboit'\nweight = 'eq9'\n"));
  const Environment mine{{"PLUME_PRESETS", "my presets"}};
  const json replays = listed("replays", mine);
  ASSERT_EQ(ids(replays), std::vector<std::string>{"mine"});
  EXPECT_EQ(replays[0].at("title"), "R");
  EXPECT_EQ(replays[0].at("scene"), "street");
  EXPECT_EQ(replays[0].at("ticks"), json::parse("[3, 5]"));
  EXPECT_EQ(replays[0].at("size"), json::parse("[48, 27]"));
  EXPECT_EQ(replays[0].at("methods"), json::parse(R"([{"id": "wboit", "settings": {"weight": "eq9"}}])"));
  EXPECT_TRUE(says(run({"list", "replays"}, mine).out, {"mine", "R", "street"}));
}

TEST_F(ListTest, RefusesAPresetFolderThatIsNotThere) {
  const Outcome outcome = run({"list", "scenes"}, {{"PLUME_PRESETS", "/no/where"}});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"PLUME_PRESETS is /no/where", "expected a folder"}));
}

TEST_F(ListTest, NamesDevicesInTheOrderOfTheirIndices) {
  const json devices = listed("devices");
  ASSERT_FALSE(devices.empty());
  for (size_t i = 0; i < devices.size(); ++i) {
    EXPECT_EQ(devices[i].at("id"), std::to_string(i));
    EXPECT_FALSE(devices[i].at("title").get<std::string>().empty());
    EXPECT_TRUE(says(devices[i].at("description"), {"Vulkan 1."}));
  }
  EXPECT_TRUE(says(run({"list", "devices"}).out, {devices[0]["title"]}));
}

TEST_F(ListTest, HasNoDevicesWithoutADriver) {
  EXPECT_EQ(listed("devices", {{"VK_ICD_FILENAMES", "/nonexistent"}}), json::array());
}

}  // namespace
}  // namespace plume
