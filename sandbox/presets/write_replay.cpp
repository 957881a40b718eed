#include "sandbox/presets/write_replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/methods/methods.h"
#include "sandbox/presets/toml_text.h"
#include "sandbox/presets/write_scene.h"

namespace plume {
namespace {

/// A setting is kept as text; whether it is one in the file too is for the parameter to say.
std::string setting_text(Method& method, const std::string& name, const std::string& value) {
  for (const auto& parameter : parameter_list(method))
    if (parameter["name"] == name && parameter["type"] == "choice") return quoted_text(value);
  return value;
}

std::string size_text(glm::uvec2 size) {
  return fmt::format("[{}, {}]", size.x, size.y);
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
  if (shot.size != glm::uvec2(0)) text += fmt::format("size = {}\n", size_text(shot.size));
  if (shot.camera) text += "[shot.camera]\n" + camera_text(*shot.camera);
  if (!shot.view.id.empty()) text += view_text(shot.view);
  return text;
}

}  // namespace

std::string replay_text(const Replay& replay) {
  std::string text =
      fmt::format("name = {}\nscene = {}\n", quoted_text(replay.name), quoted_text(replay.scene));
  if (replay.seed) text += fmt::format("seed = {}\n", *replay.seed);
  text += fmt::format("size = {}\n", size_text(replay.size));
  if (!replay.ticks.empty()) text += fmt::format("ticks = [{}]\n", fmt::join(replay.ticks, ", "));
  text += fmt::format("frames = {}\nwarmup = {}\n", replay.frames, replay.warmup);
  for (const CameraKey& key : replay.camera)
    text += fmt::format("\n[[camera]]\ntick = {}\n{}", key.tick, camera_text(key));
  for (const MethodRun& run : replay.methods) {
    text += fmt::format("\n[[method]]\nid = {}\n", quoted_text(run.id));
    const auto method = make_method(run.id);
    for (const auto& [name, value] : run.settings)
      text += fmt::format("{} = {}\n", name, setting_text(*method, name, value));
  }
  for (const Shot& shot : replay.shots) text += shot_text(shot);
  text += "\n[capture]\n";
  if (!replay.capture.ticks.empty())
    text += fmt::format("ticks = [{}]\n", fmt::join(replay.capture.ticks, ", "));
  return text + fmt::format("images = {}\nerror_maps = {}\nhdr = {}\n", replay.capture.images,
                            replay.capture.error_maps, replay.capture.hdr);
}

}  // namespace plume
