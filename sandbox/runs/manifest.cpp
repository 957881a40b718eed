#include "sandbox/runs/manifest.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

#include "sandbox/measure/file_bytes.h"

namespace plume {
namespace {

using nlohmann::json;

constexpr std::array kIdentity = {"device", "driver", "api", "build", "commit", "threads"};
constexpr int kRest = 9;  // times as long as a write took before the next

}  // namespace

std::optional<Disagreement> disagreement(const json& first, const json& second) {
  for (const char* name : kIdentity)
    if (json a = first.value(name, json()), b = second.value(name, json()); a != b)
      return Disagreement{.name = name, .first = std::move(a), .second = std::move(b)};
  return std::nullopt;
}

void write_results(const std::filesystem::path& folder, const Results& results) {
  write_file(folder / "results.json", to_json(results).dump(2) + "\n");
  write_file(folder / "results.csv", to_csv(results));
}

Manifest::Manifest(const Plan& plan, std::filesystem::path folder, std::string command)
    : plan_(plan), folder_(std::move(folder)), frames_(plan.jobs) {
  make_folder(folder_);
  lock_.emplace(folder_);
  remove_abandoned(folder_);
  head_.command = std::move(command);
  head_.plan = plan.id;
  head_.order = plan.order();
}

void Manifest::go_on() {
  const std::filesystem::path file = folder_ / "results.json";
  if (!std::filesystem::exists(file)) return;
  Results before = read_results(file);
  if (before.plan != plan_.id)
    throw std::runtime_error(
        fmt::format("{} is of another plan ({} of {} jobs; this is {} of {}): scripts, presets or flags are "
                    "not the same; "
                    "leave out --resume or choose another --out",
                    file.string(), before.plan, before.order.size(), plan_.id, plan_.jobs));
  std::map<std::string, size_t> index;
  for (size_t i = 0; i < head_.order.size(); ++i) index[head_.order[i]] = i;
  for (FrameResult& frame : before.frames) {
    const size_t job = index.at(frame.job);
    frames_[job] = std::move(frame);
  }
  for (MomentResult& moment : before.moments) {
    const size_t job = index.at(moment.job);
    moments_[job] = std::move(moment);
  }
  head_.environment = std::move(before.environment);
  head_.notes = earlier_notes_ = std::move(before.notes);
}

void Manifest::set_environment(const json& environment) {
  if (!head_.environment.is_null())
    if (const auto other = disagreement(head_.environment, environment))
      throw std::runtime_error(fmt::format(
          "{} was measured with {} {}, this is {}: leave out --resume or choose another --out",
          (folder_ / "results.json").string(), other->name, other->first.dump(), other->second.dump()));
  head_.environment = environment;
}

void Manifest::set_notes(std::vector<Note> notes) {
  head_.notes = joined(earlier_notes_, std::move(notes));
}

bool Manifest::is_done(const Moment& moment, size_t job) const {
  const std::optional<FrameResult>& frame = frames_[moment.first_job + job];
  if (!frame || !is_settled(*frame)) return false;
  for (const std::string& file : {frame->image, frame->error_map, frame->hdr})
    if (!file.empty() && !std::filesystem::exists(folder_ / file)) return false;
  return true;
}

Selection Manifest::left_of(Selection selection) const {
  for (size_t m = 0; m < selection.size(); ++m)
    std::erase_if(selection[m], [&](size_t job) { return is_done(plan_.moments[m], job); });
  return selection;
}

void Manifest::record(const Moment& moment, size_t job, FrameResult frame) {
  frames_[moment.first_job + job] = std::move(frame);
}

void Manifest::record(const Moment& moment, MomentResult result) {
  moments_[moment.first_job] = std::move(result);
}

void Manifest::write(When when) {
  const Clock::time_point begin = Clock::now();
  if (when == When::kSparingly && begin - written_ < kRest * writing_) return;
  write_results(folder_, results());
  written_ = Clock::now();
  writing_ = written_ - begin;
}

void Manifest::write_what_is_done() noexcept {
  try {
    write(When::kNow);
  } catch (const std::exception&) {  // most likely what we are here for: a full disk
  }
}

Results Manifest::results() const {
  Results results = head_;
  for (const auto& frame : frames_)
    if (frame) results.frames.push_back(*frame);
  for (const auto& [first_job, moment] : moments_) results.moments.push_back(moment);
  return results;
}

}  // namespace plume
