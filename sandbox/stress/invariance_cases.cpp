#include <limits>
#include <random>

#include "sandbox/stress/cases.h"

namespace plume::stress {
namespace {

using Against = StressCase::Against;

/// Smoke and near-opaque things at random; from before to behind `nearest` to `farthest`.
CardScene cloud(uint32_t seed, bool whole_picture) {
  std::mt19937 random(seed);
  const auto between = [&](float low, float high) {
    return low + (high - low) * float(random() % 65536) / 65536.0f;
  };
  CardScene scene{.cards = {}, .background = {0.3f, 0.4f, 0.6f}, .solids = {}, .puffs = !whole_picture};
  for (int i = 0; i < 24; ++i) {
    const double z = double(between(2, 20));
    PlacedCard card = layer(z, double(i % 6 == 0 ? between(0.9f, 0.998f) : between(0.02f, 0.5f)),
                            {between(0, 1), between(0, 1), between(0, 1)}, i % 4 == 1);
    if (i % 5 == 4) card.transmission = {between(0, 1), between(0, 1), between(0, 1)};
    if (i % 7 == 3) card.emission = glm::vec3(between(0, 0.5f));
    if (!whole_picture) {
      card.half_size = glm::vec2(between(0.1f, 0.6f) * float(z));
      card.at = {between(-0.7f, 0.7f) * float(z), between(-0.35f, 0.35f) * float(z)};
    }
    scene.cards.push_back(card);
  }
  return scene;
}

StressCase invariance(const char* id, const char* title, const char* trouble) {
  return {.id = id, .title = title, .trouble = trouble, .against = Against::kItself, .pictures = {}};
}

StressCase draw_order() {
  StressCase made =
      invariance("draw_order", "20 orders of drawing", "the order of draws is no property of a scene");
  for (uint32_t order = 0; order <= 20; ++order) {
    CardScene scene = cloud(1, false);
    scene.order = order;
    made.pictures.push_back({.name = "order " + std::to_string(order), .cards = std::move(scene)});
  }
  return made;
}

StressCase depth_shift() {
  StressCase made =
      invariance("depth_shift", "everything 1 cm to 32 cm farther away", "the same layers in other slices");
  for (const double shift : {0.0, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32}) {
    CardScene scene = cloud(2, true);
    for (PlacedCard& card : scene.cards) card.z += shift;
    made.pictures.push_back(
        {.name = std::to_string(int(100 * shift)) + " cm", .size = {24, 16}, .cards = std::move(scene)});
  }
  return made;
}

StressCase dolly() {
  StressCase made =
      invariance("dolly", "half a metre towards three near-opaque cards and smoke, in 400 steps",
                 "steps far below a slice: any swing is the method's");
  for (int step = 0; step <= 400; ++step) {
    CardScene scene{.cards = {}, .solids = {}};
    const double near = -0.5 * step / 400;
    for (int i = 0; i < 12; ++i)
      scene.cards.push_back(layer(4 + 0.3 * i + near, 0.06, {0.5f, 0.5f, 0.55f}, false));
    for (int k = 0; k < 3; ++k) {
      glm::vec3 color(0.05f);
      color[k] = 0.8f;
      scene.cards.push_back(layer(8 + 0.25 * k + near, 0.995, color, true));
    }
    made.pictures.push_back(
        {.name = "step " + std::to_string(step), .size = {9, 9}, .cards = std::move(scene)});
  }
  return made;
}

StressCase layer_behind() {
  StressCase made = invariance("layer_behind", "layers added behind something opaque, from 15 to 400 m",
                               "what nobody sees changes what is before it");
  for (const double z : {0.0, 15.0, 60.0, 150.0, 400.0}) {
    CardScene scene = cloud(3, true);
    for (PlacedCard& card : scene.cards) card.z = 2 + 0.4 * (card.z - 2);
    scene.cards.push_back(layer(12, 1.0, {0.2f, 0.5f, 0.3f}, true));
    if (z > 0) scene.cards.push_back(layer(z, 0.9, {0.9f, 0.1f, 0.9f}, true));
    made.pictures.push_back({.name = z > 0 ? "at " + std::to_string(int(z)) + " m" : "without",
                             .size = {24, 16},
                             .cards = std::move(scene)});
  }
  return made;
}

StressCase screen_shift() {
  StressCase made = invariance("screen_shift", "everything one to eight pixels to the right",
                               "cells and tiles stand still while what is in them moves");
  for (int shift = 0; shift <= 8; ++shift) {
    StressPicture picture{
        .name = std::to_string(shift) + " pixels", .size = {82, 50}, .cards = cloud(4, false)};
    const double pixel = 2 * std::tan(glm::radians(25.0)) / picture.size.y;  // at a depth of 1 m
    for (PlacedCard& card : picture.cards.cards) card.at.x += float(shift * pixel * card.z);
    picture.shift = {shift, 0};
    made.pictures.push_back(std::move(picture));
  }
  return made;
}

StressCase doubling() {
  StressCase made = invariance("resolution", "the same picture at twice and four times the resolution",
                               "cells have pixels for a unit, things have metres");
  for (const uint32_t scale : {1u, 2u, 4u})
    made.pictures.push_back({.name = std::to_string(scale) + "x",
                             .size = glm::uvec2(24, 16) * scale,
                             .cards = cloud(5, true),
                             .scale = scale});
  return made;
}

StressCase splitting() {
  StressCase made = invariance("splitting", "each layer as two of equal product",
                               "how many cards smoke is made of is no property of smoke");
  CardScene whole = cloud(6, true), split = whole;
  split.cards.clear();
  for (PlacedCard card : whole.cards) {
    card.optical_depth *= 0.5f;
    card.emission *= 0.5f;
    for (const double back : {0.0, 1e-4}) {
      split.cards.push_back(card);
      split.cards.back().z += back;
    }
  }
  for (CardScene* scene : {&whole, &split})  // light passes both halves of a pane, which is another pane
    for (PlacedCard& card : scene->cards)
      card.transmission = glm::vec3(0.0f), card.emission = glm::vec3(0.0f);
  made.pictures = {{.name = "whole", .size = {24, 16}, .cards = whole},
                   {.name = "split", .size = {24, 16}, .cards = split}};
  return made;
}

StressCase not_finite() {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  StressCase made = invariance("not_finite", "a card with NaN, infinity or 1e38 among its numbers",
                               "in a blur, a sum or a sort, one bad particle is bad everywhere");
  const auto add = [&](const char* name, void (*spoil)(PlacedCard&)) {
    CardScene scene = cloud(7, false);
    for (const glm::vec3 transmission : {glm::vec3(0.0f), glm::vec3(0.1f, 0.5f, 0.9f)}) {
      PlacedCard card = layer(3, 0.0, glm::vec3(0.0f), true);  // shows nothing
      card.transmission = transmission;
      if (spoil) {
        card.optical_depth = 0.5f;
        spoil(card);
      }
      scene.cards.push_back(card);
    }
    made.pictures.push_back({.name = name, .cards = std::move(scene)});
  };
  add("without", nullptr);
  add("NaN centre", [](PlacedCard& c) { c.at.x = kNaN; });
  add("Inf centre", [](PlacedCard& c) { c.z = double(kInf); });
  add("-Inf centre", [](PlacedCard& c) { c.z = -double(kInf); });
  add("1e38 centre", [](PlacedCard& c) { c.at.y = 1e38f; });
  add("NaN axis", [](PlacedCard& c) { c.half_size.x = kNaN; });
  add("Inf axis", [](PlacedCard& c) { c.half_size.y = kInf; });
  add("1e38 axes", [](PlacedCard& c) { c.half_size = glm::vec2(1e38f); });
  add("NaN optical depth", [](PlacedCard& c) { c.optical_depth = kNaN; });
  add("Inf optical depth", [](PlacedCard& c) { c.optical_depth = kInf; });
  add("NaN colour", [](PlacedCard& c) { c.color.g = kNaN; });
  add("Inf colour", [](PlacedCard& c) { c.color.r = kInf; });
  add("NaN emission", [](PlacedCard& c) { c.emission.b = kNaN; });
  add("Inf emission", [](PlacedCard& c) { c.emission = glm::vec3(kInf); });
  add("NaN transmission", [](PlacedCard& c) {
    if (source_of(c.transmission) == Source::kRgb)
      c.transmission.r = kNaN;
    else
      c.color.r = kNaN;  // it would be of the other source
  });
  return made;
}

StressCase random_clouds() {
  StressCase made{.id = "random_clouds",
                  .title = "eight clouds of smoke, glass, fire and near-opaque cards",
                  .trouble = "nobody chose them",
                  .against = Against::kExact,
                  .pictures = {}};
  for (uint32_t seed = 10; seed < 18; ++seed)
    made.pictures.push_back(
        {.name = "seed " + std::to_string(seed), .size = {322, 194}, .cards = cloud(seed, false)});
  return made;
}

}  // namespace

std::vector<StressCase> invariance_cases() {
  return {random_clouds(), draw_order(), depth_shift(), dolly(),     layer_behind(),
          screen_shift(),  doubling(),   splitting(),   not_finite()};
}

}  // namespace plume::stress
