#include "tests/property/random_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>

#include "sandbox/effects/lineage.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/edit_consequences.h"
#include "sandbox/presets/field_toml.h"
#include "sandbox/presets/preset_document.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/toml_edit.h"
#include "sandbox/presets/value_path.h"
#include "tests/property/random_value.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

constexpr uint64_t kMostCards = 600;      // of a scene at once: peeling takes a draw of all for a layer
constexpr uint64_t kMostSteps = 400'000;  // ticks that its particles live together
constexpr uint32_t kLatestCall = 200;     // tick, of what is seen
constexpr size_t kMostInAList = 4;

/// What an effect takes, at most.
struct Load {
  uint64_t cards = 0, steps = 0;
  bool is_bearable() const { return cards <= kMostCards && steps <= kMostSteps; }
};
Load load_of(const Effect& effect, const Path* path = nullptr) {
  Load load;
  for (uint32_t i = 0; i < effect.emitters.size(); ++i) {
    const Lineage lineage = lineage_of(effect.emitters, i);
    const SpawnSchedule schedule(lineage.spawn,
                                 {.path = path, .per_root = lineage.per_root, .life = lineage.life});
    size_t cards_each = 1;
    for (const MeshName& name : effect.emitters[i].look.meshes)
      cards_each =
          std::max(cards_each, std::ranges::find(effect.meshes, name.id, &Mesh::id)->triangles.size());
    load.cards += schedule.capacity() * cards_each;
    load.steps += schedule.capacity() * lineage.life;
  }
  return load;
}

class Author {
 public:
  Author(uint64_t seed, const fs::path& folder)
      : dice_(seed), wildness_(dice_.one_of(std::array{0u, 2u, 10u})), library_(folder) {}

  /// Gives its id.
  std::string effect() {
    const std::string id = fmt::format("random_{}", made_.files.size());
    const std::vector<std::string> shipped = library_.ids(PresetKind::kEffect);
    const bool is_new = dice_.chance(60);
    PresetDocument document =
        open(PresetKind::kEffect, id,
             is_new ? "name = \"x\"" : load_text(library_.find(PresetKind::kEffect, dice_.one_of(shipped))));
    const auto is_bearable = [&] { return !document.effect() || load_of(*document.effect()).is_bearable(); };
    for (uint64_t more = is_new ? 1 + dice_.below(3) : 0; more > 0; --more) document.add("emitter");
    for (int round = 0; round < 12 && !is_bearable(); ++round) bear_less(document);
    wander(document, is_new ? 60 : uint32_t(dice_.below(16)), is_bearable);
    finish(document);
    return id;
  }

  void scene(const std::string& id, const std::vector<std::string>& effects) {
    PresetDocument document = open(PresetKind::kScene, id, "name = \"x\"");
    const auto is_bearable = [&] { return load_of(*document.scene()).is_bearable(); };
    document.add("camera");
    for (const auto& [list, most] : {std::pair("solid", 3), std::pair("pane", 4)})
      for (uint64_t more = dice_.below(uint64_t(most) + 1); more > 0; --more) document.add(list);
    for (uint64_t more = 1 + dice_.below(3); more > 0; --more) {
      add_instance(document, dice_.one_of(effects));
      if (!is_bearable()) document.undo();
    }
    wander(document, 100, is_bearable);
    aim_camera(document);
    move_camera(document);
    for (size_t i = 0; i < document.scene()->instances.size(); ++i) move_layers(document, i);
    look_at_something(document);
    finish(document);
    made_.id = id;
    made_.size = {1 + dice_.below(64), 1 + dice_.below(40)};
  }

  RandomScene result() && { return std::move(made_); }

 private:
  PresetDocument open(PresetKind kind, const std::string& id, const std::string& text) {
    const fs::path path =
        library_.root() / (kind == PresetKind::kScene ? "scenes" : "effects") / fmt::format("{}.toml", id);
    std::ofstream(path) << text << "\n";
    made_.files.push_back(path);
    return PresetDocument(path, kind, library_);
  }

