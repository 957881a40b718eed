#include "sandbox/presets/read_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "renderer/parameters.h"
#include "sandbox/effects/lineage.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/table_reader.h"
#include "sandbox/scene/figure.h"
#include "shaders/shared/light.h"

namespace plume {
namespace {

/// What a [[solid]] can be: the kinds of solids, and one that is made of several.
constexpr std::array kSolids{kSolidNames[0], kSolidNames[1], kSolidNames[2], kSolidNames[3],
                             std::string_view("figure")};
constexpr uint32_t kFigure = 4;

constexpr size_t kMaxCameraKeys = 10'000, kMaxPathKeys = 10'000;
constexpr size_t kMaxSolids = 1'000, kMaxPanes = 10'000, kMaxInstances = 1'000;
constexpr Limits kPathTick{0, 1 << 24, "ticks"};  // whole numbers that the simulation's floats hold
constexpr Limits kSeed{0, UINT32_MAX};
constexpr Limits kPlace{-10'000, 10'000, "m"};
constexpr Limits kExtent{0.001, 10'000, "m"};
constexpr Limits kAngle{-360, 360, "degrees"};
constexpr Limits kShare{0, 1};
constexpr Limits kRadiance{0, 10'000};

constexpr float kShortest = 1e-6f;  // below this, squaring would lose the direction

void read_light(TableReader& light, Light& out) {
  light.toggle("sky", out.sky);
  light.vector("zenith", out.zenith, kRadiance);
  light.vector("horizon", out.horizon, kRadiance);
  light.vector("sun_direction", out.sun_direction, {-1000, 1000});
  if (glm::length(out.sun_direction) < kShortest)
    light.report("sun_direction", "`sun_direction` is zero, expected a direction towards the sun");
  light.vector("sun_color", out.sun_color, kRadiance);
  light.toggle("self_shadow", out.self_shadow);
  light.integer("shadow_cells", out.shadow_cells, {shared::kLeastLightCells, shared::kMostLightCells});
  light.number("fire_light", out.fire_light, {0, 100});
}

/// What it is made of stands in the files that are written of scenes, and must be within the limits of
/// solids.
void read_figure(TableReader& table, const std::vector<Solid>& parts, std::vector<Solid>& out) {
  const auto inside = [](const glm::vec3& p) {
    const glm::vec3 far = glm::abs(p);
    return std::max({far.x, far.y, far.z}) <= kPlace.max;
  };
  if (!std::ranges::all_of(parts,
                           [&](const Solid& part) { return inside(part.position) && inside(part.end); }))
    table.report("position",
                 fmt::format("a figure here reaches beyond {} m, expected it farther inside", kPlace.max));
  out.insert(out.end(), parts.begin(), parts.end());
}

/// Asks only for what the kind uses, so that a key without effect is reported as unknown.
void read_solid(TableReader& table, std::vector<Solid>& out) {
  uint32_t kind = kFigure;
  const bool known = table.choice("kind", kind, kSolids, Need::kRequired);
  const auto is = [&](SolidKind wanted) { return !known || kind == static_cast<uint32_t>(wanted); };
  const Need need = known ? Need::kRequired : Need::kOptional;
  const bool figure = kind == kFigure;  // also when the kind is wrong: then every key is asked for

  Solid solid;
  if (known && !figure) solid.kind = static_cast<SolidKind>(kind);
  table.choice("material", solid.material, kMaterialNames);
  table.vector("color", solid.color, kShare);
  table.vector("position", solid.position, kPlace);
  if (is(SolidKind::kPlane) && known) {
    glm::vec2 extents(1.0f);
    if (table.vector("size_m", extents, kExtent, need)) solid.size_m = {extents.x, 0.0f, extents.y};
  }
  if (is(SolidKind::kBox)) table.vector("size_m", solid.size_m, kExtent, need);
  if (is(SolidKind::kBox) || figure) table.number("yaw_deg", solid.yaw_deg, kAngle);
  if (is(SolidKind::kSphere) || is(SolidKind::kCapsule))
    table.number("radius_m", solid.radius_m, kExtent, need);
  if (is(SolidKind::kCapsule)) {
    const bool read = table.vector("end", solid.end, kPlace, need);
    if (read && known && solid.end == solid.position)
      table.report("end", "`end` is the same as `position`, expected another point, or kind = \"sphere\"");
  }
  float height = 1.75f;
  if (figure) table.number("height_m", height, {0.1, 100, "m"});
  if (!known) return;
  if (!figure)
    out.push_back(solid);
  else
    read_figure(table, standing_figure(solid.position, solid.yaw_deg, height, solid.color, solid.material),
                out);
}

Pane read_pane(TableReader& table) {
  Pane pane;
  table.vector("position", pane.position, kPlace);
  table.number("yaw_deg", pane.yaw_deg, kAngle);
  table.number("pitch_deg", pane.pitch_deg, kAngle);
  table.vector("size_m", pane.size_m, kExtent);
  table.vector("color", pane.color, kRadiance);
  table.number("coverage", pane.coverage, kShare);
  table.vector("transmission", pane.transmission, kShare);
  table.number("diffusion_deg", pane.diffusion_deg, {0, 45, "degrees"});
  table.vector("emission", pane.emission, kRadiance);
  table.integer("draw_order", pane.draw_order, kDrawOrder);
  return pane;
}

Instance read_instance(TableReader& table, const std::string& file) {
  Instance instance;
  table.text("effect", instance.effect, Need::kRequired);
  table.offer("effect", {}, "effect");
  const toml::source_position at = table.position("effect");
  instance.effect_at = {file, at.line, at.column};
  instance.name = instance.effect;
  table.text("name", instance.name);
  uint32_t tick = 0;
  if (table.integer("call_tick", tick, kTick)) instance.call_tick = tick;
  if (table.integer("stop_tick", tick, kTick)) instance.stop_tick = tick;
  if (instance.call_tick && instance.stop_tick && *instance.stop_tick <= *instance.call_tick)
    table.report("stop_tick", fmt::format("`stop_tick` is {}, expected more than `call_tick`, {}",
                                          *instance.stop_tick, *instance.call_tick));
  std::vector<std::array<double, 2>> freezes;
  table.pairs("freeze", {"from", kTick, true}, {"until", kTick, true}, 1, freezes);
  for (const auto& [from, until] : freezes) {
    if (until <= from || (!instance.freezes.empty() && from < instance.freezes.back().until))
      table.report("freeze", fmt::format("`freeze` holds [{}, {}], expected spans one after the other, each "
                                         "until a later tick than it begins",
                                         from, until));
    instance.freezes.push_back({static_cast<uint32_t>(from), static_cast<uint32_t>(until)});
  }
  table.vector("position", instance.position, kPlace);
  std::vector<std::pair<double, glm::vec3>> way;
  if (table.points("path", {"tick", kPathTick, true}, {"[x, y, z]", kPlace}, {2, kMaxPathKeys}, way)) {
    std::vector<Path::Key> keys;
    for (const auto& [key, place] : way) keys.push_back({static_cast<uint32_t>(key), place});
    instance.path.emplace(std::move(keys));
  }
  table.number("yaw_deg", instance.yaw_deg, kAngle);
  table.integer("seed", instance.seed, kSeed);
  table.integer("draw_order", instance.draw_order, kDrawOrder);
  table.table("layers", [&](TableReader& layers) {
    for (const std::string& name : layers.keys()) {
      const toml::source_position place = layers.position(name);
      LayerOffset layer{.layer = name, .at = {file, place.line, place.column}};
      if (layers.number(name, layer.camera_offset_m, kCameraOffset))
        instance.layers.push_back(std::move(layer));
    }
  });
  return instance;
}

void check_layers(const Instance& instance, const Effect& effect, std::vector<Diagnostic>& found) {
  std::vector<std::string> names;
  for (const Layer& layer : effect.layers) names.push_back(layer.name);
  for (const auto& [name, offset, at] : instance.layers) {
    if (std::ranges::find(names, name) != names.end()) continue;
    const std::string right = names.empty()
                                  ? fmt::format("expected no `layers`: effect `{}` has none", effect.id)
                                  : fmt::format("{} (of effect `{}`)", suggestion(name, names), effect.id);
    found.push_back({at.file, at.line, at.column, fmt::format("unknown layer `{}`, {}", name, right)});
  }
}

SpawnSchedule schedule_of(const Instance& instance, const Lineage& lineage) {
  const uint32_t call_tick = *instance.call_tick;
  return SpawnSchedule(lineage.spawn,
                       {.path = instance.path ? &*instance.path : nullptr,
                        .stop_tick = instance.stop_tick ? *instance.stop_tick - call_tick : UINT32_MAX,
                        .per_root = lineage.per_root,
                        .life = lineage.life});
}

/// Particles that an instance can have at once, and the ticks of the scene at which it can have any.
struct Load {
  const Instance* instance;
  uint64_t particles = 0;
  uint64_t first_tick = 0, end_tick = 0;
};

/// Nothing, and a diagnostic, where an emitter alone has too many: how far an instance travels, and so what
/// is born on the way, is known here only.
std::optional<Load> load_of(const Instance& instance, const Effect& effect, std::vector<Diagnostic>& found) {
  Load load{.instance = &instance, .first_tick = *instance.call_tick, .end_tick = *instance.call_tick};
  for (uint32_t i = 0; i < effect.emitters.size(); ++i) {
    const auto too_many = [&](const std::string& what) {
      const auto& [file, line, column] = instance.effect_at;
      found.push_back(
          {file, line, column,
           fmt::format(
               "`{}` of effect `{}`: {}: a shorter or slower `path`, or a lower `per_metre` or `life`",
               effect.emitters[i].name, effect.id, what)});
    };
    try {
      const SpawnSchedule schedule = schedule_of(instance, lineage_of(effect.emitters, i));
      if (schedule.capacity() > kMaxAlive)
        return too_many(fmt::format("{} particles are alive at once, expected at most {}",
                                    schedule.capacity(), kMaxAlive)),
               std::nullopt;
      load.particles += schedule.capacity();
      load.end_tick = std::max(load.end_tick, uint64_t{*instance.call_tick} + schedule.last_tick() + 1);
    } catch (const std::overflow_error& error) {
      return too_many(error.what()), std::nullopt;
    }
  }
  for (const Freeze& freeze : instance.freezes) load.end_tick += freeze.until - freeze.from;
  if (effect.off_screen == OffScreen::kPause) load.end_tick = UINT64_MAX;  // whenever one looks
  return load;
}

/// Reports the first instance with which there are more than one buffer of the simulation holds.
void check_total(const std::vector<Load>& loads, std::vector<Diagnostic>& found) {
  for (const Load& last : loads) {
    uint64_t particles = 0;
    const Load* most = &last;
    for (const Load& load : loads) {  // all that are there when the last one begins
      if (load.first_tick > last.first_tick || load.end_tick <= last.first_tick) continue;
      particles += load.particles;
      if (load.particles > most->particles) most = &load;
    }
    if (particles <= kMaxAlive) continue;
    const auto& [file, line, column] = last.instance->effect_at;
    found.push_back(
        {file, line, column,
         fmt::format("{} particles need room at tick {}, {} of them those of `{}`, expected at most {}: call "
                     "fewer instances at a time, or lower what they bear",
                     particles, last.first_tick, most->particles, most->instance->name, kMaxAlive)});
    return;
  }
}

}  // namespace

CameraKey read_camera_key(TableReader& table) {
  CameraKey key;
  table.vector("position", key.position, kPlace, Need::kRequired);
  table.vector("target", key.target, kPlace, Need::kRequired);
  table.number("vertical_fov_deg", key.vertical_fov_deg, {1, 170, "degrees"});
  if (table.has("target") && key.target == key.position)
    table.report("target", "`target` is the same as `position`, expected a point in front of the camera");
  return key;
}

std::vector<CameraKey> read_camera(TableReader& top, bool required) {
  std::vector<CameraKey> keys;
  top.tables(
      "camera", kMaxCameraKeys,
      [&](TableReader& table) {
        uint32_t tick = 0;
        table.integer("tick", tick, kTick);
        CameraKey key = read_camera_key(table);
        key.tick = tick;
        if (!keys.empty() && key.tick <= keys.back().tick)
          table.report("tick", fmt::format("`tick` is {}, expected more than {}, the one before it", key.tick,
                                           keys.back().tick));
        keys.push_back(key);
      },
      required ? Need::kRequired : Need::kOptional);
  return keys;
}

namespace {

void read_top(TableReader& top, Scene& scene) {
  top.text("name", scene.name, Need::kRequired);
  top.text("description", scene.description);
  top.integer("seed", scene.seed, kSeed);
  top.integer("duration_ticks", scene.duration_ticks, {1, kTick.max, kTick.unit});
  top.integer("default_tick", scene.default_tick, kTick);
  if (scene.default_tick > scene.duration_ticks)
    top.report("default_tick", fmt::format("`default_tick` is {}, expected at most `duration_ticks`, {}",
                                           scene.default_tick, scene.duration_ticks));
  top.number("near_m", scene.near_m, {0.001, 100, "m"});
  top.number("far_m", scene.far_m, {0.1, 100'000, "m"});
  if (scene.near_m >= scene.far_m)
    top.report(top.has("near_m") ? "near_m" : "far_m",
               fmt::format("`near_m` is {} and `far_m` is {}, expected `near_m` below `far_m`", scene.near_m,
                           scene.far_m));
  top.number("exposure", scene.exposure, {0.001, 1000});
  top.choice("tonemap", scene.tonemap, kTonemapNames);
  top.vector("wind", scene.wind, {-100, 100, "m/s"});
  top.table("light", [&](TableReader& light) { read_light(light, scene.light); });
  // The one that nobody said too; but one that we wrote stays as it is.
  if (const float length = glm::length(scene.light.sun_direction);
      length >= kShortest && std::abs(length - 1) > 1e-6f)
    scene.light.sun_direction = glm::normalize(scene.light.sun_direction);
  top.table("depth_of_field", [&](TableReader& lens) {
    DepthOfField& out = scene.depth_of_field.emplace();
    lens.number("focus_m", out.focus_m, {0.01, 10'000, "m"}, Need::kRequired);
    lens.number("aperture_mm", out.aperture_mm, {0.1, 1000, "mm"}, Need::kRequired);
  });
  scene.camera = read_camera(top, true);
  top.tables("solid", kMaxSolids, [&](TableReader& table) {
    const size_t before = scene.solids.size();
    read_solid(table, scene.solids);
    if (before <= kMaxSolids && scene.solids.size() > kMaxSolids)
      table.report("kind",
                   fmt::format("there are {} solids with those that figures are made of, expected at most {}",
                               scene.solids.size(), kMaxSolids));
  });
  top.tables("pane", kMaxPanes, [&](TableReader& table) { scene.panes.push_back(read_pane(table)); });
  top.tables("instance", kMaxInstances, [&](TableReader& table) {
    Instance instance = read_instance(table, top.file());
    if (std::ranges::find(scene.instances, instance.name, &Instance::name) != scene.instances.end())
      table.report("name",
                   fmt::format("a second instance is named \"{}\", expected `name` to tell them apart",
                               instance.name));
    scene.instances.push_back(std::move(instance));
  });
}

}  // namespace

Scene read_scene_text(std::string_view text, const std::string& file) {
  Scene scene;
  scene.id = preset_id(file);
  scene.file = file;
  read_document(text, file, [&](TableReader& top) { read_top(top, scene); });
  return scene;
}

std::vector<Field> scene_fields(std::string_view text, const std::string& file) {
  Scene unused;
  return asked_fields(text, file, [&](TableReader& top) { read_top(top, unused); });
}

Scene read_scene(const std::filesystem::path& path) {
  return read_scene_text(load_text(path), path.string());
}

std::vector<Diagnostic> check_references(const Scene& scene, const PresetLibrary& library,
                                         const std::map<std::string, Effect>& edited) {
  std::vector<Diagnostic> found;
  std::map<std::string, Effect> effects = edited;
  std::vector<Load> loads;
  for (const Instance& instance : scene.instances) try {
      if (!edited.contains(instance.effect)) library.find(PresetKind::kEffect, instance.effect);
      if (!instance.call_tick && instance.layers.empty()) continue;
      auto effect = effects.find(instance.effect);
      if (effect == effects.end())
        effect = effects.emplace(instance.effect, library.effect(instance.effect)).first;
      check_layers(instance, effect->second, found);
      if (!instance.call_tick) continue;
      if (const auto load = load_of(instance, effect->second, found)) loads.push_back(*load);
    } catch (const PresetError& error) {
      found.push_back(
          {instance.effect_at.file, instance.effect_at.line, instance.effect_at.column, error.what()});
    } catch (const FileErrors&) {
      // Whatever is wrong in an effect is reported when that is read.
    }
  check_total(loads, found);
  for (Diagnostic& d : found) d.message = printable(d.message, d.message.size());  // names are quoted in it
  return found;
}

}  // namespace plume
