// AVBOIT on cards that are put where a test wants them, stage by stage or the whole method, and what each
// stage leaves behind, on the host. Card textures are flat, of density 1, in every layer: a card of
// kSoftLayer is a smooth one, one of kSolidLayer a sharp one, and both cover evenly.
#ifndef PLUME_TESTS_AVBOIT_SCENE_H
#define PLUME_TESTS_AVBOIT_SCENE_H

#include <cmath>
#include <cstring>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <optional>
#include <random>

#include "renderer/methods/avboit/plan.h"
#include "sandbox/scene/view.h"
#include "sandbox/stress/card_stage.h"
#include "tests/gpu/gpu_test.h"

namespace plume {

/// The same numbers on every machine.
struct Random {
  std::mt19937 engine;
  explicit Random(uint32_t seed) : engine(seed) {}
  uint32_t word() { return uint32_t(engine()); }
  uint32_t below(uint32_t n) { return word() % n; }
  bool one_in(uint32_t n) { return below(n) == 0; }
  double between(double low, double high) { return low + (high - low) * (word() / 4294967296.0); }
  /// Evenly over octaves.
  double octaves(double low, double high) { return low * std::exp2(between(0, std::log2(high / low))); }
  float f(double low, double high) { return float(between(low, high)); }
  template <class List>
  void shuffle(List& list) {
    for (size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[below(uint32_t(i))]);
  }
};

/// The table from depth to physical slice.
struct Warp {
  shared::DepthWarp head;
  std::vector<float> slice_ends, nodes;

  static Warp from(const std::vector<uint32_t>& words) {
    Warp w;
    constexpr size_t kHead = sizeof(shared::DepthWarp) / 4;
    std::memcpy(&w.head, words.data(), sizeof(w.head));
    w.slice_ends.resize(w.head.used);
    w.nodes.resize(w.head.virtual_slices + 1);
    std::memcpy(w.slice_ends.data(), words.data() + kHead, w.slice_ends.size() * 4);
    std::memcpy(w.nodes.data(), words.data() + kHead + shared::kMostSlices, w.nodes.size() * 4);
    return w;
  }
};

/// slice(z) = n log2(1 + z / a) / log2(1 + b / a), clamped to the volume.
inline double virtual_slice(const shared::Volume& v, uint32_t slices, double depth) {
  const double at =
      slices * std::log2(1.0 + std::max(depth, 0.0) / double(v.curve_a)) / double(v.curve_octaves);
  return std::clamp(at, 0.0, double(slices) - 1.0);
}

inline double slice_at(const shared::Volume& v, const Warp& warp, double depth) {
  const double at = virtual_slice(v, warp.head.virtual_slices, depth);
  const size_t i = size_t(at);
  return double(warp.nodes[i]) + (double(warp.nodes[i + 1]) - double(warp.nodes[i])) * (at - double(i));
}

/// What the camera sees of a card at most.
struct CardBounds {
  bool seen;
  double nearest, farthest;  ///< view depth, m
};

inline CardBounds bounds_of(const shared::Card& card, const shared::ViewData& view) {
  const glm::dvec3 arm = glm::dvec3(card.center) - glm::dvec3(view.camera);
  const auto along = [&](glm::vec3 axis) { return glm::dot(arm, glm::dvec3(axis)); };
  const auto half = [&](glm::vec3 axis) {
    return std::abs(glm::dot(glm::dvec3(card.axis_u), glm::dvec3(axis))) +
           std::abs(glm::dot(glm::dvec3(card.axis_v), glm::dvec3(axis)));
  };
  CardBounds b{.seen = card.optical_depth > 0 || card.emission != glm::uvec2(0) || card.motion.y >> 16 != 0,
               .nearest = std::max(along(view.forward) - half(view.forward), double(view.near_m)),
               .farthest = along(view.forward) + half(view.forward)};
  b.seen = b.seen && b.farthest > double(view.near_m) &&
           std::abs(along(view.right)) - half(view.right) < b.farthest * double(view.tan_half_fov.x) &&
           std::abs(along(view.up)) - half(view.up) < b.farthest * double(view.tan_half_fov.y);
  return b;
}

class AvboitTest : public GpuTest {
 protected:
  enum class Until { kAdapt, kOccupancy, kSplat, kExactLayers, kIntegrate, kZeroDepth, kClassify };

