#include "sandbox/runs/selection.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

#include "renderer/parameters.h"

namespace plume {
namespace {

constexpr size_t kSuggested = 1'000;  // more ids than this are not searched for the nearest

bool is_of(const Shard& shard, size_t job, size_t moment, size_t moments) {
  if (shard.by == Shard::By::kJob) return job % shard.count == shard.index;
  if (shard.by == Shard::By::kTurn) return moment % shard.count == shard.index;
  const auto begin = [&](uint64_t part) { return part * moments / shard.count; };
  return begin(shard.index) <= moment && moment < begin(uint64_t(shard.index) + 1);
}

[[noreturn]] void refuse(const std::string& id, const std::vector<std::string>& ids) {
  const std::string near = ids.size() <= kSuggested ? nearest(id, ids) : "";
  throw std::runtime_error(
      fmt::format("--only {}: there is no such job, {}", id,
                  near.empty() ? fmt::format("expected one that --list prints, such as {}", ids.front())
                               : fmt::format("did you mean `{}`?", near)));
}

}  // namespace

Selection select_jobs(const Plan& plan, const Shard& shard, const std::vector<std::string>& only) {
  std::set<std::string> asked(only.begin(), only.end()), unknown = asked;
  Selection selection(plan.moments.size());
  for (size_t m = 0; m < plan.moments.size(); ++m)
    for (size_t j = 0; j < plan.moments[m].jobs.size(); ++j) {
      const std::string& id = plan.moments[m].jobs[j].id;
      unknown.erase(id);
      if (is_of(shard, plan.moments[m].first_job + j, m, plan.moments.size()) &&
          (only.empty() || asked.contains(id)))
        selection[m].push_back(j);
    }
  if (!unknown.empty()) refuse(*unknown.begin(), plan.order());
  return selection;
}

}  // namespace plume
