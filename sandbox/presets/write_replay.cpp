#include "sandbox/presets/write_replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/methods/methods.h"
#include "sandbox/presets/toml_text.h"
#include "sandbox/presets/write_scene.h"

namespace plume {
namespace {

/// A setting is kept as the text that somebody wrote, such as "01", which is no number in a file: the method
/// says what it is.
std::string method_text(const MethodRun& run) {
  std::string text = fmt::format("\n[[method]]\nid = {}\n", quoted_text(run.id));
  const auto method = make_method(run.id);
  for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
  const auto values = parameter_texts(*method);
  for (const auto& parameter : parameter_list(*method)) {
    const std::string name = parameter["name"];
    if (!run.settings.contains(name)) continue;
    const std::string& value = values.at(name);
    text += fmt::format("{} = {}\n", name, parameter["type"] == "choice" ? quoted_text(value) : value);
  }
  return text;
}

std::string pair_text(glm::uvec2 pair) {
  return fmt::format("[{}, {}]", pair.x, pair.y);
}

std::string number_text(float number) {
  return to_toml({number});
}

std::string view_text(const ViewChoice& view) {
  std::string text = fmt::format("[shot.view]\nid = {}\n", quoted_text(view.id));
  if (view.slice > 0) text += fmt::format("slice = {}\n", view.slice);
  if (view.logarithmic) text += "log = true\n";
  if (view.range)
    text += fmt::format("range = [{}, {}]\n", number_text(view.range->x), number_text(view.range->y));
  return text;
}

std::string shot_text(const Shot& shot) {
  std::string text = fmt::format("\n[[shot]]\ntick = {}\nmethod = {}\n", shot.tick, shot.method + 1);
  if (!shot.scene.empty()) text += fmt::format("scene = {}\n", quoted_text(shot.scene));
  if (shot.size != glm::uvec2(0)) text += fmt::format("size = {}\n", pair_text(shot.size));
  if (shot.camera) text += "[shot.camera]\n" + camera_text(*shot.camera);
  if (!shot.view.id.empty()) text += view_text(shot.view);
  return text;
}

}  // namespace

std::string replay_text(const Replay& replay) {
  std::string text =
      fmt::format("name = {}\nscene = {}\n", quoted_text(replay.name), quoted_text(replay.scene));
  if (replay.seed) text += fmt::format("seed = {}\n", *replay.seed);
  text += fmt::format("size = {}\n", pair_text(replay.size));
  if (!replay.ticks.empty()) text += fmt::format("ticks = [{}]\n", fmt::join(replay.ticks, ", "));
  text += fmt::format("frames = {}\nwarmup = {}\n", replay.frames, replay.warmup);
  for (const CameraKey& key : replay.camera)
    text += fmt::format("\n[[camera]]\ntick = {}\n{}", key.tick, camera_text(key));
  for (const MethodRun& run : replay.methods) text += method_text(run);
  for (const Shot& shot : replay.shots) text += shot_text(shot);
  text += "\n[capture]\n";
  if (!replay.capture.ticks.empty())
    text += fmt::format("ticks = [{}]\n", fmt::join(replay.capture.ticks, ", "));
  std::vector<std::string> pixels;
  for (const glm::uvec2& pixel : replay.capture.pixels) pixels.push_back(pair_text(pixel));
  if (!pixels.empty()) text += fmt::format("pixels = [{}]\n", fmt::join(pixels, ", "));
  return text + fmt::format("images = {}\nerror_maps = {}\nhdr = {}\n", replay.capture.images,
                            replay.capture.error_maps, replay.capture.hdr);
}

}  // namespace plume
