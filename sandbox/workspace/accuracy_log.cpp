#include "sandbox/workspace/accuracy_log.h"

#include <algorithm>

#include "renderer/parameters.h"
#include "sandbox/measure/flip.h"
#include "sandbox/measure/metrics.h"

namespace plume {
namespace {

auto is_of(const MethodInstance& instance, const nlohmann::json& settings) {
  return [&](const AccuracyLog::Entry& entry) {
    return entry.method == instance.method->id() && entry.settings == settings;
  };
}

}  // namespace

bool AccuracyLog::has(const MethodInstance& instance) const {
  const nlohmann::json settings = parameter_values(*instance.method);
  return std::ranges::any_of(entries_, is_of(instance, settings));
}

void AccuracyLog::add(const MethodInstance& instance, const DrawnPicture& picture, const DrawnPicture& exact,
                      double ms) {
  nlohmann::json settings = parameter_values(*instance.method);
  std::erase_if(entries_, is_of(instance, settings));
  entries_.push_back({.method = std::string(instance.method->id()),
                      .settings = std::move(settings),
                      .rmse = rmse(exact.linear, picture.linear),
                      .flip = flip(exact.display, picture.display).mean,
                      .ms = ms});
}

}  // namespace plume
