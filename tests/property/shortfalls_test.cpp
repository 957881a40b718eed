// What a method says it can lack must be what it counts, and what it advises must be there to be set.
#include "sandbox/measure/shortfalls.h"

#include <regex>

#include "sandbox/workspace/method_account.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class Shortfalls : public GpuTest, public testing::WithParamInterface<std::string> {
 protected:
  static std::set<std::string> keys(const nlohmann::json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) names.insert(name);
    return names;
  }
  std::set<std::string> counted(Stage& stage, const Targets& targets,
                                const std::map<std::string, std::string>& settings) {
    MethodInstance method = instance(GetParam(), settings);
    draw(stage, targets, method);
    return keys(method.method->statistics(device, method.resources));
  }
};

INSTANTIATE_TEST_SUITE_P(All, Shortfalls, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

TEST_P(Shortfalls, AreAmongTheStatisticsOfSomeSetting) {
  const auto method = make_method(GetParam());
  if (method->shortfalls().empty()) return;
  Stage stage(device, pipelines, library, library.scene("coloured"));
  const Targets targets(device, {32, 18});
  stage.go_to(stage.scene().default_tick, targets.size);
  std::set<std::string> names = counted(stage, targets, {});
  const auto all_known = [&] {
    return std::ranges::all_of(method->shortfalls(), [&](const Shortfall& shortfall) {
      return names.contains(std::string(shortfall.statistic));
    });
  };
  for (const auto& parameter : parameter_list(*method))
    for (const auto& option : parameter.value("options", nlohmann::json::array()))
      if (!all_known()) names.merge(counted(stage, targets, {{parameter["name"], option}}));
  for (const Shortfall& shortfall : method->shortfalls())
    EXPECT_TRUE(names.contains(std::string(shortfall.statistic))) << shortfall.statistic;
}

TEST_P(Shortfalls, AdviseParametersThatTheMethodHas) {
  const auto method = make_method(GetParam());
  const nlohmann::json values = parameter_values(*method);
  for (const Shortfall& shortfall : method->shortfalls()) {
    const std::string remedy(shortfall.remedy);
    const std::regex quoted("`([^`]*)`");
    for (std::sregex_iterator name(remedy.begin(), remedy.end(), quoted), end; name != end; ++name)
      EXPECT_TRUE(values.contains((*name)[1])) << remedy;
  }
}

class ShortfallsInWords : public GpuTest {};

TEST_F(ShortfallsInWords, AppearWhereThereIsNoRoomAndNotWhereThereIs) {
  Scene scene;
  scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
  for (int i = 0; i < 6; ++i)
    scene.panes.push_back({.position = {0, 0, -0.1f * float(i)},
                           .size_m = {40, 40},
                           .color = {0.5, 0.5, 0.5},
                           .coverage = 0.3f});
  Workspace workspace(device, pipelines, library, scene, Playback(0, 10, false));
  MethodAccount account;
  const std::vector<std::string> ids = method_ids();
  workspace.choose_method(workspace.a, size_t(std::ranges::find(ids, "mlab") - ids.begin()));
  account.update(workspace, workspace.a, 0);
  EXPECT_FALSE(account.shortfalls(workspace.a)) << "it was not drawn yet";
  constexpr glm::uvec2 kSize{40, 30};
  const auto shortfalls_with = [&](const char* nodes, double now_s) {
    set_parameter(*workspace.a.method().method, "nodes", nodes);
    workspace.change();
    workspace.draw(kSize);
    account.update(workspace, workspace.a, now_s);
    return account.shortfalls(workspace.a).value();
  };
  EXPECT_TRUE(shortfalls_with("8", 1).empty());
  const std::vector<std::string> two{
      "Fragments that found no layer free and were merged into the farthest: 4 800. Raise `nodes`."};
  EXPECT_EQ(two, shortfalls_with("2", 2)) << "four of six on each of 40 x 30 pixels";
  EXPECT_EQ(two, shortfalls_with("8", 2.1)) << "it is not asked this soon again";
  account.update(workspace, workspace.a, 2.3);
  EXPECT_TRUE(account.shortfalls(workspace.a)->empty());
  workspace.choose_method(workspace.a, 0);
  EXPECT_FALSE(account.shortfalls(workspace.a)) << "what another method said is not of this one";
}

}  // namespace
}  // namespace plume
