// What the benchmarks share: one device, and the memory copy that everything is compared with.
#ifndef PLUME_BENCH_GPU_BENCH_H
#define PLUME_BENCH_GPU_BENCH_H

#include <benchmark/benchmark.h>

#include <functional>

#include "renderer/methods/methods.h"
#include "sandbox/scene/stage.h"

namespace plume {

struct BenchDevice {
  gpu::Device device{{}};
  gpu::Shaders shaders;
  gpu::Pipelines pipelines{device, shaders};
  PresetLibrary library{PLUME_SOURCE_PRESETS};
};

/// Made when the first benchmark asks for it.
BenchDevice& bench_device();

/// Seconds that a device copy takes which moves as many bytes, read and written together. Measured now.
double copy_seconds(uint64_t bytes_moved);

double seconds_of(const std::vector<gpu::PassTime>& passes, std::string_view name);

/// CPU seconds of all threads so far. Of work on a CPU device, what no other program can add to.
double cpu_seconds();

/// Median of runs and of copies between them, as counters: ratio_to_copy, and `unit` per second. Of work that
/// is measured here, also cpu_ns for an item and cpu_ratio_to_copy.
class AgainstCopy {
 public:
  AgainstCopy(benchmark::State& state, const char* unit, double items, double bytes_per_item)
      : state_(state), unit_(unit), items_(items), bytes_per_item_(bytes_per_item) {}
  void add(double seconds);
  /// `work` returns its device seconds, and does nothing else to speak of.
  void measure(const std::function<double()>& work);
  ~AgainstCopy();

 private:
  benchmark::State& state_;
  const char* unit_;
  double items_, bytes_per_item_;
  std::vector<double> seconds_, copies_;
  std::vector<double> cpu_seconds_, cpu_copies_;
};

/// The device's own clock, and as many runs for a short kernel as for a long one: medians need no more.
inline void timed(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseManualTime()->Iterations(15)->Unit(benchmark::kMillisecond);
}

}  // namespace plume
#endif
