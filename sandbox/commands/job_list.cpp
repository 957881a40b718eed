#include "sandbox/commands/job_list.h"

#include <fmt/format.h>

#include <algorithm>

namespace plume {
namespace {

using nlohmann::json;

std::vector<FrameResult> frames_of(const Plan& plan, const Selection& selection) {
  std::vector<FrameResult> frames;
  for (size_t m = 0; m < selection.size(); ++m)
    for (const size_t job : selection[m])
      frames.push_back(planned_frame(plan, plan.moments[m], plan.moments[m].jobs[job]));
  return frames;
}

std::string size_text(const FrameResult& frame) {
  return fmt::format("{}x{}", frame.width, frame.height);
}

std::string settings_text(const FrameResult& frame) {
  std::string text;
  const json changed = changed_settings(frame);
  for (const auto& [name, value] : changed.items())
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name,
                        value.is_string() ? value.get<std::string>() : value.dump());
  return text;
}

}  // namespace

std::string job_table(const Plan& plan, const Selection& selection) {
  const std::vector<FrameResult> frames = frames_of(plan, selection);
  size_t ids = 3, scenes = 5;
  for (const FrameResult& frame : frames)
    ids = std::max(ids, frame.job.size()), scenes = std::max(scenes, frame.scene.size());
  std::string table = fmt::format("{:<{}}  {:<{}}  {:>6}  {:>11}  {:>10}  {:<16}  {}\n", "job", ids, "scene",
                                  scenes, "tick", "size", "seed", "method", "settings");
  for (const FrameResult& frame : frames) {
    table +=
        fmt::format("{:<{}}  {:<{}}  {:>6}  {:>11}  {:>10}  {:<16}  {}", frame.job, ids, frame.scene, scenes,
                    frame.tick, size_text(frame), frame.seed, frame.method, settings_text(frame));
    table.erase(table.find_last_not_of(' ') + 1);
    table += '\n';
  }
  return table;
}

json job_list(const Plan& plan, const Selection& selection, const std::string& command) {
  json jobs = json::array();
  for (const FrameResult& frame : frames_of(plan, selection))
    jobs.push_back({{"job", frame.job},
                    {"scene", frame.scene},
                    {"tick", frame.tick},
                    {"shot", frame.shot ? json(frame.shot) : json(nullptr)},
                    {"size", {frame.width, frame.height}},
                    {"seed", frame.seed},
                    {"method", frame.method},
                    {"settings", changed_settings(frame)}});
  return {{"command", command}, {"plan", {{"id", plan.id}, {"jobs", plan.jobs}}}, {"jobs", std::move(jobs)}};
}

}  // namespace plume
