#include "sandbox/presets/read_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "renderer/methods/method.h"
#include "renderer/methods/methods.h"
#include "renderer/parameters.h"
#include "sandbox/measure/inspector.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/read_sweep.h"
#include "sandbox/presets/read_ticks.h"
#include "sandbox/presets/table_reader.h"

namespace plume {
namespace {

constexpr uint32_t kMaxTicks = 1'000'000;
constexpr size_t kMaxMethods = 1'000, kMaxShots = 100'000;
constexpr uint32_t kMaxSlices = 65'536;             // of any view
constexpr Limits kShown{-3.4e38, 3.4e38, "units"};  // what a view can show: any number

MethodRun read_method(TableReader& table) {
  MethodRun run;
  const bool named = table.text("id", run.id, Need::kRequired);
  const std::vector<Setting> settings = table.settings();
  if (!named) return run;
  const std::unique_ptr<Method> method = make_method(run.id);
  if (!method) {
    table.report("id", fmt::format("unknown method `{}`, {}", run.id, suggestion(run.id, method_ids())));
    return run;
  }
  for (const Setting& setting : settings) try {
      set_parameter(*method, setting.key, setting.value);
      run.settings[setting.key] = setting.value;
    } catch (const ParameterError& error) {
      table.report(setting.position, error.what());
    }
  return run;
}

/// What the method as it is set can show.
ViewChoice read_view(TableReader& table, const MethodRun& run) {
  ViewChoice view;
  const bool named = table.text("id", view.id, Need::kRequired);
  const std::unique_ptr<Method> method = make_method(run.id);
  std::optional<Inspection> known;
  if (named && method) {
    for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
    known = Inspector::find(*method, view.id);
    if (!known) {
      std::vector<std::string> ids;
      for (const Inspection& one : Inspector::inspections(*method)) ids.push_back(one.id);
      table.report("id", fmt::format("`{}` as it is set has no view `{}`, {}", run.id, view.id,
                                     suggestion(view.id, ids)));
    }
  }
  const uint32_t slices = known ? std::max(known->slices, 1u) : kMaxSlices;
  table.integer("slice", view.slice, {0, double(slices - 1), "slices"});
  table.toggle("log", view.logarithmic);
  glm::vec2 range(0, 1);
  if (table.vector("range", range, kShown)) view.range = range;
  return view;
}

/// All methods come before the shots, wherever they stand in the file.
Shot read_shot(TableReader& table, const Replay& replay) {
  Shot shot;
  table.integer("tick", shot.tick, kTick, Need::kRequired);
  uint32_t method = 1;
  table.integer("method", method, {1, double(std::max<size_t>(replay.methods.size(), 1))});
  shot.method = method - 1;
  if (table.text("scene", shot.scene)) {
    const toml::source_position at = table.position("scene");
    shot.scene_at = {table.file(), at.line, at.column};
  }
  table.size("size", shot.size, kPixels);
  table.table("camera", [&](TableReader& camera) { shot.camera = read_camera_key(camera); });
  table.table("view", [&](TableReader& view) {
    shot.view =
        read_view(view, shot.method < replay.methods.size() ? replay.methods[shot.method] : MethodRun{});
  });
  return shot;
}

void read_shots(TableReader& top, Replay& replay) {
  top.tables("shot", kMaxShots,
             [&](TableReader& table) { replay.shots.push_back(read_shot(table, replay)); });
  for (const char* other : {"ticks", "camera"})
    if (top.has(other))
      top.report(other,
                 fmt::format("`{}` stands beside [[shot]], expected one of them: a shot has its own", other));
}

void read_capture(TableReader& table, const std::vector<uint32_t>& ticks, Capture& out) {
  table.ascending("ticks", out.ticks, kTick);
  for (const uint32_t tick : out.ticks)
    if (!ticks.empty() && !std::ranges::binary_search(ticks, tick))
      table.report(
          "ticks",
          fmt::format("tick {} is captured but not played, expected one of the replay's `ticks`", tick));
  table.toggle("images", out.images);
  table.toggle("error_maps", out.error_maps);
  table.toggle("hdr", out.hdr);
}

/// Every shot has them, whatever its size.
void read_pixels(TableReader& table, glm::uvec2 size, std::vector<glm::uvec2>& pixels) {
  table.whole_pairs("pixels", {.name = "x", .limits = {0, double(size.x - 1), "pixels"}, .whole = true},
                    {.name = "y", .limits = {0, double(size.y - 1), "pixels"}, .whole = true}, pixels);
}

}  // namespace

Replay read_replay_text(std::string_view text, const std::string& file) {
  Replay replay;
  replay.id = preset_id(file);
  read_document(text, file, [&](TableReader& top) {
    const Need alone = top.has("sweep") ? Need::kOptional : Need::kRequired;  // a sweep has its own
    top.text("name", replay.name, Need::kRequired);
    top.text("scene", replay.scene, alone);
    const toml::source_position at = top.position("scene");
    replay.scene_at = {file, at.line, at.column};
    uint32_t seed = 0;
    if (top.integer("seed", seed, {0, UINT32_MAX})) replay.seed = seed;
    top.size("size", replay.size, kPixels);
    const bool recording = top.has("shot");
    if (!recording || top.has("ticks")) read_ticks(top, replay.ticks, alone, kMaxTicks);
    top.integer("frames", replay.frames, {1, 100'000});
    top.integer("warmup", replay.warmup, {0, 100'000});
    replay.camera = read_camera(top, false);
    top.tables(
        "method", kMaxMethods, [&](TableReader& table) { replay.methods.push_back(read_method(table)); },
        alone);
    if (recording) read_shots(top, replay);
    if (top.has("sweep")) read_sweeps(top, replay);
    top.table("capture", [&](TableReader& table) {
      read_capture(table, replay.ticks, replay.capture);
      // Sizes of sweeps are looked at once they are known.
      read_pixels(table, replay.sweeps.empty() ? replay.size : glm::uvec2(uint32_t(kPixels.max)),
                  replay.capture.pixels);
    });
  });
  return replay;
}

Replay read_replay(const std::filesystem::path& path) {
  Replay replay = read_replay_text(load_text(path), path.string());
  std::filesystem::path beside = path;
  if (std::filesystem::is_directory(beside.replace_extension())) replay.presets = beside.string();
  return replay;
}

std::vector<Diagnostic> check_references(const Replay& replay, const PresetLibrary& library) {
  const PresetLibrary all = library.behind(replay.presets);
  std::vector<Diagnostic> found;
  const auto look_up = [&](const std::string& scene, const FilePosition& at) {
    try {
      all.find(PresetKind::kScene, scene);
    } catch (const PresetError& error) {
      found.push_back({at.file, at.line, at.column, printable(error.what(), SIZE_MAX)});
    }
  };
  if (!replay.scene.empty()) look_up(replay.scene, replay.scene_at);
  for (const Sweep& sweep : replay.sweeps)
    for (const std::string& scene : sweep.scenes) look_up(scene, sweep.scenes_at);
  for (const Shot& shot : replay.shots)
    if (!shot.scene.empty()) look_up(shot.scene, shot.scene_at);
  return found;
}

}  // namespace plume
