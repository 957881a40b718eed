#include "sandbox/measure/pass_groups.h"

#include <algorithm>
#include <map>

namespace plume {

std::optional<PassGroup> group_of(std::string_view pass) {
  using enum PassGroup;
  static const std::map<std::string_view, PassGroup> kGroups{
      {"simulate", kSimulate},
      {"keep particles", kSimulate},
      {"cards", kSimulate},
      {"seen cards", kSimulate},
      {"extinction", kSimulate},
      {"light", kSimulate},
      {"depth", kPrepass},
      {"debris depth", kPrepass},
      {"half_depth", kPrepass},
      {"low_depth", kPrepass},
      {"clear", kPrepass},
      {"sort", kPrepass},
      {"copy", kPrepass},
      {"tiles", kPrepass},
      {"depth_complexity", kPrepass},
      {"range", kPrepass},
      {"nearest", kPrepass},
      {"moments", kPrepass},
      {"unfold", kPrepass},
      {"coverage", kPrepass},
      {"adapt", kPrepass},
      {"occupancy", kPrepass},
      {"depth_warp", kPrepass},
      {"clear_extinction", kPrepass},
      {"sources", kPrepass},
      {"farthest", kPrepass},
      {"splat", kPrepass},
      {"exact_layers", kPrepass},
      {"integrate", kPrepass},
      {"zero_tiles", kPrepass},
      {"zero_depth", kPrepass},
      {"classify", kPrepass},
      {"opaque", kDraws},
      {"debris", kDraws},
      {"draw", kDraws},
      {"accumulate", kDraws},
      {"capture", kDraws},
      {"insert", kDraws},
      {"store", kDraws},
      {"scatter", kDraws},
      {"peel", kDraws},
      {"walk", kDraws},
      {"blend", kDraws},
      {"outputs", kDraws},
      {"surface", kDraws},
      {"distortion", kDraws},
      {"composite", kResolve},
      {"resolve", kResolve},
      {"refract", kResolve},
      {"distort", kResolve},
      {"depth_of_field", kResolve},
      {"display", kResolve},
  };
  const auto found = kGroups.find(pass);
  return found == kGroups.end() ? std::nullopt : std::optional(found->second);
}

bool is_common(std::string_view pass) {
  constexpr std::string_view kCommon[]{"depth",   "debris depth",   "opaque", "debris",
                                       "distort", "depth_of_field", "display"};
  return group_of(pass) == PassGroup::kSimulate || std::ranges::find(kCommon, pass) != std::end(kCommon);
}

}  // namespace plume
