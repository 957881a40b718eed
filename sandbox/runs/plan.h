// What a comparison or a replay is going to draw, known before anything is drawn and without a device:
// moments in their order, and the jobs of each. A job is one method with its settings at one moment; its id
// names its files, and names it to `--only`, to other machines and to later runs.
#ifndef PLUME_RUNS_PLAN_H
#define PLUME_RUNS_PLAN_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sandbox/presets/library.h"
#include "sandbox/runs/results.h"

namespace plume {

struct Job {
  std::string id;                     ///< one of a kind in a plan
  size_t method = 0;                  ///< of the replay's methods
  std::string image, error_map, hdr;  ///< files that it leaves; "": not asked for
};

/// What is drawn at once: a tick of a replay with all of its methods, or a shot.
struct Moment {
  size_t replay = 0;       ///< of the plan's
  std::string scene_name;  ///< of Plan::scenes
  std::string scene;       ///< its id
  uint32_t seed = 0, tick = 0;
  glm::uvec2 size{0};
  std::optional<CameraKey> camera;  ///< of one's own
  uint32_t shot = 0;                ///< from 1; 0: none
  ViewChoice view;                  ///< of its method, in the place of the picture
  std::vector<Job> jobs;
  size_t first_job = 0;  ///< how many jobs of the plan come before its own
};

struct Plan {
  std::string id;  ///< the same for what draws the same pictures as often: scripts, presets, methods, sizes
  std::vector<Replay> replays;
  std::vector<std::map<std::string, Scene>> scenes;  ///< of each replay, by the names it has for them
  std::vector<Moment> moments;                       ///< those of a replay stand together
  size_t jobs = 0;

  /// The id of every job, in order.
  std::vector<std::string> order() const;
};

/// Reads all that the replays name, and the folder of shaders they are drawn with ("": the embedded ones).
/// Throws what reading throws, and std::runtime_error when a job is asked for twice.
Plan make_plan(const PresetLibrary& library, std::vector<Replay> replays,
               const std::filesystem::path& shaders = {});

/// What is known of a job before it is drawn.
FrameResult planned_frame(const Plan& plan, const Moment& moment, const Job& job);

}  // namespace plume
#endif
