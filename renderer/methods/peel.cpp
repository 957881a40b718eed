// Depth peeling: one geometry pass a layer, each of which blends the layer that the one before it found and
// finds the next. From the front: Everitt, "Interactive Order-Independent Transparency", NVIDIA 2001. From
// both ends at once, in half the passes: Bavoil and Myers, "Order Independent Transparency with Dual Depth
// Peeling", NVIDIA 2008. Both were published with depths alone and blending; here layers are ordered by
// (depth, card), as the reference orders them, and every layer is blended in 32 bits and in RGB.
//
// The first pass measures the depth complexity, which is the number of layers of the deepest pixel. A frame
// records as many peels as the deepest one so far took; those it does not need are indirect draws of nothing,
// and when it needs more it is drawn again.
//
// Limits: every layer shades again all that lies behind it. On the pixels of n fragments that is n^2 / 2.
#include "shaders/methods/peel/peel.h"

#include "renderer/methods/methods.h"
#include "renderer/probe.h"
#include "shaders/shared/draw_command.h"

namespace plume {
namespace {

class Peel final : public Method {
 public:
  explicit Peel(bool both_ends) : both_ends_(both_ends) {}

  std::string_view id() const override { return both_ends_ ? "peel_dual" : "peel"; }
  Traits traits() const override {
    return {.title = both_ends_ ? "Dual depth peeling" : "Depth peeling",
            .source = both_ends_ ? "Bavoil and Myers, NVIDIA 2008" : "Everitt, NVIDIA 2001",
            .transmission = "RGB, exact",
            .emission = "exact",
            .limits = both_ends_ ? "a geometry pass for every two layers of the deepest pixel"
                                 : "a geometry pass for every layer of the deepest pixel",
            .exact = true};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    if (device.has_int64_atomics()) return {};
    return {"shaderInt64 and shaderBufferInt64Atomics"};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.integer("layers", layers_,
                    {.min = 0,
                     .max = 4096,
                     .unit = "",
                     .help = both_ends_ ? "most layers peeled from a pixel, in pairs from both ends; those "
                                          "between are dropped and counted; 0 peels all"
                                        : "most layers peeled from a pixel; those behind are dropped and "
                                          "counted; 0 peels all"});
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    const uint64_t pixels = uint64_t(size.x) * size.y;
    constexpr auto kColor = vk::Format::eR32G32B32A32Sfloat;
    constexpr auto kStorage = vk::ImageUsageFlagBits::eStorage;
    Needs needs{
        .images = {{.name = "light", .format = kColor, .usage = kStorage},
                   {.name = "through", .format = kColor, .usage = kStorage},
                   {.name = "layer_depth",
                    .format = vk::Format::eD32Sfloat,
                    .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment}},
        .buffers = {
            {.name = "front", .bytes = pixels * 16, .clear = {}},
            {.name = "depths", .bytes = pixels * 4, .clear = 0},
            {.name = "counts", .bytes = sizeof(shared::PeelCounts), .clear = 0},
            {.name = "draws", .bytes = uint64_t(recorded_) * 2 * sizeof(shared::DrawCommand), .clear = {}}}};
    if (both_ends_) {
      needs.images.push_back({.name = "behind", .format = kColor, .usage = kStorage});
      needs.buffers.push_back({.name = "back", .bytes = pixels * 16, .clear = {}});
    }
    return needs;
  }

