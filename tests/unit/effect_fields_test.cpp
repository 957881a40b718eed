// The description of an effect's fields, as its reader gives it: that it lacks none, and says the truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sandbox/presets/edit_consequences.h"
#include "sandbox/presets/field_help.h"
#include "sandbox/presets/field_toml.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/toml_edit.h"
#include "sandbox/presets/toml_layout.h"
#include "sandbox/presets/value_path.h"

namespace plume {
namespace {

struct ShippedEffect {
  std::string file, text;
};
std::vector<ShippedEffect> shipped_effects() {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  std::vector<ShippedEffect> effects;
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    const std::filesystem::path path = library.find(PresetKind::kEffect, id);
    effects.push_back({path.string(), load_text(path)});
  }
  return effects;
}

/// The paths of all values in a text, tables without.
void collect_paths(const Place& place, std::vector<Step> at, std::set<std::string>& paths) {
  const bool in_tables =
      place.kind == Place::Kind::kTables ||
      (place.kind == Place::Kind::kArray && !place.items.empty() && place.items[0]->is_table());
  if (place.is_table()) {
    for (const auto& member : place.members) {
      std::vector<Step> inner = at;
      inner.push_back({member->key});
      collect_paths(*member, inner, paths);
    }
  } else if (in_tables) {
    for (size_t i = 0; i < place.items.size(); ++i) {
      at.back().index = i;
      collect_paths(*place.items[i], at, paths);
    }
  } else {
    paths.insert(to_string(at));
  }
}

TEST(EffectFields, HaveEveryKeyOfEveryShippedEffect) {
  for (const auto& [file, text] : shipped_effects()) {
    const std::vector<Field> fields = effect_fields(text, file);
    std::set<std::string> paths, unique;
    collect_paths(TomlLayout(text).top(), {}, paths);
    ASSERT_FALSE(paths.empty());
    for (const std::string& path : paths) {
      const Field* field = find_field(fields, path);
      ASSERT_TRUE(field) << file << ": " << path;
      EXPECT_EQ(field->state, Field::State::kRead) << file << ": " << path;
    }
    for (const Field& field : fields) EXPECT_TRUE(unique.insert(field.path).second) << field.path << " twice";
  }
}

/// A text that has what no table that is absent shows: items of lists, of every kind.
constexpr std::string_view kListed = R"(
name = "x"
[[layer]]
[[emitter]]
look = { mesh = "m" }
motion = { attractor = [{}], kill = [{}] }
[[emitter]]
look = { ribbon = true }
[[emitter]]
)";

constexpr std::string_view kListedScene = R"(
name = "x"
[[camera]]
[[solid]]
[[pane]]
[[instance]]
)";

TEST(Fields, AllHaveATooltipAndNoTooltipIsLeftOver) {
  std::set<std::string> patterns;
  const auto collect = [&](const std::vector<Field>& fields) {
    for (const Field& field : fields) patterns.insert(pattern_of(field.path));
  };
  collect(effect_fields(kListed, "effects/listed.toml"));
  for (const auto& [file, text] : shipped_effects()) collect(effect_fields(text, file));
  collect(scene_fields(kListedScene, "scenes/listed.toml"));
  for (const std::string& pattern : patterns)
    EXPECT_TRUE(field_help(pattern)) << "no tooltip for " << pattern;
  for (const FieldHelp& help : all_field_help()) {
    EXPECT_TRUE(patterns.contains(std::string(help.pattern))) << "no field " << help.pattern;
    EXPECT_GT(help.tooltip.size(), 10u) << help.pattern;
    EXPECT_TRUE(help.tooltip.ends_with('.')) << help.pattern;
  }
}

TEST(EffectFields, SayKindLimitsAndDefault) {
  const std::vector<Field> fields = effect_fields(R"(
name = "x"
[[emitter]]
name = "e"
[emitter.spawn]
rate = [[0, 5], [60, 5]]
life = 30
[emitter.shape]
kind = "cone"
[emitter.look]
fade = [[0, 1], [1, 0, -1, 2]]
feather_m = 0.5
radius_m = -1
)",
                                                  "effects/x.toml");
  const auto field = [&](std::string_view path) -> const Field& {
    const Field* found = find_field(fields, path);
    if (!found) throw std::invalid_argument(std::string(path));
    return *found;
  };
  const Field& feather = field("emitter[0].look.feather_m");
  EXPECT_EQ(feather.value, FieldValue(0.5f));
  EXPECT_EQ(feather.fallback, FieldValue(0.0f));
  EXPECT_EQ(feather.limits.max, 100);
  EXPECT_EQ(feather.limits.unit, "m");
  EXPECT_EQ(feather.state, Field::State::kRead);
  EXPECT_EQ(field("emitter[0].look.radius_m").state, Field::State::kWrong);
  EXPECT_EQ(field("emitter[0].look.radius_m").value, FieldValue(Curve(0.5f)));
  EXPECT_EQ(field("emitter[0].look.lit").value, FieldValue(true));
  EXPECT_EQ(field("emitter[0].spawn.life").value, FieldValue(Range<uint32_t>{30, 30}));
  EXPECT_EQ(field("emitter[0].spawn.rate").value, FieldValue(Pairs{{0, 5}, {60, 5}}));
  EXPECT_TRUE(field("emitter[0].spawn.rate").columns[0].whole);
  const Curve fade = std::get<Curve>(field("emitter[0].look.fade").value);
  EXPECT_EQ(fade.keys[1].in, -1.0f);
  EXPECT_EQ(fade.keys[1].out, 2.0f);

  const Field& kind = field("emitter[0].shape.kind");
  EXPECT_EQ(kind.value, FieldValue(std::string("cone")));
  EXPECT_TRUE(kind.required);
  EXPECT_EQ(kind.options.size(), 8u);
  EXPECT_TRUE(field("emitter[0].shape.angle_deg").required);
  EXPECT_FALSE(find_field(fields, "emitter[0].shape.size_m")) << "a cone has none";

  EXPECT_EQ(field("emitter").value, FieldValue(Groups{1}));
  EXPECT_EQ(field("emitter").at_most, 64u);
  EXPECT_FALSE(field("emitter[0].motion").present());
  EXPECT_TRUE(field("emitter[0].motion.vortex.strength").in_absent_table);
  EXPECT_EQ(field("emitter[0].motion.cooling_s").value, FieldValue(1.0f));
  EXPECT_EQ(field("emitter[0].look.opacity").rivals,
            std::vector<std::string>{"emitter[0].look.cross_section_m2"});
  EXPECT_TRUE(field("emitter[0].look.opacity").required) << "neither is there";
}

