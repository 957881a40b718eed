#include "sandbox/presets/read_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "renderer/parameters.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/read_motion.h"
#include "sandbox/presets/read_parent.h"
#include "sandbox/presets/table_reader.h"

namespace plume {
namespace {

constexpr std::string_view kShapes[] = {"point", "sphere", "hemisphere", "box",
                                        "cone",  "ring",   "line",       "mesh"};
constexpr std::string_view kOffScreen[] = {"continue", "pause"};
constexpr std::string_view kTextures[] = {"puff", "disc", "soft", "solid"}, kBands[] = {"soft", "solid"};

constexpr size_t kMaxEmitters = 64, kMaxMeshesALook = 16;
constexpr Limits kRate{0, 1e6, "particles a second"};
constexpr Limits kShare{0, 1};
constexpr Limits kRadiance{0, 10'000};

void read_rate(TableReader& spawn, Spawn& out) {
  const Column tick_column{"tick", kTick, true}, rate_column{"per_second", kRate};
  if (spawn.is_array("rate")) {
    std::vector<std::array<double, 2>> keys;
    spawn.pairs("rate", tick_column, rate_column, 2, keys);
    spawn.also_number("rate", kRate);
    for (const auto& [tick, per_second] : keys) out.rate.push_back({static_cast<uint32_t>(tick), per_second});
    return;
  }
  double per_second = 0;
  const bool constant = spawn.number("rate", per_second, kRate);
  spawn.also_pairs("rate", tick_column, rate_column, 2);
  if (!spawn.has("rate") && !spawn.has("duration")) return;
  uint32_t duration = 0;
  const bool lasting = spawn.integer("duration", duration, {1, kTick.max, kTick.unit}, Need::kRequired);
  if (!spawn.has("rate"))
    spawn.report("duration", "`duration` without `rate`, expected `rate` = particles a second");
  if (constant && lasting) out.rate = {{0, per_second}, {duration, per_second}};
}

void read_spawn(TableReader& spawn, Spawn& out) {
  const size_t before = spawn.mistakes();
  read_rate(spawn, out);
  std::vector<std::array<double, 2>> bursts;
  spawn.pairs("bursts", {"tick", kTick, true},
              {"count", {1, static_cast<double>(kMaxAlive), "particles"}, true}, 1, bursts);
  for (const auto& [tick, count] : bursts)
    out.bursts.push_back({static_cast<uint32_t>(tick), static_cast<uint32_t>(count)});
  spawn.number("per_metre", out.per_metre, {0, 10'000, "particles a metre"});
  spawn.range("life", out.life_ticks, {1, kMaxLife, "ticks"}, Need::kRequired);
  if (spawn.mistakes() > before) return;

  uint64_t by_bursts = 0;
  for (const Spawn::Burst& burst : out.bursts) by_bursts += burst.count;
  const char* most = by_bursts > kMaxAlive || !spawn.has("rate") ? "bursts" : "rate";
  try {
    const SpawnSchedule schedule(out);
    if (schedule.births_total() == 0 && out.per_metre == 0)
      spawn.report(
          "rate",
          "no particle is ever born, expected `rate`, `bursts` or `per_metre` that give at least one");
    if (schedule.capacity() > kMaxAlive)
      spawn.report(most,
                   fmt::format("{} particles are alive at once, expected at most {}: lower `{}` or `life`",
                               schedule.capacity(), kMaxAlive, most));
  } catch (const std::overflow_error& error) {
    spawn.report(most, fmt::format("{}: lower `{}`", error.what(), most));
  }
}

/// One name of a mesh, or a list of at most `most`.
bool read_meshes(TableReader& table, std::string_view key, std::vector<MeshName>& out, size_t most,
                 Need need = Need::kOptional) {
  std::vector<std::string> names;
  const bool read = table.texts(key, names, most, need);
  table.offer(key, {}, "mesh");
  if (!read) return false;
  const toml::source_position at = table.position(key);
  for (std::string& name : names) out.push_back({std::move(name), table.file(), at.line, at.column});
  return true;
}

/// Asks only for what the kind uses, so that a key without effect is reported as unknown.
void read_shape(TableReader& shape, Shape& out) {
  const bool known = shape.choice("kind", out.kind, kShapes, Need::kRequired);
  const auto any_of = [&](std::initializer_list<ShapeKind> kinds) {
    return !known || std::ranges::find(kinds, out.kind) != kinds.end();
  };
  using enum ShapeKind;
  const Need need = known ? Need::kRequired : Need::kOptional;
  const Limits radius{0.001, 1000, "m"};
  if (any_of({kSphere, kHemisphere, kRing})) shape.number("radius_m", out.radius_m, radius, need);
  if (known && out.kind == kCone) shape.number("radius_m", out.radius_m, {0, 1000, "m"});
  if (any_of({kSphere, kHemisphere, kCone, kRing})) shape.number("thickness", out.thickness, kShare);
  if (any_of({kBox})) shape.vector("size_m", out.size_m, {0, 1000, "m"}, need);
  if (any_of({kCone})) shape.number("angle_deg", out.angle_deg, {0, 90, "degrees"}, need);
  if (any_of({kLine}) && shape.vector("to_m", out.to_m, {-1000, 1000, "m"}, need) &&
      glm::length(out.to_m) < 1e-3f)
    shape.report("to_m", "a line without length, expected an end at least 0.001 m from its beginning");
  if (any_of({kMesh})) {
    std::vector<MeshName> names;
    if (read_meshes(shape, "mesh", names, 1, need)) out.mesh = names[0];
    shape.number("scale", out.scale, {0.001, 1000, "m"});
  }
  shape.vector("offset_m", out.offset_m, {-1000, 1000, "m"});
}

bool is_clear(const Look& look) {
  const auto is_zero = [](const Gradient::Key& key) { return key.value == glm::vec3(0.0f); };
  return look.opacity && look.opacity->extremes().largest.value <= 0 &&
         std::ranges::all_of(look.emission.keys, is_zero);
}

void read_layer(TableReader& look, const std::vector<Layer>& layers, Look& out) {
  std::vector<std::string> names;
  for (const Layer& known : layers) names.push_back(known.name);
  const bool read = look.text("layer", out.layer);
  look.offer("layer", names, "layer.name");
  if (!read) return;
  const auto layer = std::ranges::find(layers, out.layer, &Layer::name);
  if (layer == layers.end())
    look.report("layer", fmt::format("unknown layer \"{}\", {}", out.layer, suggestion(out.layer, names)));
  else
    out.camera_offset_m += layer->camera_offset_m;
}

/// How much it covers and what it lets pass, of everything but solid pieces.
void read_coverage(TableReader& look, const std::vector<Layer>& layers, Look& out) {
  float cross_section = 0;
  if (look.number("cross_section_m2", cross_section, {1e-6, 10'000, "m^2"}))
    out.cross_section_m2 = cross_section;
  Curve opacity{1.0f};
  if (look.curve("opacity", opacity, kShare)) out.opacity = opacity;
  look.exactly_one("cross_section_m2", "opacity");
  look.curve("fade", out.fade, {0, 100});
  look.number("feather_m", out.feather_m, {0, 100, "m"});
  look.number("near_fade_m", out.near_fade_m, {0, 1000, "m"});
  look.vector("transmission", out.transmission, kShare);
  look.number("diffusion_deg", out.diffusion_deg, {0, 45, "degrees"});
  look.number("camera_offset_m", out.camera_offset_m, kCameraOffset);
  read_layer(look, layers, out);
  look.integer("draw_order", out.draw_order, kDrawOrder);
}

/// Births joined to a band; siblings are a band of their own.
void read_ribbon(TableReader& look, bool is_child, Look& out) {
  out.texture = TextureKind::kSoft;
  uint32_t band = 0;
  if (look.choice("texture", band, kBands) && band == 1) out.texture = TextureKind::kSolid;
  if (!is_child) look.integer("ribbon_births", out.ribbon_births, {2, 1'000'000, "births"});
}

/// A flat card that turns to the camera.
void read_sprite(TableReader& look, Look& out) {
  look.choice("texture", out.texture, kTextures);
  if (look.number("distortion_deg", out.distortion_deg, {0, 45, "degrees"}) && out.distortion_deg > 0 &&
      !is_clear(out))
    look.report("distortion_deg",
                "an emitter that distorts also covers or shines, expected `opacity` = 0 and no `emission`: "
                "give the haze an emitter of its own");
  if (look.number("flipbook_loops", out.flipbook_loops, {0, 100, "loops a life"})) {
    if (look.has("flipbook_fps"))
      look.report("flipbook_loops", "both `flipbook_loops` and `flipbook_fps` given, expected one of them");
    out.flipbook_fps = 0;
  }
  look.number("flipbook_fps", out.flipbook_fps, {0, 240, "frames a second"});
  look.rivals("flipbook_loops", "flipbook_fps");
  look.range("spin_deg_s", out.spin_deg_s, {-3600, 3600, "degrees a second"});
  look.number("stretch_s", out.stretch_s, {0, 10, "s"});
}

/// Asks only for what the kind uses, so that a key without effect is reported as unknown.
void read_look(TableReader& look, const std::vector<Layer>& layers, bool is_child, Look& out) {
  const bool mesh = read_meshes(look, "mesh", out.meshes, kMaxMeshesALook);
  look.curve("radius_m", out.radius_m, {0.001, 100, "m"});
  look.range("radius_scale", out.radius_scale, {0.01, 100});
  look.toggle("lit", out.lit);
  look.gradient("color", out.color, out.lit ? kShare : kRadiance);
  look.gradient("emission", out.emission, kRadiance);
  if (mesh) {
    look.range("tumble_deg_s", out.tumble_deg_s, {-3600, 3600, "degrees a second"});
    look.toggle("opaque", out.opaque);
  }
  if (mesh && out.opaque) return;
  if (!mesh) look.toggle("ribbon", out.ribbon);
  read_coverage(look, layers, out);
  if (mesh)
    look.number("gloss", out.gloss, kShare);
  else if (out.ribbon)
    read_ribbon(look, is_child, out);
  else
    read_sprite(look, out);
}

/// A box about the instance: what leaves it ends. Bounds from forces alone allow for the worst of noise all
/// the way; this is how a file says how far its effect goes.
void read_bounds(TableReader& table, Effect& effect) {
  KillVolume box{.kind = KillVolume::Kind::kBox, .outside = true};
  table.vector("position_m", box.position_m, {-1000, 1000, "m"});
  table.vector("size_m", box.size_m, {0.01, 2000, "m"}, Need::kRequired);
  for (Emitter& emitter : effect.emitters) {
    if (emitter.motion.analytic) continue;  // without noise: its own bounds are close
    KillVolume about_origin = box;
    about_origin.position_m -= emitter.shape.offset_m;
    emitter.motion.kill.push_back(about_origin);
  }
}

void read_top(TableReader& top, Effect& effect) {
  const std::filesystem::path grids = field_folder(top.file());
  top.text("name", effect.name, Need::kRequired);
  top.text("description", effect.description);
  top.choice("off_screen", effect.off_screen, kOffScreen);
  top.tables("layer", kMaxEmitters, [&](TableReader& table) {
    Layer layer;
    table.text("name", layer.name, Need::kRequired);
    table.number("camera_offset_m", layer.camera_offset_m, kCameraOffset, Need::kRequired);
    if (std::ranges::find(effect.layers, layer.name, &Layer::name) != effect.layers.end())
      table.report("name",
                   fmt::format("a second layer is named \"{}\", expected a name of its own", layer.name));
    effect.layers.push_back(std::move(layer));
  });
  top.tables(
      "emitter", kMaxEmitters,
      [&](TableReader& table) {
        Emitter emitter;
        table.text("name", emitter.name, Need::kRequired);
        const bool is_child = table.table(
            "parent", [&](TableReader& parent) { emitter.parent = read_parent(parent, effect.emitters); });
        table.table(
            "look", [&](TableReader& look) { read_look(look, effect.layers, is_child, emitter.look); },
            Need::kRequired);
        table.table(  // after the look: how many children there are depends on whether they are a ribbon
            "spawn",
            [&](TableReader& spawn) {
              is_child ? read_spawn_of_child(spawn, effect.emitters, emitter)
                       : read_spawn(spawn, emitter.spawn);
            },
            Need::kRequired);
        table.table("shape", [&](TableReader& shape) { read_shape(shape, emitter.shape); });
        table.table("motion", [&](TableReader& motion) {
          read_motion(motion, grids, emitter.motion);
          if (is_child && emitter.motion.analytic)
            motion.report("analytic",
                          "`analytic` of a child, whose place follows from its parent's steps: "
                          "expected an emitter without `parent`");
        });
        if (emitter.motion.analytic && emitter.look.opaque)
          table.report("look", "`opaque` pieces keep their states, expected no `analytic` in `motion`");
        if (std::ranges::find(effect.emitters, emitter.name, &Emitter::name) != effect.emitters.end())
          table.report("name", fmt::format("a second emitter is named \"{}\", expected a name of its own",
                                           emitter.name));
        effect.emitters.push_back(std::move(emitter));
      },
      Need::kRequired);
  top.table("bounds", [&](TableReader& table) { read_bounds(table, effect); });
}

}  // namespace

Effect read_effect_text(std::string_view text, const std::string& file) {
  Effect effect;
  effect.id = preset_id(file);
  read_document(text, file, [&](TableReader& top) { read_top(top, effect); });
  return effect;
}

std::vector<Field> effect_fields(std::string_view text, const std::string& file) {
  Effect unused;
  return asked_fields(text, file, [&](TableReader& top) { read_top(top, unused); });
}

std::filesystem::path field_folder(const std::filesystem::path& file) {
  return file.parent_path().parent_path() / "fields";
}

std::vector<MeshName> mesh_names(const Effect& effect) {
  std::vector<MeshName> names;
  for (const Emitter& emitter : effect.emitters) {
    if (emitter.shape.kind == ShapeKind::kMesh) names.push_back(emitter.shape.mesh);
    names.insert(names.end(), emitter.look.meshes.begin(), emitter.look.meshes.end());
  }
  return names;
}

std::vector<Diagnostic> check_references(const Effect& effect, const PresetLibrary& library) {
  std::vector<Diagnostic> found;
  for (const MeshName& mesh : mesh_names(effect)) try {
      library.find(PresetKind::kMesh, mesh.id);
    } catch (const PresetError& error) {
      found.push_back({mesh.file, mesh.line, mesh.column, printable(error.what(), SIZE_MAX)});
    }
  return found;
}

Effect read_effect(const std::filesystem::path& path) {
  return read_effect_text(load_text(path), path.string());
}

}  // namespace plume
