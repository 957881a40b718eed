#include "sandbox/stress/card_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <numeric>
#include <random>

#include "sandbox/effects/puff_textures.h"
#include "sandbox/scene/view.h"
#include "shaders/effects/puff.h"
#include "shaders/methods/tile_sorted/tile_sorted.h"

namespace plume {
namespace {

constexpr uint32_t kTextureSeed = 1;
constexpr uint64_t kMostBytesOfACard = sizeof(shared::TileCard);  // that a method keeps in one buffer

glm::uvec2 pack_half4(glm::vec3 v) {
  return {glm::packHalf2x16({v.x, v.y}), glm::packHalf2x16({v.z, 0.0f})};
}

shared::Card card_of(const PlacedCard& c) {
  const glm::vec3 along(std::cos(c.yaw), 0.0f, -std::sin(c.yaw));
  const glm::vec3 upright(std::sin(c.yaw) * std::sin(c.pitch), std::cos(c.pitch),
                          std::cos(c.yaw) * std::sin(c.pitch));
  const uint32_t layer = c.sharp ? shared::kSolidLayer : shared::kSoftLayer;
  return {.center = {c.at.x, c.at.y, float(-c.z)},
          .optical_depth = c.optical_depth,
          .axis_u = along * c.half_size.x,
          .inv_feather = 0.0f,
          .axis_v = upright * c.half_size.y,
          .layers = layer | layer << shared::kLayerBits,
          .sunlit = {0, 0},
          .ambient = pack_half4(c.color),
          .emission = pack_half4(c.emission),
          .transmission = pack_half4(c.transmission),
          .light = {0, 0},
          .motion = {0, 0}};
}

shared::ViewData view_of(const CardScene& scene, glm::uvec2 size) {
  Scene room;
  room.near_m = scene.near_m, room.far_m = scene.far_m;
  room.tonemap = Tonemap::kNone;
  room.light.sky = false;
  room.light.horizon = scene.background;
  const CameraKey camera{
      .tick = 0, .position = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = scene.vertical_fov_deg};
  return make_view(room, camera, size, 0);
}

/// Sprites of a hundredth of a pixel, smooth, before the tile that holds the picture's middle.
void add_crowd(std::vector<shared::Card>& cards, uint32_t count, float fov_deg, glm::uvec2 size) {
  constexpr uint32_t kTile = 8;
  std::mt19937 random(7);
  const auto between = [&](float low, float high) {
    return low + (high - low) * float(random() % 65536) / 65536.0f;
  };
  const glm::vec2 middle = glm::vec2(size) / 2.0f, corner = glm::vec2(size / 2u / kTile * kTile) - middle;
  const float pixel = 2 * std::tan(glm::radians(fov_deg) / 2) / float(size.y);  // at 1 m
  cards.reserve(cards.size() + count);
  for (uint32_t i = 0; i < count; ++i) {
    const float z = between(2, 20);
    const glm::vec2 at = corner + float(kTile) * glm::vec2(between(0, 1), between(0, 1));
    cards.push_back(card_of({.z = double(z),
                             .optical_depth = between(0.1f, 0.6f),
                             .color = {between(0, 1), between(0, 1), between(0, 1)},
                             .half_size = glm::vec2(0.01f * pixel * z),
                             .at = pixel * z * glm::vec2(at.x, -at.y),
                             .sharp = false}));
  }
}

struct Sorted {
  std::vector<shared::Card> cards;  ///< at least one
  uint32_t scalar = 0, rgb = 0;
};

/// By source, as transparents want them; `most` of them.
Sorted by_source(const CardScene& scene, glm::uvec2 size, uint64_t most) {
  Sorted sorted;
  const auto add = [&](Source source) {
    for (const PlacedCard& card : scene.cards)
      if (source_of(card.transmission) == source) sorted.cards.push_back(card_of(card));
  };
  add(Source::kScalar);
  add_crowd(sorted.cards, uint32_t(std::min<uint64_t>(scene.crowd, most - scene.cards.size())),
            scene.vertical_fov_deg, size);
  sorted.scalar = uint32_t(sorted.cards.size());
  add(Source::kRgb);
  sorted.rgb = uint32_t(sorted.cards.size()) - sorted.scalar;
  if (sorted.cards.empty()) sorted.cards.push_back({});
  return sorted;
}

std::vector<uint32_t> submission_of(const Sorted& sorted, uint32_t shuffle) {
  std::vector<uint32_t> order(sorted.cards.size());
  std::iota(order.begin(), order.end(), 0u);
  if (shuffle == 0) return order;
  std::mt19937 random(shuffle);
  const auto mix = [&](size_t begin, size_t end) {
    for (size_t i = end; i > begin + 1; --i) std::swap(order[i - 1], order[begin + random() % (i - begin)]);
  };
  mix(0, sorted.scalar), mix(sorted.scalar, sorted.scalar + sorted.rgb);
  return order;
}

}  // namespace

float optical_depth_of(double coverage) {
  return coverage < 1.0 ? std::min(float(-std::log1p(-coverage)), shared::kOpaqueDepth)
                        : shared::kOpaqueDepth;
}

CardStage::CardStage(gpu::Device& device, gpu::Pipelines& pipelines, const CardScene& scene, glm::uvec2 size)
    : opaque_(device, scene.solids),
      texture_(device, {.owner = "scene",
                        .label = "even density",
                        .format = vk::Format::eR8G8B8A8Unorm,
                        .extent = {2, 2, 1},
                        .layers = shared::kPuffLayers,
                        .usage = vk::ImageUsageFlagBits::eSampled}),
      view_(gpu::make_buffer(device, "scene", "view", std::vector{view_of(scene, size)})),
      seen_(device) {
  const Sorted sorted = by_source(scene, size, pipelines.limits().maxStorageBufferRange / kMostBytesOfACard);
  cards_ = gpu::make_buffer(device, "scene", "cards", sorted.cards);
  order_ = gpu::make_buffer(device, "scene", "submission", submission_of(sorted, scene.order));
  transparents_ = {.cards = &cards_,
                   .puffs = &texture_,
                   .view = &view_,
                   .count = sorted.scalar + sorted.rgb,
                   .counts = {sorted.scalar, 0u, sorted.rgb}};
  seen_.fit(transparents_);
  if (scene.puffs) {
    texture_ = make_puff_textures(device, pipelines, kTextureSeed);
    return;
  }
  gpu::Frame frame(device, pipelines);
  frame.pass("even density", [&](gpu::Pass& pass) {  // 1, without a normal, open all round
    pass.clear(texture_, {85.0f / 255, 128.0f / 255, 128.0f / 255, 1.0f});
  });
  frame.finish();
}

Prelude CardStage::prelude() const {
  return {.geometry =
              [this](gpu::Frame& frame, const Targets& targets) {
                seen_.record(frame, transparents_, order_);
                opaque_.record_depth(frame, targets, view_);
              },
          .opaque = [this](gpu::Frame& frame, const Targets& targets,
                           const gpu::Image& depth) { opaque_.record_color(frame, targets, depth, view_); }};
}

}  // namespace plume
