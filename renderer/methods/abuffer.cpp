// The bounded A-buffer of Call of Duty: Black Ops 4, as the AVBOIT talk describes what it replaced (Advances
// in Real-Time Rendering, SIGGRAPH 2025, after Köhler, Treyarch 2016): so many layers a pixel, 9 as shipped,
// each of light 11:11:10, transmittance in 8 bits (11:11:10 where it is one for each channel) and a 16-bit
// depth, with a counter a pixel; sorted and composited front to back. Overflow blends into one layer.
//
// Left open by the talk, and chosen here:
// - Which fragments keep a layer. The counter hands layers out as fragments come (keep = first), so the order
//   of draws shows wherever a pixel overflows. The default (keep = nearest) ends with the nearest ones in any
//   order: chains of 64-bit atomic minima on words that hold a whole layer. A word has no room for three
//   transmittances, so those take a second draw that stores them.
// - How one layer is blended: the average weighted by what fragments cover, behind all layers, letting
//   through exactly what they let through (the tail of Maule et al., Hybrid Transparency, I3D 2013). It does
//   not depend on the order of its fragments.
// - Emission is part of a layer's light, which reaches 64512.
//
// Bits a pixel with 9 layers: 608 here, 1184 for each channel (512 and 728 in the talk: words have 8 bits to
// spare, a card's index is kept to order equal depths, and counters are not packed in fours, where more than
// 255 fragments would carry into the neighbour's), and the tail.
//
// Not modelled: the talk rasterises particles in the resolve, and only meshes enter layers. Here all do.
//
// Limits: more layers than are kept turn into an average; 8 bits of transmittance lose thin smoke, and panes
// closer than a half float's step (4 mm at 4 m to 8 m) may swap.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"
#include "shaders/methods/abuffer/bounded.h"

namespace plume {
namespace {

constexpr std::string_view kKeeps[] = {"nearest", "first"};
constexpr std::string_view kDepths[] = {"16", "24"};

class Abuffer final : public Method {
 public:
  std::string_view id() const override { return "abuffer"; }
  Traits traits() const override {
    return {
        .title = "Bounded A-buffer",
        .source =
            "Call of Duty: Black Ops 4, in the AVBOIT talk, SIGGRAPH 2025; overflow after Maule et "
            "al., I3D 2013",
        .transmission = rgb_ ? "RGB" : "the mean of RGB",
        .emission = "exact up to its rounding; in the tail, in its average where covered, added where not",
        .limits =
            "more fragments than layers turn into one average; colours of 5 or 6 bits below the "
            "leading one, 8-bit transmittance loses thin smoke, 16-bit depth swaps near neighbours",
        .street_rmse = 0.034,
        .rounding = 1.0 / 64};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.integer(
        "layers", layers_,
        {.min = 1,
         .max = 32,
         .unit = "a pixel",
         .help = "fragments kept; those beyond share one average, each layer takes 8 or 16 bytes"});
    visitor.toggle("rgb", rgb_,
                   "a transmittance for each channel: colours glass right, for twice the memory and, with "
                   "keep = nearest, a second draw");
    visitor.choice("keep", keep_, kKeeps,
                   "which fragments get a layer: the nearest, or cheaper and as published those drawn first");
    visitor.choice("depth_bits", depth_, kDepths,
                   "of a layer's depth: 16 as published, 24 keep the order of things a millimetre apart");
  }

  std::vector<std::string> missing(const gpu::Device& device) const override {
    if (!nearest() || device.has_int64_atomics()) return {};
    return {"shaderInt64 and shaderBufferInt64Atomics, or keep=first"};
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    const uint64_t pixels = uint64_t(size.x) * size.y, bytes = pixels * uint64_t(layers_) * 8;
    Needs needs;
    needs.buffers.push_back({.name = "bounded", .bytes = sizeof(shared::BoundedLayers), .clear = {}});
    needs.buffers.push_back({.name = "counters", .bytes = pixels * 4, .clear = 0});
    needs.buffers.push_back({.name = "keys", .bytes = bytes, .clear = {}});
    if (nearest()) needs.buffers.back().clear = shared::kFree;
    if (rgb_) needs.buffers.push_back({.name = "payloads", .bytes = bytes, .clear = {}});
    tail().add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    const auto draw = [&](gpu::Pass& pass, const char* shader, std::vector<gpu::Attachment> targets) {
      picture.transparents.draw(pass, {.fragment = shader,
                                       .targets = std::move(targets),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = constants(),
                                       .bindings = bindings(resources)});
    };
    picture.frame.pass("insert", [&](gpu::Pass& pass) {
      const shared::BoundedLayers empty{
          .keys = resources.buffer("keys").address_words(),
          .payloads = rgb_ ? resources.buffer("payloads").address_words() : glm::uvec2(0),
          .overflowed_fragments = 0,
          .overflowed_pixels = 0};
      pass.update(resources.buffer("bounded"), empty);
      pass.barrier();
      if (nearest() && rgb_)
        draw(pass, "methods/abuffer/nearest_keys.frag", {});
      else
        draw(pass, nearest() ? "methods/abuffer/nearest.frag" : "methods/abuffer/first.frag",
             tail().targets(resources));
    });
    if (nearest() && rgb_)
      picture.frame.pass("store", [&](gpu::Pass& pass) {
        draw(pass, "methods/abuffer/nearest_payload.frag", tail().targets(resources));
      });
    tail().record_resolve(picture);  // the tails over what is opaque: what the layers are blended over
    picture.frame.pass("composite", [&](gpu::Pass& pass) {
      gpu::Bindings bound = bindings(resources);
      bound.push_back({"result", &picture.result});
      pass.dispatch(pass.pipelines().compute("methods/abuffer/composite.comp", constants()), bound,
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/abuffer/probe.comp", constants(), bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const auto last = gpu::read<shared::BoundedLayers>(device, resources.buffer("bounded"))[0];
    return {{"fragments_in_tail", last.overflowed_fragments}, {"pixels_with_tail", last.overflowed_pixels}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "fragments_in_tail",
         .what = "Fragments that found no layer free and are averaged into one behind them",
         .remedy = "Raise `layers`"}};
    return kShortfalls;
  }

 private:
  bool nearest() const { return keep_ == 0; }
  Weighted tail() const { return {.each_channel = rgb_}; }
  gpu::Constants constants() const {
    return {uint32_t(layers_), rgb_ ? 1u : 0u, depth_ == 0 ? 1u : 0u, nearest() ? 1u : 0u};
  }
  static gpu::Bindings bindings(const Resources& resources) {
    return {{"Bounded", &resources.buffer("bounded")}, {"Counters", &resources.buffer("counters")}};
  }

  int layers_ = 9;
  bool rgb_ = true;
  int keep_ = 0;
  int depth_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_abuffer() {
  return std::make_unique<Abuffer>();
}

}  // namespace plume