  void record(const Picture& picture) override {
    picture.frame.pass("depth_complexity", [&](gpu::Pass& pass) {
      peel(pass, picture, 0);
      count(pass, picture);
    });
    picture.frame.pass("peel", [&](gpu::Pass& pass) {
      for (uint32_t i = 1; i <= recorded_; ++i) {
        peel(pass, picture, i);
        pass.barrier();
      }
    });
    picture.frame.pass("composite", [&](gpu::Pass& pass) {
      struct Push {
        glm::uvec2 size;
        uint32_t most;
      };
      pass.dispatch(pass.pipelines().compute("methods/peel/composite.comp", constants()), bindings(picture),
                    Push{picture.size, most()},
                    {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  /// Peels keep no function of depth: like the reference they know the fragments themselves, all of which are
  /// drawn again here.
  void probe(const Picture& picture, const Probe& probe) const override {
    probe_by_drawing(picture, probe, InFront::kByDepth);
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const shared::PeelCounts counts = read_counts(device, resources);
    return {{"deepest_pixel", counts.deepest},
            {"geometry_passes", peels_of(counts) + 1},
            {"fragments", counts.fragments},
            {"dropped_fragments", counts.dropped},
            {"missed_fragments", counts.missed}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "dropped_fragments",
         .what = "Fragments behind the last layer that is peeled, which are not drawn",
         .remedy = "Raise `layers`, or 0 to peel all"},
        {.statistic = "missed_fragments",
         .what = "Fragments that were counted but not found by any peel, and are not drawn",
         .remedy = "This is a fault of the driver or of Plume: please report it with the scene"}};
    return kShortfalls;
  }

  bool must_redraw(gpu::Device& device, const Resources& resources) override {
    const uint32_t needed = peels_of(read_counts(device, resources));
    if (needed <= recorded_) return false;
    recorded_ = needed + needed / 8;  // room for the next frame of a growing effect
    return true;
  }

 private:
  uint32_t ends() const { return both_ends_ ? 2 : 1; }
  uint32_t most() const {
    return layers_ == 0 ? 0xffff'fffeu : (uint32_t(layers_) + ends() - 1) / ends() * ends();
  }
  uint32_t peels_of(const shared::PeelCounts& counts) const {
    return (std::min(counts.deepest, most()) + ends() - 1) / ends();
  }
  gpu::Constants constants() const { return {both_ends_ ? 1u : 0u}; }
  static shared::PeelCounts read_counts(gpu::Device& device, const Resources& resources) {
    return gpu::read<shared::PeelCounts>(device, resources.buffer("counts"))[0];
  }
  /// Of all shaders; without the back end what it would bind is there, unused.
  gpu::Bindings bindings(const Picture& picture) const {
    const Resources& resources = picture.resources;
    return {{"View", picture.transparents.view},
            {"Work", picture.transparents.work},
            {"Front", &resources.buffer("front")},
            {"Back", &resources.buffer(both_ends_ ? "back" : "front")},
            {"Depths", &resources.buffer("depths")},
            {"Counts", &resources.buffer("counts")},
            {"Draws", &resources.buffer("draws")},
            {"light", &resources.image("light")},
            {"through", &resources.image("through")},
            {"behind", &resources.image(both_ends_ ? "behind" : "light")},
            {"opaque_color", &picture.opaque_color},
            {"result", &picture.result}};
  }

  void peel(gpu::Pass& pass, const Picture& picture, uint32_t index) const {
    const gpu::Buffer* draws = index == 0 ? nullptr : &picture.resources.buffer("draws");
    const uint32_t command = index == 0 ? 0 : 2 * (index - 1);
    const gpu::Image& layer_depth = picture.resources.image("layer_depth");
    pass.draw({.vertex = "post/fullscreen.vert",
               .fragment = "methods/peel/advance.frag",
               .targets = {},
               .depth = &layer_depth,
               .depth_use = gpu::DepthUse::kWrite,
               .area = picture.area(),
               .constants = constants(),
               .bindings = bindings(picture),
               .indirect = draws,
               .indirect_index = command},
              index);
    pass.barrier();
    picture.transparents.draw(pass, {.fragment = "methods/peel/peel.frag",
                                     .targets = {},
                                     .depth_test = &layer_depth,
                                     .depth_use = gpu::DepthUse::kTestBehind,
                                     .opaque_depth = &picture.opaque_depth,
                                     .area = picture.area(),
                                     .constants = constants(),
                                     .bindings = bindings(picture),
                                     .indirect = draws,
                                     .indirect_index = command + 1});
  }

  void count(gpu::Pass& pass, const Picture& picture) const {
    struct Complexity {
      uint32_t pixels, most;
    };
    struct Draws {
      uint32_t most, ends, recorded;
    };
    const uint32_t pixels = picture.size.x * picture.size.y;
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/peel/complexity.comp"), bindings(picture),
                  Complexity{pixels, most()}, {gpu::groups(pixels, 64 * 64), 1, 1});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/peel/draws.comp"), bindings(picture),
                  Draws{most(), ends(), recorded_}, {gpu::groups(recorded_, 64), 1, 1});
  }

  bool both_ends_;
  int layers_ = 0;
  uint32_t recorded_ = 16;  ///< peels of a frame
};

}  // namespace

std::unique_ptr<Method> make_peel() {
  return std::make_unique<Peel>(false);
}

std::unique_ptr<Method> make_peel_dual() {
  return std::make_unique<Peel>(true);
}

}  // namespace plume
