// The last frames' GPU times, pass by pass.
#ifndef PLUME_MEASURE_TIMING_HISTORY_H
#define PLUME_MEASURE_TIMING_HISTORY_H

#include <array>
#include <deque>
#include <string>
#include <vector>

#include "renderer/gpu/frame.h"
#include "sandbox/measure/pass_groups.h"

namespace plume {

class TimingHistory {
 public:
  static constexpr size_t kFrames = 256;
  /// The first frames after a change make pipelines and buffers.
  static constexpr size_t kDropped = 2;

  struct Row {
    std::string name;
    double last_ms, median_ms, p95_ms;
  };
  /// Milliseconds of one frame, by PassGroup; the last is what has no group.
  using Groups = std::array<double, kPassGroupNames.size() + 1>;

  /// One frame's passes; those that share a name are added up.
  void add(const std::vector<gpu::PassTime>& passes);
  /// What came before is of another method, parameter or picture size, and so are the next kDropped frames.
  void clear();

  size_t frames() const { return frames_.size(); }
  /// The passes of the last frame in their order, with median and 95th percentile over the frames that had
  /// them, then their sum.
  std::vector<Row> rows() const;
  /// Frame by frame, the oldest first.
  std::vector<Groups> groups() const;
  /// A line a frame, a column a pass; empty where a frame did not have it.
  std::string csv() const;
  /// {"frames": n, "passes": [{"name", "group", "last_ms", "median_ms", "p95_ms"}, ...]}
  std::string json() const;

 private:
  std::deque<std::vector<gpu::PassTime>> frames_;  // the sum last
  size_t to_drop_ = kDropped;
};

}  // namespace plume
#endif
