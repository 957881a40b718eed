#include "sandbox/stress/cases.h"

namespace plume::stress {
namespace {

using Against = StressCase::Against;

StressCase bright_behind() {
  return {.id = "bright_behind",
          .title = "emission of 10^4 behind a coverage of 0.999",
          .trouble = "what lets a thousandth through still shows it; half floats end at 65504",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{
                .cards = {layer(5, 0.999, {0.3f, 0.3f, 0.3f}, sharp), layer(8, 0.5, {0, 0, 0}, sharp)},
                .background = {0.2f, 0.3f, 0.5f},
                .solids = {}};
            scene.cards[1].emission = glm::vec3(1e4f, 5e3f, 1e3f);
            return scene;
          })};
}

StressCase emission_alone() {
  return {.id = "emission_alone",
          .title = "emission without coverage, between layers",
          .trouble = "a weight by coverage is 0 / 0, one by transmittance is not",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{
                .cards = {layer(5, 0.5, {0.8f, 0.1f, 0.1f}, sharp), layer(7, 0, {0, 0, 0}, sharp),
                          layer(9, 0.5, {0.1f, 0.8f, 0.1f}, sharp), layer(11, 0, {0, 0, 0}, sharp)},
                .background = {0.2f, 0.3f, 0.5f},
                .solids = {}};
            scene.cards[1].emission = {0.1f, 0.2f, 0.4f};
            scene.cards[3].emission = {0.4f, 0.3f, 0.1f};
            return scene;
          })};
}

StressCase pure_colours() {
  StressCase made{
      .id = "pure_colours",
      .title = "black, pure red and pure blue transmission",
      .trouble = "the logarithm of none in one channel and all in another; red behind blue is black",
      .against = Against::kExact,
      .pictures = {}};
  const auto glass = [](double z, glm::vec3 transmission, bool sharp) {
    PlacedCard card = layer(z, 1.0, glm::vec3(0.0f), sharp);
    card.transmission = transmission;
    return card;
  };
  const auto add = [&](const char* name, std::vector<std::pair<double, glm::vec3>> panes) {
    for (StressPicture& picture : sharp_and_smooth(name, [&](bool sharp) {
           CardScene scene{.cards = {layer(12, 0.5, {0.9f, 0.9f, 0.9f}, sharp)},
                           .background = {0.2f, 0.6f, 0.5f},
                           .solids = {}};
           for (const auto& [z, transmission] : panes) scene.cards.push_back(glass(z, transmission, sharp));
           return scene;
         }))
      made.pictures.push_back(std::move(picture));
  };
  add("black", {{5, {0, 0, 0}}});
  add("red", {{5, {1, 0, 0}}});
  add("blue", {{5, {0, 0, 1}}});
  add("red, then blue", {{5, {1, 0, 0}}, {8, {0, 0, 1}}});
  add("red and cyan in a slice", {{5, {1, 0, 0}}, {5.003, {0, 1, 1}}});
  return made;
}

StressCase many_colours() {
  return {.id = "many_colours",
          .title = "eight saturated RGB events in one voxel",
          .trouble = "more than four carry from one channel's field into the next's (the talk accepts it)",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{.cards = {layer(9, 0.5, {0.9f, 0.9f, 0.9f}, sharp)},
                            .background = {0.8f, 0.8f, 0.8f},
                            .solids = {}};
            for (int i = 0; i < 8; ++i) {
              PlacedCard card = layer(5 + 0.0004 * i, 1.0, glm::vec3(0.0f), sharp);
              card.transmission = {1.0f, 1e-4f, 0.9f};
              scene.cards.push_back(card);
            }
            return scene;
          })};
}

}  // namespace

std::vector<StressCase> light_cases() {
  return {bright_behind(), emission_alone(), pure_colours(), many_colours()};
}

}  // namespace plume::stress
