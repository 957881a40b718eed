// What a replay script is: one scene, played at chosen ticks with chosen methods, measured and captured
// without a display. Or a recording: pictures one after the other, each as somebody saw it. Or sweeps.
#ifndef PLUME_SCENE_REPLAY_H
#define PLUME_SCENE_REPLAY_H

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sandbox/scene/scene.h"
#include "sandbox/scene/sweep.h"
#include "sandbox/scene/view_choice.h"

namespace plume {

struct MethodRun {
  std::string id;  ///< a method of renderer/methods/methods.cpp
  std::map<std::string, std::string>
      settings;  ///< parameter -> value as text, checked against the method's list
  bool operator==(const MethodRun&) const = default;
};

struct Capture {
  std::vector<uint32_t> ticks;  ///< empty: every tick of the replay
  bool images = true;           ///< PNG of the displayed image
  bool error_maps = true;
  bool hdr = false;                ///< EXR of the linear image
  std::vector<glm::uvec2> pixels;  ///< whose transmittance over depth is kept; inside every picture
  bool operator==(const Capture&) const = default;
};
/// Whether anything is kept of a tick beyond its numbers.
inline bool is_captured(const Capture& capture, uint32_t tick) {
  return capture.ticks.empty() || std::ranges::binary_search(capture.ticks, tick);
}

/// One picture of a recording.
struct Shot {
  uint32_t tick = 0;
  size_t method = 0;  ///< of Replay::methods
  std::string scene;  ///< "": the replay's
  FilePosition scene_at;
  glm::uvec2 size{0};               ///< 0: the replay's
  std::optional<CameraKey> camera;  ///< of one's own, which does not move; nothing: the scene's
  ViewChoice view;                  ///< in the place of the picture
  bool operator==(const Shot&) const = default;
};

struct Replay {
  std::string id;
  std::string name;
  std::string scene;  ///< id of a scene
  FilePosition scene_at;
  std::optional<uint32_t> seed;  ///< instead of the scene's
  glm::uvec2 size{640, 360};
  std::vector<uint32_t> ticks;     ///< ascending strictly; without shots and empty: the scene's default
  uint32_t frames = 3;             ///< timed repetitions of each tick and method
  uint32_t warmup = 1;             ///< repetitions before them that are dropped
  std::vector<CameraKey> camera;   ///< empty: the scene's
  std::vector<MethodRun> methods;  ///< at least one
  std::vector<Shot> shots;         ///< instead of `ticks` with each of `methods`
  std::vector<Sweep> sweeps;       ///< instead of scene, seed, ticks and methods
  Capture capture;
  std::string presets;  ///< folder of scenes and effects that come before the library's; "": none
  bool operator==(const Replay&) const = default;
};

}  // namespace plume
#endif
