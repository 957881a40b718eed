#include <cmath>

#include "renderer/methods/avboit/settings.h"
#include "sandbox/stress/cases.h"

namespace plume::stress {
namespace {

using Against = StressCase::Against;

constexpr glm::vec3 kPure[] = {{0.8f, 0.05f, 0.05f}, {0.05f, 0.8f, 0.05f}, {0.05f, 0.05f, 0.8f}};

const double kSlices = avboit::Settings().virtual_slice_count();

/// Where a slice of AVBOIT's finest begins at its defaults, m.
double slice_depth(double slice) {
  const avboit::Settings defaults;
  const double a = double(defaults.curve_a), b = double(defaults.curve_b);
  return a * (std::pow(1 + b / a, slice / defaults.virtual_slice_count()) - 1);
}
/// Between two slices that follow each other at this depth, m.
double slice_at(double depth) {
  const avboit::Settings defaults;
  const double a = double(defaults.curve_a), b = double(defaults.curve_b);
  return (depth + a) * (std::pow(1 + b / a, 1.0 / defaults.virtual_slice_count()) - 1);
}

/// Two layers, two slices apart, around each of these slices: just before its beginning, on it and just
/// behind.
StressCase layers_at(const char* id, const char* title, const char* trouble,
                     std::initializer_list<std::pair<const char*, double>> slices) {
  StressCase made{.id = id, .title = title, .trouble = trouble, .against = Against::kExact, .pictures = {}};
  for (const auto& [name, slice] : slices)
    for (const auto& [where, off] : {std::pair(", before", -1e-5), {"", 0.0}, {", behind", 1e-5}})
      for (StressPicture& picture :
           sharp_and_smooth(std::string(name) + where, [&, by = 1 + off](bool sharp) {
             return CardScene{.cards = {layer(slice_depth(slice) * by, 0.7, kPure[0], sharp),
                                        layer(slice_depth(slice + 2) * by, 0.7, kPure[1], sharp)},
                              .background = {0.2f, 0.3f, 0.5f},
                              .solids = {},
                              .far_m = 5000};
           }))
        made.pictures.push_back(std::move(picture));
  return made;
}

StressCase slice_boundaries() {
  return layers_at("slice_boundaries", "layers on boundaries of slices, from the first on",
                   "a boundary belongs to one slice or the other by a rounding",
                   {{"first", 0.0}, {"middle", kSlices / 2}, {"last but three", kSlices - 4}});
}

StressCase last_slice() {
  return layers_at("last_slice", "layers on the last slice and behind it",
                   "all that lies farther than the volume reaches is in one slice",
                   {{"last but two", kSlices - 3}, {"last", kSlices - 1}, {"beyond", kSlices + 40}});
}

StressCase equal_depths() {
  return {.id = "equal_depths",
          .title = "coplanar layers, and tilted ones that meet in a line",
          .trouble = "fragments of one depth must all count, whatever their order; all have one colour",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{.cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}};
            for (int i = 0; i < 4; ++i)
              scene.cards.push_back(layer(5, 0.1 + 0.1 * i, glm::vec3(0.6f), sharp));
            for (int i = 0; i < 3; ++i) {
              scene.cards.push_back(layer(8, 0.3, glm::vec3(0.6f), sharp));
              scene.cards.back().half_size = glm::vec2(20.0f);
              scene.cards.back().yaw = 0.2f * float(i - 1);
            }
            return scene;
          })};
}

StressCase close_panes() {
  StressCase made{
      .id = "close_panes",
      .title = "a clear pane 3.2 mm before one that is almost opaque red",
      .trouble = "the talk's hardest: both are in one slice at any depth where a slice is thicker",
      .against = Against::kExact,
      .pictures = {{.name = "two_panes", .size = {128, 72}, .cards = {}, .scene = "two_panes"}}};
  for (const double z : {1.0, 3.0, 8.0, 20.0}) {
    CardScene scene{.cards = {layer(z, 0.1, {0.1f, 0.1f, 0.1f}, true),
                              layer(z + 0.0032, 0.97, {0.8f, 0.05f, 0.05f}, true)},
                    .background = {0.2f, 0.7f, 0.5f},
                    .solids = {}};
    scene.cards[0].transmission = glm::vec3(0.9f, 0.95f, 0.9f);
    made.pictures.push_back({.name = "at " + std::to_string(int(z)) + " m", .cards = std::move(scene)});
  }
  return made;
}

/// `apart`: in slices of the finest.
StressCase three_cards(const char* id, const char* title, double apart, double coverage) {
  StressCase made{.id = id,
                  .title = title,
                  .trouble = "bleed by moments, swing by wavelets, mix in a slice: the nearest must be pure",
                  .against = Against::kExact,
                  .pictures = {}};
  for (int distance = 0; distance < 10; ++distance) {
    const double z = std::pow(500.0, distance / 9.0);
    for (StressPicture& picture :
         sharp_and_smooth(std::to_string(int(std::lround(z))) + " m", [&](bool sharp) {
           CardScene scene{.cards = {}, .solids = {}, .far_m = 2000};
           for (int k = 0; k < 3; ++k)
             scene.cards.push_back(
                 layer(z + k * apart * slice_at(z), coverage, kPure[(distance + k) % 3], sharp));
           return scene;
         }))
      made.pictures.push_back(std::move(picture));
  }
  return made;
}

StressCase depth_range() {
  return {
      .id = "depth_range",
      .title = "layers from 1 cm to 32 km",
      .trouble = "six and a half decades of depth in one picture",
      .against = Against::kExact,
      .pictures = sharp_and_smooth("", [](bool sharp) {
        CardScene scene{
            .cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}, .near_m = 0.005f, .far_m = 40'000};
        for (int i = 0; i < 14; ++i)
          scene.cards.push_back(layer(0.01 * std::pow(3.2e6, i / 13.0), 0.25, kPure[i % 3], sharp));
        for (PlacedCard& card : scene.cards) card.half_size = glm::vec2(10.0f * float(card.z));
        return scene;
      })};
}

}  // namespace

std::vector<StressCase> depth_cases() {
  return {slice_boundaries(),
          last_slice(),
          equal_depths(),
          close_panes(),
          three_cards("three_cards", "three near-opaque cards two slices apart, from 1 to 500 m", 2.0, 0.998),
          three_cards("three_cards_in_a_slice", "the same within one slice", 0.3, 0.998),
          depth_range()};
}

}  // namespace plume::stress
