#include "sandbox/stress/card_stage.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <numeric>
#include <random>

#include "sandbox/effects/puff_textures.h"
#include "sandbox/scene/view.h"
#include "shaders/methods/tile_sorted/tile_sorted.h"

namespace plume {
namespace {

constexpr uint32_t kTextureSeed = 1;
constexpr uint64_t kMostBytesOfACard = sizeof(shared::TileCard);  // that a method keeps in one buffer

glm::uvec2 pack_half4(glm::vec3 v) {
  return {glm::packHalf2x16({v.x, v.y}), glm::packHalf2x16({v.z, 0.0f})};
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
    cards.push_back(make_card({.z = double(z),
                               .optical_depth = between(0.1f, 0.6f),
                               .color = {between(0, 1), between(0, 1), between(0, 1)},
                               .half_size = glm::vec2(0.01f * pixel * z),
                               .at = pixel * z * glm::vec2(at.x, -at.y)}));
  }
}

/// `most` of them.
CardsBySource by_source(const CardScene& scene, glm::uvec2 size, uint64_t most) {
  CardsBySource cards;
  const auto of = [&](Source source) -> auto& {
    return cards.sources[size_t(source)];
  };
  for (const PlacedCard& card : scene.cards) of(source_of(card.transmission)).push_back(make_card(card));
  const size_t crowd = std::min<uint64_t>(scene.crowd, most - scene.cards.size());
  add_crowd(of(Source::kScalar), uint32_t(crowd), scene.vertical_fov_deg, size);
  if (scene.order == 0) return cards;
  std::mt19937 random(scene.order);
  for (const auto& source : cards.sources) {
    const size_t begin = cards.order.size(), end = begin + source.size();
    for (size_t i = begin; i < end; ++i) cards.order.push_back(uint32_t(i));
    for (size_t i = end; i > begin + 1; --i)
      std::swap(cards.order[i - 1], cards.order[begin + random() % (i - begin)]);
  }
  return cards;
}

}  // namespace

shared::Card make_card(const PlacedCard& c) {
  const glm::vec3 along(std::cos(c.yaw), 0.0f, -std::sin(c.yaw));
  const glm::vec3 upright(std::sin(c.yaw) * std::sin(c.pitch), std::cos(c.pitch),
                          std::cos(c.yaw) * std::sin(c.pitch));
  return {.center = {c.at.x, c.at.y, float(-c.z)},
          .optical_depth = c.optical_depth,
          .axis_u = along * c.half_size.x,
          .inv_feather = 0.0f,
          .axis_v = upright * c.half_size.y,
          .layers = c.layer | c.layer << shared::kLayerBits | (c.apart ? shared::kCardSetApart : 0u),
          .sunlit = {0, 0},
          .ambient = pack_half4(c.color),
          .emission = pack_half4(c.emission),
          .transmission = pack_half4(c.transmission),
          .light = {0, 0},
          .motion = {0, 0}};
}

float optical_depth_of(double coverage) {
  return coverage < 1.0 ? std::min(float(-std::log1p(-coverage)), shared::kOpaqueDepth)
                        : shared::kOpaqueDepth;
}

CardStage::CardStage(gpu::Device& device, gpu::Pipelines& pipelines, const std::vector<Solid>& solids,
                     const shared::ViewData& view, CardsBySource cards)
    : opaque_(device, solids),
      texture_(device, {.owner = "scene",
                        .label = "even density",
                        .format = vk::Format::eR8G8B8A8Unorm,
                        .extent = {2, 2, 1},
                        .layers = shared::kPuffLayers,
                        .usage = vk::ImageUsageFlagBits::eSampled}),
      view_(gpu::make_buffer(device, "scene", "view", std::vector{view})),
      seen_(device) {
  std::vector<shared::Card> all;
  for (size_t i = 0; i < kSources; ++i) {
    transparents_.counts[i] = uint32_t(cards.sources[i].size());
    all.insert(all.end(), cards.sources[i].begin(), cards.sources[i].end());
  }
  const uint32_t count = uint32_t(all.size());
  all.resize(std::max<size_t>(all.size(), 1));  // a buffer holds something
  if (cards.order.empty()) {
    cards.order.resize(all.size());
    std::iota(cards.order.begin(), cards.order.end(), 0u);
  }
  cards_ = gpu::make_buffer(device, "scene", "cards", all);
  order_ = gpu::make_buffer(device, "scene", "submission", cards.order);
  transparents_.cards = &cards_, transparents_.puffs = &texture_, transparents_.view = &view_;
  transparents_.count = count;
  seen_.fit(transparents_);
  gpu::Frame frame(device, pipelines);
  frame.pass("even density", [&](gpu::Pass& pass) {  // 1, without a normal, open all round
    pass.clear(texture_, {85.0f / 255, 128.0f / 255, 128.0f / 255, 1.0f});
  });
  frame.finish();
}

CardStage::CardStage(gpu::Device& device, gpu::Pipelines& pipelines, const CardScene& scene, glm::uvec2 size)
    : CardStage(device, pipelines, scene.solids, view_of(scene, size),
                by_source(scene, size, pipelines.limits().maxStorageBufferRange / kMostBytesOfACard)) {
  if (scene.puffs) texture_ = make_puff_textures(device, pipelines, kTextureSeed);
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