  glm::uvec2 size{64, 36};
  Scene scene = room();
  std::vector<shared::Card> scalar, haze, rgb;
  std::vector<uint32_t> order;  ///< of all cards; empty: as they are
  bool poison = true;           ///< what no pass promises to clear holds NaN before the stages

  static Scene room() {
    Scene scene;
    scene.id = "room";
    scene.near_m = 0.1f;
    scene.tonemap = Tonemap::kNone;
    scene.light.sky = false;
    scene.light.horizon = {0, 0, 0};
    scene.camera = {{.tick = 0, .position = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = 50}};
    return scene;
  }
  void add(const PlacedCard& card) {
    (source_of(card.transmission) == Source::kRgb ? rgb : scalar).push_back(make_card(card));
  }
  void clear_cards() { scalar.clear(), haze.clear(), rgb.clear(), order.clear(); }
  std::vector<shared::Card> cards() const {
    std::vector<shared::Card> all = scalar;
    all.insert(all.end(), haze.begin(), haze.end());
    all.insert(all.end(), rgb.begin(), rgb.end());
    return all;
  }
  shared::ViewData view() const { return make_view(scene, scene.camera[0], size, 0); }

  /// Depth at which the ray through a point of the picture meets a card, or nothing. Points within `inside`
  /// of the card's edge do not count.
  std::optional<double> hit(const shared::Card& card, glm::dvec2 pixel, double margin = 0) const {
    const shared::ViewData eye = view();
    const glm::dvec2 ndc = pixel / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec3 ray(ndc.x * double(eye.tan_half_fov.x), -ndc.y * double(eye.tan_half_fov.y), -1.0);
    const glm::dvec3 u(card.axis_u), v(card.axis_v), c(card.center), normal = glm::cross(u, v);
    const double towards = glm::dot(ray, normal);
    if (std::abs(towards) < 1e-9) return {};
    const double depth = glm::dot(c, normal) / towards;
    const glm::dvec3 on = ray * depth - c;
    if (depth < double(eye.near_m)) return {};
    const double across = std::abs(glm::dot(on, u)) / glm::dot(u, u),
                 up = std::abs(glm::dot(on, v)) / glm::dot(v, v);
    if (std::max(across, up) > 1 - margin) return {};
    return depth;
  }

  /// What is drawn, on the device.
  struct World : CardStage {
    Targets targets;
  };
  std::unique_ptr<World> world() {
    return std::unique_ptr<World>(new World{
        {device, pipelines, scene.solids, view(), {{scalar, haze, rgb}, order}}, Targets(device, size)});
  }

  /// Every resource that the frame does not clear at its beginning is filled with what must not be seen.
  void fill_with_poison(const Needs& needs, const Resources& resources) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    gpu::Frame frame(device, pipelines);
    frame.pass("poison", [&](gpu::Pass& pass) {
      for (const BufferNeed& need : needs.buffers)
        if (!need.clear) pass.fill(resources.buffer(need.name), 0x7fc12345u);  // as a float: not a number
      for (const ImageNeed& need : needs.images)
        if (need.name.starts_with("integral"))
          pass.clear(resources.image(need.name), {kNan, kNan, kNan, kNan});
    });
    frame.finish();
  }
  static void clear_declared(gpu::Frame& frame, const Needs& needs, const Resources& resources) {
    frame.pass("clear", [&](gpu::Pass& pass) {
      for (const BufferNeed& need : needs.buffers)
        if (need.clear) pass.fill(resources.buffer(need.name), *need.clear);
    });
  }

  /// Stages of one frame, and what they left.
  struct Stages {
    avboit::Plan plan;
    Resources resources;
    gpu::Device* device;
    std::unique_ptr<World> world;

