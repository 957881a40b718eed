#include <random>

#include "sandbox/stress/cases.h"

namespace plume::stress {
namespace {

using Against = StressCase::Against;

StressCase near_plane() {
  return {.id = "near_plane",
          .title = "sprites through the near plane and through the camera",
          .trouble = "depths of 0 and below have no logarithm, and half of such a card is not there",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{.cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}};
            const auto add = [&](double z, float yaw, float half, glm::vec3 color) {
              PlacedCard card = layer(z, 0.4, color, sharp);
              card.half_size = glm::vec2(half), card.yaw = yaw;
              scene.cards.push_back(card);
            };
            add(-1, 0, 3, {0.8f, 0, 0});
            add(0, 0, 3, {0, 0.8f, 0});
            add(0.0999, 0, 3, {0, 0, 0.8f});
            add(0.1001, 0, 3, {0.8f, 0.8f, 0});
            add(0.5, 1.4f, 4, {0, 0.8f, 0.8f});   // reaches behind the camera
            add(0.05, 1.2f, 9, {0.8f, 0, 0.8f});  // stands behind the near plane, reaches far before it
            add(6, 0, 2, {0.5f, 0.5f, 0.5f});
            return scene;
          })};
}

StressCase sprite_sizes() {
  return {.id = "sprite_sizes",
          .title = "sprites larger than the screen and smaller than a pixel",
          .trouble = "a box of all cells, and one of none",
          .against = Against::kExact,
          .pictures = sharp_and_smooth("", [](bool sharp) {
            CardScene scene{.cards = {layer(9, 0.5, {0.1f, 0.6f, 0.9f}, sharp)},
                            .background = {0.2f, 0.3f, 0.5f},
                            .solids = {}};
            scene.cards[0].half_size = glm::vec2(1e6f);
            std::mt19937 random(5);
            const auto between = [&](float low, float high) {
              return low + (high - low) * float(random() % 65536) / 65536.0f;
            };
            for (int i = 0; i < 400; ++i) {
              const double z = 3 + 0.05 * i;
              PlacedCard card = layer(z, 0.9, {between(0, 1), between(0, 1), between(0, 1)}, sharp);
              card.half_size = glm::vec2(between(0.1f, 0.7f) * float(z) * 0.014f);  // of a pixel
              card.at = {between(-0.9f, 0.9f) * float(z), between(-0.45f, 0.45f) * float(z)};
              scene.cards.push_back(card);
            }
            return scene;
          })};
}

StressCase picture_sizes() {
  StressCase made{.id = "picture_sizes",
                  .title = "pictures of 1x1, 17x9 and 1919x1079",
                  .trouble = "half a cell, a cell and a bit, and a last cell that ends outside",
                  .against = Against::kExact,
                  .pictures = {}};
  for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(17, 9), glm::uvec2(1919, 1079)})
    for (StressPicture& picture :
         sharp_and_smooth(std::to_string(size.x) + "x" + std::to_string(size.y), [](bool sharp) {
           CardScene scene{.cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}};
           for (int i = 0; i < 4; ++i)
             scene.cards.push_back(layer(4 + i, 0.4, {0.3f * float(i), 0.8f - 0.2f * float(i), 0.4f}, sharp));
           return scene;
         })) {
      picture.size = size;
      made.pictures.push_back(std::move(picture));
    }
  return made;
}

StressCase nothing() {
  return {.id = "nothing",
          .title = "no effect at all",
          .trouble = "dispatches and draws of none",
          .against = Against::kExact,
          .pictures = {
              {.name = "no cards", .cards = {.cards = {}, .background = {0.2f, 0.3f, 0.5f}, .solids = {}}},
              {.name = "empty", .size = {160, 90}, .cards = {}, .scene = "empty"}}};
}

}  // namespace

std::vector<StressCase> picture_cases() {
  return {near_plane(), sprite_sizes(), picture_sizes(), nothing()};
}

}  // namespace plume::stress
