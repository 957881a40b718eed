#include "sandbox/runs/times_alike.h"

#include <fmt/format.h>

#include <algorithm>

namespace plume {
namespace {

/// What is drawn in turns: its times compare.
bool same_moment(const FrameResult& a, const FrameResult& b) {
  return a.scene == b.scene && a.tick == b.tick && a.shot == b.shot && a.width == b.width &&
         a.height == b.height;
}

std::string line_of(std::vector<const FrameResult*> drawn) {
  std::ranges::sort(drawn, {}, [](const FrameResult* f) { return f->transparency_ms.median; });
  std::string line;
  bool joined = false;
  for (size_t i = 1; i < drawn.size(); ++i) {
    const bool alike = !tells_apart(drawn[i - 1]->transparency_ms, drawn[i]->transparency_ms);
    if (alike && !joined) line += fmt::format("{}{}", line.empty() ? "" : ", ", name_of(*drawn[i - 1]));
    if (alike) line += " ~ " + name_of(*drawn[i]);
    joined = alike;
  }
  if (line.empty()) return "";
  const FrameResult& frame = *drawn.front();
  const bool too_few = frame.transparency_ms.samples < kSamplesToTellApart;
  return fmt::format("own ms not told apart, {} tick {}: {}\n", frame.scene, frame.tick,
                     too_few ? fmt::format("all, with {} of the {} repetitions that it takes",
                                           frame.transparency_ms.samples, kSamplesToTellApart)
                             : line);
}

}  // namespace

std::string name_of(const FrameResult& frame) {
  std::string name = frame.method;
  const nlohmann::json changed = changed_settings(frame);
  for (const auto& [key, value] : changed.items())
    name += fmt::format(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
  return name;
}

std::string times_alike(const Results& results) {
  std::string text;
  std::vector<const FrameResult*> drawn;  // of one moment
  for (const FrameResult& frame : results.frames) {
    if (frame.status != "ok") continue;
    if (!drawn.empty() && !same_moment(*drawn.front(), frame)) {
      text += line_of(drawn);
      drawn.clear();
    }
    drawn.push_back(&frame);
  }
  return drawn.empty() ? text : text + line_of(drawn);
}

}  // namespace plume
