// The last frames' GPU times, pass by pass.
#ifndef PLUME_MEASURE_TIMING_HISTORY_H
#define PLUME_MEASURE_TIMING_HISTORY_H

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gpu/frame.h"

namespace plume {

class TimingHistory {
 public:
  struct Row {
    std::string name;
    double last_ms, median_ms;
  };

  /// One frame's passes; those that share a name are added up. Forgets what is older than 60 frames.
  void add(const std::vector<gpu::PassTime>& passes);
  /// What came before is of another method or picture size.
  void clear() { frames_.clear(); }

  size_t frames() const { return frames_.size(); }
  /// The passes of the last frame in their order, each with its median over the frames that had it, then
  /// their sum.
  std::vector<Row> rows() const;

 private:
  std::deque<std::vector<gpu::PassTime>> frames_;  ///< the sum last
};

}  // namespace plume
#endif
