#include "renderer/methods/method.h"
#include "renderer/methods/methods.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/write_replay.h"
#include "tests/fuzz/preset_checks.h"

namespace plume::fuzz {
namespace {

/// As the method has them: 1.0 and 1 are the same.
void canonize(MethodRun& run) {
  const auto method = make_method(run.id);
  require(method != nullptr, "a method that is none: " + run.id);
  for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
  const auto texts = parameter_texts(*method);
  for (auto& [name, value] : run.settings) value = texts.at(name);
}

/// Without the places in the file, which a written one has elsewhere.
Replay placeless(Replay replay) {
  replay.id = "";
  replay.scene_at = {};
  for (Shot& shot : replay.shots) shot.scene_at = {};
  for (MethodRun& run : replay.methods) canonize(run);
  return replay;
}

}  // namespace

std::string check_replay(Bytes bytes) {
  const std::string file = "fuzzed.toml";
  const auto replay = read_or_refuse(read_replay_text, text_of(bytes), file);
  if (!replay) return "refused";
  require(replay->methods.empty() != replay->sweeps.empty(), "methods of its own beside sweeps, or neither");
  require(replay->ticks.empty() || replay->shots.empty(), "ticks beside shots");
  for (const Shot& shot : replay->shots)
    require(shot.method < replay->methods.size(), "a shot of a method that there is not");
  for (const glm::uvec2& pixel : replay->capture.pixels)
    require(!replay->sweeps.empty() || (pixel.x < replay->size.x && pixel.y < replay->size.y),
            "a pixel outside the picture");
  if (!replay->sweeps.empty()) {
    double jobs = 0;
    for (const Sweep& sweep : replay->sweeps) jobs += jobs_of(sweep);
    require(jobs >= 1 && jobs <= 100'000, "sweeps of no job, or of too many");
    return "read sweeps";
  }
  require(placeless(read_again(read_replay_text, replay_text(*replay))) == placeless(*replay),
          "what is written reads back otherwise");
  return "read";
}

}  // namespace plume::fuzz
