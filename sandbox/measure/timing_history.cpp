#include "sandbox/measure/timing_history.h"

#include <algorithm>

#include "sandbox/measure/statistics.h"

namespace plume {
namespace {

constexpr size_t kFrames = 60;

template <class Passes>
auto find_pass(Passes& passes, const std::string& name) {
  return std::find_if(passes.begin(), passes.end(), [&](const gpu::PassTime& p) { return p.name == name; });
}

}  // namespace

void TimingHistory::add(const std::vector<gpu::PassTime>& passes) {
  std::vector<gpu::PassTime> frame;
  double sum = 0;
  for (const gpu::PassTime& pass : passes) {
    sum += pass.ms;
    if (const auto same = find_pass(frame, pass.name); same != frame.end())
      same->ms += pass.ms;
    else
      frame.push_back(pass);
  }
  frame.push_back({"sum", sum});
  frames_.push_back(std::move(frame));
  if (frames_.size() > kFrames) frames_.pop_front();
}

std::vector<TimingHistory::Row> TimingHistory::rows() const {
  std::vector<Row> rows;
  if (frames_.empty()) return rows;
  for (const gpu::PassTime& pass : frames_.back()) {
    std::vector<double> times;
    for (const auto& frame : frames_)
      if (const auto found = find_pass(frame, pass.name); found != frame.end()) times.push_back(found->ms);
    rows.push_back({pass.name, pass.ms, summarise(times).median});
  }
  return rows;
}

}  // namespace plume
