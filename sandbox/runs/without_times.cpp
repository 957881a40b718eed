#include "sandbox/runs/without_times.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace plume {
namespace {

/// Keys, wherever they stand.
constexpr std::array<std::string_view, 16> kTimes = {
    "gpu_ms",
    "gpu_ms_interval",
    "gpu_ms_p95",  // of a frame
    "transparency_ms",
    "transparency_ms_interval",
    "transparency_ms_p95",
    "median_ms",
    "p95_ms",
    "min_ms",
    "interval_ms",  // of a pass
    "ms_before",
    "ms_after",
    "accuracy_per_ms",
    "kind",
    "sure",  // of a parameter
    "notes",
};

}  // namespace

nlohmann::json without_times(nlohmann::json results) {
  if (results.is_object())
    for (const std::string_view key : kTimes) results.erase(std::string(key));
  if (results.is_structured())
    for (nlohmann::json& part : results) part = without_times(std::move(part));
  return results;
}

}  // namespace plume
