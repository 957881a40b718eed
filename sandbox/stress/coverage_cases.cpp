#include <cmath>

#include "sandbox/stress/cases.h"

namespace plume::stress {
namespace {

/// One layer of a coverage over another.
StressCase extreme_coverage() {
  StressCase made{
      .id = "alpha_extremes",
      .title = "coverage of 0, 1/255, 1 - 2^-24 and 1",
      .trouble = "0 divides by itself, a little rounds to nothing, and the logarithm of none is infinite",
      .against = StressCase::Against::kExact,
      .pictures = {}};
  for (const auto& [name, coverage] : std::initializer_list<std::pair<const char*, double>>{
           {"0", 0.0}, {"1/255", 1.0 / 255}, {"1-2^-24", 1.0 - std::exp2(-24)}, {"1", 1.0}})
    for (StressPicture& picture : sharp_and_smooth(name, [&](bool sharp) {
           return CardScene{.cards = {layer(5, coverage, {0.8f, 0.1f, 0.1f}, sharp),
                                      layer(7, 0.5, {0.1f, 0.8f, 0.1f}, sharp)},
                            .background = {0.2f, 0.3f, 0.5f},
                            .solids = {}};
         }))
      made.pictures.push_back(std::move(picture));
  return made;
}

CardScene stack(size_t count, double coverage, double nearest, double spacing, bool sharp, bool rainbow) {
  CardScene scene{.cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}};
  for (size_t i = 0; i < count; ++i) {
    glm::vec3 color(0.5f);
    if (rainbow) color[int(i * 3 / count)] = 0.9f;
    scene.cards.push_back(layer(nearest + spacing * double(i), coverage, color, sharp));
  }
  return scene;
}

}  // namespace

std::vector<StressCase> coverage_cases() {
  const auto stacked = [](const char* id, const char* title, const char* trouble, size_t count,
                          double coverage, double spacing, bool rainbow) {
    StressCase made{.id = id,
                    .title = title,
                    .trouble = trouble,
                    .against = StressCase::Against::kExact,
                    .pictures = sharp_and_smooth("", [=](bool sharp) {
                      return stack(count, coverage, 3.0, spacing, sharp, rainbow);
                    })};
    for (StressPicture& picture : made.pictures) picture.size = {17, 9};  // peels draw all of them for each
    return made;
  };
  return {
      extreme_coverage(),
      stacked("thousand_layers", "1000 layers of coverage 0.004",
              "each is under a quantum of 8 bits, together they hide almost all", 1000, 0.004, 0.01, true),
      stacked("one_slice", "255 equal layers of coverage 0.02 in one slice",
              "counters of a slice overflow, lists of k are full of one depth", 255, 0.02, 0.0, false)};
}

}  // namespace plume::stress
