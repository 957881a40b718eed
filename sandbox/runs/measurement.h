// Draws the jobs of a plan on the GPU and measures every method against the exact reference: the engine of
// `compare` and `replay`. What a job leaves is a function of the job: nothing is carried on from one moment
// to the next but what a recording's effects remember.
#ifndef PLUME_RUNS_MEASUREMENT_H
#define PLUME_RUNS_MEASUREMENT_H

#include <functional>
#include <stdexcept>

#include "renderer/gpu/pipelines.h"
#include "sandbox/presets/library.h"
#include "sandbox/runs/manifest.h"
#include "sandbox/runs/selection.h"

namespace plume {

/// How far a run is. What is `done` may have been taken over from an earlier run; what is drawn now is what
/// the time that is left can be told from.
struct Headway {
  size_t done = 0, total = 0;
  size_t drawn = 0, to_draw = 0;  ///< by this run
  double within = 0;              ///< how much of the next, which is not done yet: 0 to 1
  std::string what;
};

struct MeasurementOptions {
  Selection selection;
  std::function<void(const Headway&)> progress;
  std::function<bool()> interrupted;  ///< asked between frames
};

/// The user asked to stop; everything finished so far is on disk. Exit code 130.
struct Interrupted : std::runtime_error {
  explicit Interrupted(const char* what = "interrupted; --resume goes on from here")
      : std::runtime_error(what) {}
};

/// Draws what is selected of a plan and not done yet, writes images and error maps beside the manifest, and
/// the manifest. Throws what reading, drawing and writing throw; the manifest then holds all that was
/// finished.
void measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, const Plan& plan,
             const MeasurementOptions& options, Manifest& manifest);

}  // namespace plume
#endif