/// A value that has `number` wherever it has a number that the limits are of; nothing where it has none.
std::optional<FieldValue> filled(const Field& field, double number) {
  FieldValue value = field.value;
  const auto f = static_cast<float>(number);
  if (auto* v = std::get_if<float>(&value)) return *v = f, value;
  if (auto* v = std::get_if<double>(&value)) return *v = number, value;
  if (auto* v = std::get_if<int64_t>(&value)) return *v = int64_t(number), value;
  if (auto* v = std::get_if<glm::vec3>(&value)) return *v = glm::vec3(f), value;
  if (auto* v = std::get_if<Range<float>>(&value)) return *v = {f, f}, value;
  if (auto* v = std::get_if<Range<uint32_t>>(&value)) return *v = {uint32_t(number), uint32_t(number)}, value;
  if (auto* v = std::get_if<Curve>(&value)) return *v = Curve({{0.0f, f}, {1.0f, f}}), value;
  if (auto* v = std::get_if<Gradient>(&value)) return *v = Gradient(glm::vec3(f)), value;
  return {};
}

TEST(EffectFields, ReadBackTheirLeastAndTheirLargest) {
  size_t tried = 0;
  std::set<std::string> done;  // of each pattern, the first is enough
  for (const auto& [file, text] : shipped_effects())
    for (const Field& field : effect_fields(text, file)) {
      if (field.in_absent_table || !done.insert(pattern_of(field.path)).second) continue;
      for (const double end : {field.limits.min, field.limits.max}) {
        const std::optional<FieldValue> value = filled(field, end);
        if (!value) continue;
        const std::string changed = with_value(text, parse_path(field.path), to_toml_value(field, *value));
        const std::vector<Field> fields = effect_fields(changed, file);
        const Field* now = find_field(fields, field.path);
        ASSERT_TRUE(now) << field.path;
        EXPECT_EQ(now->value, *value) << file << ": " << field.path << " at " << end;
        // A rule between fields may speak against it at its place, but not its own limits.
        try {
          read_effect_text(changed, file);
        } catch (const FileErrors& errors) {
          for (const Diagnostic& diagnostic : errors.diagnostics())
            EXPECT_EQ(diagnostic.message.find(", expected a number from"), std::string::npos)
                << to_string(diagnostic);
        }
        ++tried;
      }
    }
  EXPECT_GT(tried, 80u);
}

TEST(EffectFields, WriteEveryShippedValueAsItIs) {
  for (const auto& [file, text] : shipped_effects()) {
    const TomlLayout layout(text);
    for (const Field& field : effect_fields(text, file)) {
      if (!field.present() || std::holds_alternative<Group>(field.value) ||
          std::holds_alternative<Groups>(field.value))
        continue;
      const std::vector<Step> path = parse_path(field.path);
      const size_t nesting = layout.find(path)->nesting();
      EXPECT_EQ(with_value(text, path, to_toml_value(field, field.value, nesting)), text) << field.path;
    }
  }
}

TEST(EffectFields, AreNotTouchedByReadingThemAlong) {
  for (const auto& [file, text] : shipped_effects()) EXPECT_NO_THROW(read_effect_text(text, file));
  EXPECT_TRUE(effect_fields("no toml", "x").empty());
}

TEST(SceneFields, HaveEveryKeyOfEveryShippedScene) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const std::string& id : library.ids(PresetKind::kScene)) {
    const std::string file = library.find(PresetKind::kScene, id).string(), text = load_text(file);
    const std::vector<Field> fields = scene_fields(text, file);
    std::set<std::string> paths, described;
    for (const Field& field : fields) described.insert(field.path);
    collect_paths(TomlLayout(text).top(), {}, paths);
    for (const std::string& path : paths)
      EXPECT_TRUE(described.contains(path) || described.contains(path.substr(0, path.rfind('.')) + "[0]." +
                                                                 path.substr(path.rfind('.') + 1)))
          << id << ": " << path;
  }
}

}  // namespace
}  // namespace plume
