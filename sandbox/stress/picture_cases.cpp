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

/// A dense puff before a layer near behind it or far away, and before a wall that hides half of both.
StressCase silhouettes() {
  StressCase made{
      .id = "silhouettes",
      .title = "edges of smoke before what is near and what is far, at each of 64 alignments with a cell",
      .trouble = "what is kept for a cell of 8 pixels is of its middle, and edges are pixels wide",
      .against = Against::kExact,
      .pictures = {}};
  const glm::uvec2 size(98, 74);
  const double pixel = 2 * std::tan(glm::radians(25.0)) / size.y;  // at a depth of 1 m
  for (const auto& [name, behind] : {std::pair("near", 5.5), {"far", 200.0}})
    for (int at = 0; at < 64; ++at) {
      CardScene scene{
          .cards = {layer(5, 0.9, {0.7f, 0.7f, 0.7f}, false), layer(behind, 0.6, {0.1f, 0.3f, 0.7f}, false)},
          .background = {0.9f, 0.5f, 0.1f},
          .solids = {},
          .puffs = true};
      scene.cards[0].half_size = glm::vec2(2.6f);  // more than what avboit takes for small
      scene.cards[0].at = 5.0f * float(pixel) * glm::vec2(at % 8, at / 8);
      scene.cards[1].half_size = glm::vec2(4.0f * float(behind));
      Solid wall;
      wall.position = {-3.0f, 0.0f, -5.3f};
      wall.size_m = {6.0f, 20.0f, 0.1f};
      scene.solids = {wall};
      made.pictures.push_back(
          {.name = std::string(name) + ", " + std::to_string(at % 8) + "," + std::to_string(at / 8),
           .size = size,
           .cards = std::move(scene)});
    }
  return made;
}

StressCase crowd() {
  return {
      .id = "crowd",
      .title = "four million sprites in a tile of 8 x 8 pixels, or as many as a buffer of the device holds",
      .trouble = "one tile has all the work, and nearly none of it is seen",
      .against = Against::kExact,
      .pictures = {{.name = "",
                    .cards = {.cards = {layer(30, 0.5, {0.1f, 0.6f, 0.9f}, false)},
                              .background = {0.2f, 0.3f, 0.5f},
                              .solids = {},
                              .crowd = 4'000'000}}}};
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
  return {near_plane(), sprite_sizes(), silhouettes(), crowd(), picture_sizes(), nothing()};
}

}  // namespace plume::stress
