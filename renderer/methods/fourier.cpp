// Fourier opacity mapping as order-independent transparency: absorbance over depth as a Fourier series of a
// few terms, blended additively in any order; each fragment is then drawn with the transmittance that the
// series gives at its depth. Jansen and Bavoil, "Fourier Opacity Mapping", I3D 2010, which maps a light's
// rays; the series is in shaders/methods/fourier/series.glsl.
//
// Limits: a few terms ring around whatever is thick, so that things are shaded by what lies behind them and
// shine through what lies in front.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/absorbance_cells.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kCoefficients[] = {"7", "9", "15"};
constexpr uint32_t kPairs[] = {3, 4, 7};
constexpr const char* kImages[] = {"series0", "series1", "series2", "series3"};
constexpr Weighted kWeighted{.full_floats = true};

class Fourier final : public Method {
 public:
  std::string_view id() const override { return "fourier"; }
  Traits traits() const override {
    return {.title = "Fourier opacity",
            .source = "Jansen and Bavoil, Fourier Opacity Mapping, I3D 2010, from the camera",
            .transmission = "the mean of RGB",
            .emission = "in the weighted average where covered; attenuated and added where not",
            .limits = "rings around whatever is thick",
            .street_rmse = 0.052};
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.choice("coefficients", coefficients_, kCoefficients,
                   "of the series: more ring less and narrower, for a target more every four");
    cells_.visit(visitor);
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    cells_.add_needs(needs, size);
    for (uint32_t i = 0; i < image_count(); ++i)
      needs.images.push_back({.name = kImages[i],
                              .format = vk::Format::eR32G32B32A32Sfloat,
                              .usage = kTargetUsage,
                              .divisor = cells_.divisor()});
    kWeighted.add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    cells_.record_ranges(picture);
    picture.frame.pass("splat", [&](gpu::Pass& pass) {
      std::vector<gpu::Attachment> targets;
      for (uint32_t i = 0; i < image_count(); ++i)
        targets.push_back({.image = &resources.image(kImages[i]),
                           .blend = gpu::Blend::kAdd,
                           .clear = std::array<float, 4>{0, 0, 0, 0}});
      cells_.draw(pass, picture, "methods/fourier/splat.frag", own_constants(), {}, {}, std::move(targets));
    });
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/fourier/draw.frag",
                                       .targets = kWeighted.targets(resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = cells_.constants(picture.transparents, own_constants()),
                                       .bindings = bindings(resources)});
    });
    kWeighted.record_resolve(picture);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/fourier/probe.comp",
               cells_.constants(picture.transparents, own_constants()), bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    return cells_.statistics(device, resources);
  }
  std::span<const Shortfall> shortfalls() const override { return AbsorbanceCells::shortfalls(); }

 private:
  gpu::Constants own_constants() const { return {kPairs[coefficients_]}; }
  uint32_t image_count() const { return (2 * kPairs[coefficients_] + 4) / 4; }
  /// A descriptor needs something to point at where a series is short.
  gpu::Bindings bindings(const Resources& resources) const {
    gpu::Bindings all;
    for (uint32_t i = 0; i < 4; ++i)
      all.push_back({kImages[i], &resources.image(kImages[i < image_count() ? i : 0])});
    return cells_.bindings(resources, std::move(all));
  }

  int coefficients_ = 1;
  AbsorbanceCells cells_{.rgb = false};
};

}  // namespace

std::unique_ptr<Method> make_fourier() {
  return std::make_unique<Fourier>();
}

}  // namespace plume
