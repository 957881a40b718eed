#include "sandbox/measure/timing_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sandbox/measure/statistics.h"

namespace plume {
namespace {

const std::string kSum = "sum";

template <class Passes>
auto find_pass(Passes& passes, const std::string& name) {
  return std::ranges::find(passes, name, &gpu::PassTime::name);
}

}  // namespace

void TimingHistory::clear() {
  frames_.clear();
  to_drop_ = kDropped;
}

void TimingHistory::add(const std::vector<gpu::PassTime>& passes) {
  if (to_drop_ > 0 && !frames_.empty()) {  // those are shown until better ones come
    frames_.clear();
    --to_drop_;
  }
  std::vector<gpu::PassTime> frame;
  double sum = 0;
  for (const gpu::PassTime& pass : passes) {
    sum += pass.ms;
    if (const auto same = find_pass(frame, pass.name); same != frame.end())
      same->ms += pass.ms;
    else
      frame.push_back(pass);
  }
  frame.push_back({kSum, sum});
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
    const Summary summary = summarise(times);
    rows.push_back({pass.name, pass.ms, summary.median, summary.p95});
  }
  return rows;
}

std::vector<TimingHistory::Groups> TimingHistory::groups() const {
  std::vector<Groups> result;
  for (const auto& frame : frames_) {
    Groups& groups = result.emplace_back(Groups{});
    for (const gpu::PassTime& pass : frame) {
      if (pass.name == kSum) continue;
      const auto group = group_of(pass.name);
      groups[group ? size_t(*group) : groups.size() - 1] += pass.ms;
    }
  }
  return result;
}

std::string TimingHistory::csv() const {
  std::vector<std::string> names;
  for (const auto& frame : frames_)
    for (const gpu::PassTime& pass : frame)
      if (std::ranges::find(names, pass.name) == names.end()) names.push_back(pass.name);
  std::string csv = "frame";
  for (const std::string& name : names) csv += fmt::format(",{} ms", name);
  csv += "\n";
  for (size_t i = 0; i < frames_.size(); ++i) {
    csv += fmt::format("{}", i);
    for (const std::string& name : names) {
      const auto found = find_pass(frames_[i], name);
      csv += found == frames_[i].end() ? "," : fmt::format(",{:.4f}", found->ms);
    }
    csv += "\n";
  }
  return csv;
}

std::string TimingHistory::json() const {
  nlohmann::json passes = nlohmann::json::array();
  for (const Row& row : rows()) {
    const auto group = group_of(row.name);
    passes.push_back({{"name", row.name},
                      {"group", group ? nlohmann::json(kPassGroupNames[size_t(*group)]) : nullptr},
                      {"last_ms", row.last_ms},
                      {"median_ms", row.median_ms},
                      {"p95_ms", row.p95_ms}});
  }
  return nlohmann::json{{"frames", frames()}, {"passes", passes}}.dump(2) + "\n";
}

}  // namespace plume
