#include "sandbox/runs/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/runs/folder_lock.h"
#include "sandbox/runs/manifest.h"
#include "sandbox/runs/sensitivity.h"
#include "sandbox/runs/without_times.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr size_t kNamed = 10;  // of the jobs that are missing

struct Part {
  fs::path folder;
  Results results;
};

fs::path file_of(const Part& part) {
  return part.folder / "results.json";
}

void require_one_plan(const Part& first, const Part& part) {
  const Results &a = first.results, &b = part.results;
  if (a.plan != b.plan || a.command != b.command)
    throw std::runtime_error(
        fmt::format("{} is of `{}`, plan {}; {} is of `{}`, plan {}: expected parts of one plan",
                    file_of(first).string(), a.command, a.plan, file_of(part).string(), b.command, b.plan));
}

void require_one_environment(const Part& first, const Part& part) {
  const auto other = disagreement(first.results.environment, part.results.environment);
  if (other)
    throw std::runtime_error(
        fmt::format("{} was measured with {} {}, {} with {}: their numbers do not stand side by side",
                    file_of(first).string(), other->name, other->first.dump(), file_of(part).string(),
                    other->second.dump()));
}

/// A device that is a GPU may stand in different machines; a CPU may not.
std::optional<std::string> differing_processors(const std::vector<Part>& parts) {
  std::set<std::string> names;
  for (const Part& part : parts) names.insert(part.results.environment.value("cpu", ""));
  if (names.size() < 2) return std::nullopt;
  return fmt::format("Parts were drawn on different processors: {}.", fmt::join(names, ", "));
}

std::vector<std::string> files_of(const FrameResult& frame) {
  std::vector<std::string> files;
  for (const std::string& file : {frame.image, frame.error_map, frame.hdr})
    if (!file.empty()) files.push_back(file);
  return files;
}

/// A job, and who has it.
struct Drawn {
  const Part* part = nullptr;
  const FrameResult* frame = nullptr;
};

void require_equal(const Drawn& first, const Drawn& second) {
  const auto differ = [&](const std::string& what) {
    throw std::runtime_error(fmt::format("{} and {} both have {}, but not the same {}",
                                         first.part->folder.string(), second.part->folder.string(),
                                         first.frame->job, what));
  };
  if (without_times(to_json(*first.frame)) != without_times(to_json(*second.frame))) differ("results");
  for (const std::string& file : files_of(*first.frame))
    if (read_file(first.part->folder / file) != read_file(second.part->folder / file)) differ(file);
}

/// Every job that is settled.
std::map<std::string, Drawn> drawn_jobs(const std::vector<Part>& parts) {
  std::map<std::string, Drawn> drawn;
  for (const Part& part : parts)
    for (const FrameResult& frame : part.results.frames) {
      if (!is_settled(frame)) continue;
      const auto [first, added] = drawn.insert({frame.job, {&part, &frame}});
      if (!added) require_equal(first->second, {&part, &frame});
    }
  return drawn;
}

void require_all(const std::vector<std::string>& order, const std::map<std::string, Drawn>& drawn) {
  std::vector<std::string> missing;
  for (const std::string& job : order)
    if (!drawn.contains(job)) missing.push_back(job);
  if (missing.empty()) return;
  const size_t count = missing.size();
  if (count > kNamed) missing.resize(kNamed);
  throw std::runtime_error(
      fmt::format("{} of {} jobs are missing or failed: {}{}; draw them with --resume or --only", count,
                  order.size(), fmt::join(missing, ", "), count > kNamed ? ", …" : ""));
}

std::map<std::string, MomentResult> moments_of(const std::vector<Part>& parts) {
  std::map<std::string, MomentResult> moments;
  for (const Part& part : parts)
    for (const MomentResult& moment : part.results.moments) {
      const auto [first, added] = moments.insert({moment.job, moment});
      if (!added && first->second.demand != moment.demand)
        throw std::runtime_error(fmt::format("{} has other particles at {} tick {} than a part before it",
                                             file_of(part).string(), moment.scene, moment.tick));
    }
  return moments;
}

}  // namespace

Results merge(const std::vector<fs::path>& folders, const fs::path& out) {
  std::vector<Part> parts;
  for (const fs::path& folder : folders) {
    std::error_code absent;
    if (fs::equivalent(folder, out, absent))
      throw std::runtime_error(
          fmt::format("--out {} is one of the parts, expected another folder", out.string()));
    parts.push_back({folder, read_results(folder / "results.json")});
    require_one_plan(parts.front(), parts.back());
    require_one_environment(parts.front(), parts.back());
  }
  const std::map<std::string, Drawn> drawn = drawn_jobs(parts);
  Results all = parts.front().results;
  require_all(all.order, drawn);
  std::map<std::string, MomentResult> moments = moments_of(parts);
  all.frames.clear(), all.moments.clear();
  for (const Part& part : parts) all.notes = joined(std::move(all.notes), part.results.notes);
  if (const auto processors = differing_processors(parts))
    all.notes = joined(std::move(all.notes), {{"processors", *processors}});

  make_folder(out);
  const FolderLock lock(out);
  remove_abandoned(out);
  write_results(out, all);  // without frames: what an earlier run left here is over from now on
  for (const std::string& job : all.order) {
    const Drawn& found = drawn.at(job);
    for (const std::string& file : files_of(*found.frame))
      write_file(out / file, read_file(found.part->folder / file));
    all.frames.push_back(*found.frame);
    if (const auto moment = moments.find(job); moment != moments.end()) all.moments.push_back(moment->second);
  }
  if (!all.sensitivity.is_null()) all.sensitivity = to_json(parameter_changes(all));
  write_results(out, all);
  return all;
}

}  // namespace plume