  void finish(PresetDocument& document) {
    document.save();
    for (const Field& field : document.fields())
      if (field.present() && is_table(field)) made_.patterns.insert(pattern_of(field.path));
  }
  static bool is_table(const Field& field) {
    return std::holds_alternative<Group>(field.value) || std::holds_alternative<Groups>(field.value);
  }

  Load load_of(const Scene& scene) const {
    Load sum;
    for (const Instance& instance : scene.instances) {
      if (!instance.call_tick) continue;
      const Load load =
          plume::load_of(library_.effect(instance.effect), instance.path ? &*instance.path : nullptr);
      sum.cards += load.cards, sum.steps += load.steps;
    }
    return sum;
  }
  static Load load_of(const Effect& effect) { return plume::load_of(effect); }

  /// Half as many particles.
  static void bear_less(PresetDocument& document) {
    const std::vector<Field> fields = document.fields();
    for (const Field& field : fields) {
      const std::string pattern = pattern_of(field.path);
      if (!field.present() || (pattern != "emitter.spawn.rate" && pattern != "emitter.spawn.bursts"))
        continue;
      FieldValue fewer = field.value;
      if (auto* rate = std::get_if<double>(&fewer)) *rate /= 2;
      if (auto* rows = std::get_if<Pairs>(&fewer))
        for (auto& [tick, count] : *rows) count = field.columns[1].whole ? std::ceil(count / 2) : count / 2;
      document.set(field.path, fewer);
    }
  }

  /// Random edits, and often some more of what comes with one: a kill volume that is a ball now has a radius.
  /// Those after which the whole is too much are undone.
  void wander(PresetDocument& document, uint32_t steps, const std::function<bool()>& is_bearable) {
    while (steps-- > 0) {
      const std::vector<Field> before = document.fields();
      if (!edit_bearably(document, dice_.one_of(before), is_bearable)) continue;
      const std::vector<Field> after = document.fields();
      for (const Field& field : after)
        if (!find_field(before, field.path) && dice_.chance(50) && document.field(field.path))
          edit_bearably(document, *document.field(field.path), is_bearable);
    }
  }
  bool edit_bearably(PresetDocument& document, Field field, const std::function<bool()>& is_bearable) {
    if (field.in_absent_table || !edit(document, field)) return false;
    if (!is_bearable()) document.undo();
    return true;
  }

  /// Whether the text changed.
  bool edit(PresetDocument& document, const Field& field) {
    const bool may_go = field.present() && !field.required;
    if (std::holds_alternative<Group>(field.value)) {
      if (!field.present()) return note(field, document.add(field.path));
      return may_go && dice_.chance(25) && note(field, document.remove(field.path));
    }
    if (const auto* list = std::get_if<Groups>(&field.value)) {
      if (list->count > field.at_least && dice_.chance(30))
        return note(field, document.remove(fmt::format("{}[{}]", field.path, list->count - 1)));
      return list->count < std::min(field.at_most, kMostInAList) && note(field, document.add(field.path));
    }
    if (may_go && dice_.chance(10)) return note(field, document.remove(field.path));
    return note(field, document.set(field.path, random_value(field, dice_, wildness_)));
  }

  bool note(const Field& field, const PresetDocument::Outcome& outcome) {
    made_.edits += outcome.made, made_.contradictions += !outcome.made;
    if (outcome.made && !is_table(field)) made_.patterns.insert(pattern_of(field.path));
    const std::string limits = fmt::format("from {} to {}", field.limits.min, field.limits.max);
    const std::string key = "`" + parse_path(field.path).back().key + "` is ";
    for (const Diagnostic& diagnostic : outcome.diagnostics)
      if (!outcome.made && diagnostic.message.starts_with(key) &&
          diagnostic.message.find(limits) != std::string::npos)
        made_.disagreements.push_back(diagnostic);
    return outcome.made;
  }

