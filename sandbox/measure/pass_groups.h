// What a pass is part of, so that frames of different methods can be read side by side.
#ifndef PLUME_MEASURE_PASS_GROUPS_H
#define PLUME_MEASURE_PASS_GROUPS_H

#include <array>
#include <optional>
#include <string_view>

namespace plume {

enum class PassGroup {
  kSimulate,  ///< particles, their cards, the light on them
  kPrepass,   ///< what a method finds out before it draws; depths
  kDraws,     ///< shading: opaque things, then each transparent fragment
  kResolve    ///< what is made of that: the picture
};
constexpr std::array<std::string_view, 4> kPassGroupNames{"simulate", "prepass", "draws", "resolve"};

/// By the name of the pass; nothing for one that is not known.
std::optional<PassGroup> group_of(std::string_view pass);
/// Whether it does the same for every method: opaque things, cards and their light, what is done to the
/// finished picture. The others are what FrameReport::transparency_ms sums.
bool is_common(std::string_view pass);

}  // namespace plume
#endif
