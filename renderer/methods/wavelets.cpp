// Wavelet transparency: absorbance over depth in the Haar basis, a few coefficients a pixel that fragments
// add to in any order; each is then drawn with the transmittance that they give at its depth. Aizenshtein,
// Smal and McGuire, "Wavelet Transparency", 2022; the transform is in shaders/methods/wavelets/haar.glsl.
//
// Coefficients are added to atomically, in 32-bit floats; what dims all channels alike goes into sums of its
// own, so that only coloured things pay for colour. A fragment's absorbance is at most 16: alpha 1 is beyond
// it, and counted. Depths are logarithmic, in a range that is each pixel's own or fixed.
//
// Limits: what shares a leaf mixes, and how much changes with where in the leaf it lies. In a fixed range the
// colours of near-opaque things swing as the camera moves. In a pixel's own they keep their places, until
// something nearer or farther comes into it and stretches it.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/absorbance_cells.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

class Wavelets final : public Method {
 public:
  std::string_view id() const override { return "wavelets"; }
  Traits traits() const override {
    return {.title = "Haar wavelets",
            .source = "Aizenshtein, Smal and McGuire, Wavelet Transparency, 2022",
            .transmission = "RGB; without `rgb` the mean",
            .emission = "in the weighted average where covered; attenuated and added where not",
            .limits = "not shift invariant: colours of what shares a leaf swing as it moves through it",
            .street_rmse = 0.016};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    if (device.has_float_atomics()) return {};
    return {"shaderBufferFloat32AtomicAdd"};
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.integer("rank", rank_,
                    {.min = 1,
                     .max = 4,
                     .unit = "",
                     .help = "2^(rank + 1) coefficients a pixel: depths are told apart better, for rank + 2 "
                             "atomic sums a fragment and memory"});
    visitor.toggle("unfold", unfold_,
                   "inverts the transform once a pixel: fragments read two means instead of walking the tree "
                   "twice, for a pass over the coefficients");
    visitor.toggle("rgb", cells_.rgb,
                   "a transmittance for each channel: right behind coloured things, for four sums instead of "
                   "one where there are any");
    cells_.visit(visitor);
  }

  Needs needs(glm::uvec2 size, const Transparents& transparents) const override {
    Needs needs;
    cells_.add_needs(needs, size);
    needs.buffers.push_back({.name = "address", .bytes = sizeof(glm::uvec2), .clear = {}});
    needs.buffers.push_back({.name = "coefficients",
                             .bytes = cells_.count(size) * sums(transparents) * (8u << rank_),
                             .clear = 0});
    weighted(transparents).add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    cells_.record_ranges(picture);
    picture.frame.pass("splat", [&](gpu::Pass& pass) {
      pass.update(resources.buffer("address"), resources.buffer("coefficients").address_words());
      pass.barrier();
      const auto splat = [&](bool into_rgb, std::optional<Source> source) {
        cells_.draw(pass, picture, "methods/wavelets/splat.frag", own_constants(into_rgb),
                    own_bindings(resources), source);
      };
      const bool each_channel = cells_.channels(picture.transparents) == 3;
      splat(false, each_channel ? std::optional(Source::kScalar) : std::nullopt);
      if (each_channel) splat(true, Source::kRgb);
    });
    if (unfold_)
      picture.frame.pass("unfold", [&](gpu::Pass& pass) {
        gpu::Bindings bindings = own_bindings(resources);
        bindings.push_back({"View", picture.transparents.view});
        const glm::uvec2 cells = cells_.cells(picture.size);
        pass.dispatch(
            pass.pipelines().compute("methods/wavelets/unfold.comp", constants(picture.transparents)),
            bindings, 0u,
            {gpu::groups(cells.x, 8), gpu::groups(cells.y, 8), cells_.channels(picture.transparents)});
      });
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/wavelets/draw.frag",
                                       .targets = weighted(picture.transparents).targets(resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = constants(picture.transparents),
                                       .bindings = bindings(resources)});
    });
    weighted(picture.transparents).record_resolve(picture);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/wavelets/probe.comp", constants(picture.transparents),
               bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    return cells_.statistics(device, resources);
  }
  std::span<const Shortfall> shortfalls() const override { return AbsorbanceCells::shortfalls(); }

 private:
  /// In half floats many thin fragments' transmittances near 1 multiply to what rounding makes of them.
  Weighted weighted(const Transparents& transparents) const {
    return {.each_channel = cells_.channels(transparents) == 3, .full_floats = true};
  }
  /// What dims all channels alike is summed once, and what does not for each.
  uint32_t sums(const Transparents& transparents) const { return cells_.channels(transparents) == 3 ? 4 : 1; }
  gpu::Constants own_constants(bool into_rgb) const {
    return {uint32_t(rank_), unfold_ ? 1u : 0u, into_rgb ? 1u : 0u};
  }
  gpu::Constants constants(const Transparents& transparents) const {
    return cells_.constants(transparents, own_constants(false));
  }
  gpu::Bindings own_bindings(const Resources& resources) const {
    return {{"Address", &resources.buffer("address")}};
  }
  gpu::Bindings bindings(const Resources& resources) const {
    return cells_.bindings(resources, own_bindings(resources));
  }

  int rank_ = 3;
  bool unfold_ = true;
  AbsorbanceCells cells_;
};

}  // namespace

std::unique_ptr<Method> make_wavelets() {
  return std::make_unique<Wavelets>();
}

}  // namespace plume