  void add_instance(PresetDocument& document, const std::string& effect) {
    const size_t index = document.scene()->instances.size();
    const int64_t tick = int64_t(dice_.below(kLatestCall));
    document.change("Add an instance", [&](std::string text) {
      text = with_table(text, {{"instance", index}});
      text = with_value(text, {{"instance", index}, {"name"}}, {fmt::format("part {}", index)});
      text = with_value(text, {{"instance", index}, {"effect"}}, {effect});
      return with_value(text, {{"instance", index}, {"call_tick"}}, {tick});
    });
  }

  /// Most of the time, so that there is something to see: at an instance, from near or from within.
  void aim_camera(PresetDocument& document) {
    const std::vector<Instance>& instances = document.scene()->instances;
    if (instances.empty() || dice_.chance(25)) return;
    const glm::vec3 target = dice_.one_of(instances).position;
    const glm::vec3 way{float(dice_.below(7)) - 3, float(dice_.below(5)) - 1, float(1 + dice_.below(3))};
    document.set("camera[0].target", target);
    document.set("camera[0].position", target + way * float(dice_.octaves(-3, 1)));
  }

  /// Half of the time, another place that it glides to.
  void move_camera(PresetDocument& document) {
    if (dice_.chance(50)) return;
    const int64_t tick = document.scene()->camera[0].tick + 1 + int64_t(dice_.below(kLatestCall));
    document.change("Move the camera", [&](std::string text) {
      text = with_table(text, parse_path("camera[1]"));
      text = with_value(text, parse_path("camera[1].tick"), {tick});
      for (const std::string key : {"position", "target"}) {
        const Field* field = document.field("camera[0]." + key);
        text = with_value(text, parse_path("camera[1]." + key),
                          to_toml_value(*field, random_value(*field, dice_, wildness_)));
      }
      return text;
    });
  }

  /// Layers are keys of the scene's own, which no list of fields can have before they are there.
  void move_layers(PresetDocument& document, size_t instance) {
    for (const Layer& layer : library_.effect(document.scene()->instances[instance].effect).layers)
      if (dice_.chance(50))
        document.change("Move a layer", [&](const std::string& text) {
          const Field offset{.path = "", .value = 0.0f, .fallback = 0.0f, .limits = kCameraOffset};
          return with_value(text, {{"instance", instance}, {"layers"}, {layer.name}},
                            to_toml_value(offset, random_value(offset, dice_, wildness_)));
        });
  }

  /// The scene's tick is one at which an instance has particles.
  void look_at_something(PresetDocument& document) {
    std::vector<int64_t> ticks{0};
    for (const Instance& instance : document.scene()->instances) {
      if (!instance.call_tick) continue;
      const Effect effect = library_.effect(instance.effect);
      for (uint32_t i = 0; i < effect.emitters.size(); ++i) {
        const SpawnSchedule schedule(lineage_of(effect.emitters, i).spawn);
        const int64_t age = int64_t(dice_.octaves(0, 8));
        ticks.push_back(*instance.call_tick + std::min<int64_t>(age, schedule.last_tick()));
      }
    }
    const int64_t tick =
        std::min<int64_t>(ticks[ticks.size() > 1 ? 1 + dice_.below(ticks.size() - 1) : 0], kMaxTick);
    document.set("default_tick", int64_t(0));
    document.set("duration_ticks", std::max<int64_t>(tick, 1));
    document.set("default_tick", tick);
  }

  Dice dice_;
  uint32_t wildness_;
  PresetLibrary library_;
  RandomScene made_;
};

}  // namespace

RandomScene make_random_scene(uint64_t seed, const fs::path& folder) {
  for (const char* part : {"effects", "fields", "meshes"}) {
    fs::create_directories(folder / part);
    fs::copy(fs::path(PLUME_SOURCE_PRESETS) / part, folder / part);
  }
  fs::create_directories(folder / "scenes");
  Author author(seed, folder);
  const std::vector<std::string> effects{author.effect(), author.effect()};
  author.scene("random", effects);
  return std::move(author).result();
}

}  // namespace plume
