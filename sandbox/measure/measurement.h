// Plays replays on the GPU and measures every method against the exact reference: the engine of `compare` and
// `replay`.
#ifndef PLUME_MEASURE_MEASUREMENT_H
#define PLUME_MEASURE_MEASUREMENT_H

#include <filesystem>
#include <functional>

#include "renderer/gpu/pipelines.h"
#include "sandbox/measure/results.h"
#include "sandbox/presets/library.h"

namespace plume {

struct Shard {
  uint32_t index = 0, count = 1;  ///< zero-based
};

struct MeasurementOptions {
  std::filesystem::path out;
  bool resume = false;
  Shard shard;
  std::function<void(size_t done, size_t total, const std::string& what)>
      progress;                       ///< frames finished of all
  std::function<bool()> interrupted;  ///< asked between frames
};

/// The user asked to stop; everything finished so far is on disk. Exit code 130.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted; --resume goes on from here") {}
};

/// Runs every tick or shot of every replay, writes images, error maps, results.json and results.csv below
/// `out`, and returns the results. Throws what reading, drawing and writing throw; results.json then holds
/// all frames that were finished.
Results measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
                const std::vector<Replay>& replays, const MeasurementOptions& options);

}  // namespace plume
#endif
