#include "sandbox/presets/library.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/write_scene.h"
#include "tests/fuzz/preset_checks.h"

namespace plume::fuzz {
namespace {

/// Born by a rate, by bursts and on the way, and borne by those: all that a schedule counts.
const Effect& any_effect() {
  static const Effect effect = read_effect_text(R"(
name = "any"
[[emitter]]
name = "parent"
[emitter.look]
opacity = 1
[emitter.spawn]
rate = [[0, 10], [600, 50]]
bursts = [[30, 100]]
per_metre = 20
life = [30, 90]
[[emitter]]
name = "child"
[emitter.parent]
emitter = "parent"
on = "life"
every_ticks = 10
[emitter.look]
opacity = 1
[emitter.spawn]
life = 60
)",
                                                "any.toml");
  return effect;
}

/// Without the places in the file, which a written one has elsewhere.
Scene placeless(Scene scene) {
  scene.id = scene.file = "";
  for (Instance& instance : scene.instances) {
    instance.effect_at = {};
    for (LayerOffset& layer : instance.layers) layer.at = {};
  }
  return scene;
}

}  // namespace

std::string check_scene(Bytes bytes) {
  const std::string file = "fuzzed.toml";
  const std::string_view text = text_of(bytes);
  const auto scene = read_or_refuse(read_scene_text, text, file);
  const std::vector<Field> fields = scene_fields(text, file);  // of a text with mistakes too
  if (!scene) return "refused";
  require_within_limits(fields);
  require(!scene->camera.empty(), "a scene without a camera");
  require(placeless(read_again(read_scene_text, scene_text(*scene))) == placeless(*scene),
          "what is written reads back otherwise");

  std::map<std::string, Effect> effects;
  for (const Instance& instance : scene->instances) effects.emplace(instance.effect, any_effect());
  const auto found = check_references(*scene, PresetLibrary("none"), effects);
  if (!found.empty()) require_clear(found, text, file);
  return "read";
}

}  // namespace plume::fuzz