    const shared::Volume& volume() const { return plan.volume; }
    std::vector<uint32_t> words(const char* name) const {
      return gpu::read<uint32_t>(*device, resources.buffer(name));
    }
    Warp warp() const { return Warp::from(words("warp")); }
    uint32_t lanes() const { return 32 / plan.settings.lane_bits(); }
  };
  Stages run_stages(const avboit::Settings& settings, Until until) {
    std::unique_ptr<World> w = world();
    Stages s{.plan = avboit::Plan(settings, size, w->transparents()),
             .resources = {},
             .device = &device,
             .world = std::move(w)};
    Needs needs;
    for (const auto add_needs :
         {avboit::add_depth_warp_needs, avboit::add_occupancy_needs, avboit::add_exact_layers_needs,
          avboit::add_splat_needs, avboit::add_integrate_needs, avboit::add_zero_depth_needs,
          avboit::add_classify_needs})
      add_needs(needs, s.plan);
    s.resources.fit(device, "avboit", needs, size);
    if (poison) fill_with_poison(needs, s.resources);
    gpu::Frame frame(device, pipelines);
    const Targets& targets = s.world->targets;
    s.world->prelude().geometry(frame, targets);
    clear_declared(frame, needs, s.resources);
    const Picture picture{.frame = frame,
                          .resources = s.resources,
                          .transparents = s.world->transparents(),
                          .opaque_color = targets.opaque_color,
                          .opaque_depth = targets.opaque_depth,
                          .result = targets.result,
                          .size = size};
    avboit::record_depth_warp(picture, s.plan);
    if (until >= Until::kOccupancy) avboit::record_occupancy(picture, s.plan);
    if (until >= Until::kOccupancy) avboit::record_sources(picture, s.plan);
    if (until >= Until::kSplat) avboit::record_splat(picture, s.plan);
    if (until >= Until::kExactLayers) avboit::record_exact_layers(picture, s.plan);
    if (until >= Until::kIntegrate) avboit::record_integrate(picture, s.plan);
    if (until >= Until::kZeroDepth) avboit::record_zero_depth(picture, s.plan);
    if (until >= Until::kClassify) avboit::record_classify(picture, s.plan);
    frame.finish();
    return s;
  }

  /// The whole method on the cards. With `poisoned`, resources hold NaN before the frame that is given back.
  DrawnPicture draw_cards(std::string_view id, const std::map<std::string, std::string>& settings = {},
                          bool poisoned = false) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance(id, settings);
    const auto shot = [&] {
      render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method);
      return read_picture(device, w->targets);
    };
    if (!poisoned) return shot();
    const Needs needs = method.method->needs(size, w->transparents());
    method.resources.fit(device, method.owner, needs, size);
    fill_with_poison(needs, method.resources);
    return shot();
  }

  /// A layer of an image array.
  template <class T>
  std::vector<T> read_layer(const gpu::Image& image, uint32_t layer) {
    const auto extent = image.extent();
    const size_t texels = size_t(extent.width) * extent.height;
    const gpu::Buffer host(
        device, {.owner = "test", .label = "layer", .bytes = texels * sizeof(T), .host_visible = true});
    gpu::Frame frame(device, pipelines);
    frame.pass("read", [&](gpu::Pass& pass) {
      pass.commands().copyImageToBuffer(
          image.vk(), vk::ImageLayout::eGeneral, host.vk(),
          vk::BufferImageCopy{
              .imageSubresource = {.aspectMask = image.aspect(), .baseArrayLayer = layer, .layerCount = 1},
              .imageExtent = extent});
    });
    frame.finish();
    const auto mapped = host.mapped<T>();
    return {mapped.begin(), mapped.begin() + ptrdiff_t(texels)};
  }

  // One kernel alone, on buffers of the test.

  template <class T>
  gpu::Buffer upload(const char* label, const std::vector<T>& data) {
    return gpu::make_buffer(device, "test", label, data);
  }
  template <class Push>
  void dispatch(const char* shader, const gpu::Constants& constants, const gpu::Bindings& bindings,
                const Push& push, std::array<uint32_t, 3> groups) {
    gpu::Frame frame(device, pipelines);
    frame.pass(shader, [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute(shader, constants), bindings, push, groups);
    });
    frame.finish();
  }
};

}  // namespace plume
#endif
