// k-buffer: the nearest k fragments of a pixel are blended exactly, the rest as one tail behind them. Bavoil
// et al., "Multi-Fragment Effects on the GPU using the k-Buffer", I3D 2007; the three ways to fill it are
// those of NVIDIA's vk_order_independent_transparency: a loop of 64-bit atomic minima over two passes
// ("loop64"), a spin lock a pixel, and the fragment shader interlock. All give the same picture.
//
//   image = sum_{i<k} L_i prod_{j<i} t_j + prod_{i<k} t_i (tail + background prod_tail t)
//
// The tail is a sum that any order gives, each fragment weighed by the mean share that gets through, for each
// channel; see shaders/methods/kbuffer/tail.glsl. (NVIDIA's sample blends it as fragments come, which depends
// on the order of the draws.)
//
// Limits: beyond k fragments colours mix: of several near-opaque layers of the tail all are seen alike.
// Fragments of next to no coverage take places too, so that the outline of a thin card can show as an edge in
// what lies behind it.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/pixel_nodes.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kLocks[] = {"atomic64", "spinlock", "interlock"};
enum Lock { kAtomic64, kSpinlock, kInterlock };

constexpr pixel_nodes::Kind kKind{.light = true, .empty_keys = true};
constexpr const char* kTail[] = {"tail_light", "tail_through", "tail_alpha"};

class KBuffer final : public Method {
 public:
  std::string_view id() const override { return "kbuffer"; }
  Traits traits() const override {
    return {.title = "k-buffer",
            .source =
                "Bavoil et al., I3D 2007; NVIDIA's vk_order_independent_transparency (loop64, spinlock, "
                "interlock)",
            .transmission = "RGB, exact in the nodes; RGB coverage of the tail",
            .emission = "exact in the nodes; in the tail, the tail's mean share",
            .limits = "beyond the nearest k, near-opaque layers mix instead of hiding each other",
            .street_rmse = 0.025};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    if (lock_ == kAtomic64)
      return device.has_int64_atomics()
                 ? std::vector<std::string>{}
                 : std::vector<std::string>{"shaderInt64 and shaderBufferInt64Atomics, or lock=spinlock"};
    return pixel_nodes::missing(device, pixel_lock());
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.integer("nodes", nodes_,
                    {.min = 1,
                     .max = 64,
                     .unit = "fragments",
                     .help = "nearest fragments a pixel that are exact: 32 bytes and a search each"});
    visitor.choice("lock", lock_, kLocks,
                   "how fragments of one pixel are kept apart: two passes of atomics, or one in turns");
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    pixel_nodes::add_needs(needs, size, uint32_t(nodes_), kKind);
    for (const char* name : kTail)
      needs.images.push_back(
          {.name = name, .format = vk::Format::eR32G32B32A32Sfloat, .usage = kTargetUsage});
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    const auto draw = [&](gpu::Pass& pass, const std::string& fragment,
                          std::vector<gpu::Attachment> targets) {
      pixel_nodes::draw(
          pass, picture, uint32_t(nodes_),
          {.fragment = fragment, .targets = std::move(targets), .constants = {}, .bindings = {}});
    };
    if (lock_ == kAtomic64)
      picture.frame.pass("nearest", [&](gpu::Pass& pass) {
        pixel_nodes::reset(pass, resources, kKind);
        pass.barrier();
        draw(pass, "methods/kbuffer/nearest.frag", {});
      });
    picture.frame.pass(lock_ == kAtomic64 ? "store" : "insert", [&](gpu::Pass& pass) {
      pixel_nodes::reset(pass, resources, kKind);
      pass.barrier();
      draw(pass,
           lock_ == kAtomic64 ? "methods/kbuffer/store.frag"
                              : pixel_nodes::insert_shader("methods/kbuffer", pixel_lock()),
           tail_targets(resources));
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      gpu::Bindings bindings = pixel_nodes::bindings(resources);
      for (const char* name : kTail) bindings.push_back({name, &resources.image(name)});
      bindings.push_back({"opaque_color", &picture.opaque_color});
      bindings.push_back({"result", &picture.result});
      pass.dispatch(pass.pipelines().compute("methods/kbuffer/resolve.comp",
                                             {uint32_t(nodes_), lock_ == kAtomic64 ? 1u : 0u}),
                    bindings, picture.size,
                    {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    gpu::Bindings bindings = pixel_nodes::bindings(picture.resources);
    for (const char* name : kTail) bindings.push_back({name, &picture.resources.image(name)});
    probe_with(picture, probe, "methods/kbuffer/probe.comp", {uint32_t(nodes_)}, std::move(bindings));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const shared::NodeOverflow overflow = pixel_nodes::overflow(device, resources);
    return {{"tail_fragments", overflow.fragments}, {"pixels_with_tail", overflow.pixels}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "tail_fragments",
         .what = "Fragments that found no node free and mix in a tail, without their order",
         .remedy = "Raise `nodes`"}};
    return kShortfalls;
  }

 private:
  pixel_nodes::Lock pixel_lock() const {
    return lock_ == kSpinlock ? pixel_nodes::Lock::kSpinlock : pixel_nodes::Lock::kInterlock;
  }
  static std::vector<gpu::Attachment> tail_targets(const Resources& resources) {
    constexpr std::array<float, 4> kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};
    return {{.image = &resources.image("tail_light"), .blend = gpu::Blend::kAdd, .clear = kZero},
            {.image = &resources.image("tail_through"), .blend = gpu::Blend::kMultiply, .clear = kOne},
            {.image = &resources.image("tail_alpha"), .blend = gpu::Blend::kAdd, .clear = kZero}};
  }

  int nodes_ = 8, lock_ = kAtomic64;
};

}  // namespace

std::unique_ptr<Method> make_kbuffer() {
  return std::make_unique<KBuffer>();
}

}  // namespace plume
