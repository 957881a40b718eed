// Weighted, blended order-independent transparency. McGuire and Bavoil, JCGT 2(2), 2013:
//   image = (sum C a w(z, a)) (1 - prod(1 - a)) / (sum a w(z, a)) + background prod(1 - a),
// where w guesses from depth and opacity how much of a fragment is seen. The background's share is exact; see
// shaders/methods/wboit/draw.frag.
//
// Particles may be drawn at half or quarter resolution beside surfaces at full: sums add and revealages
// multiply, so the composite needs no order between the two, whichever is in front (the authors' 2013 post).
// At edges of opaque things they reach over by half a low-resolution texel at most.
// What the picture's depth of field and haze want is written with the same weights (the post fills the depth
// buffer from the composited surfaces and does not say how).
//
// Limits: the guess must be tuned to the scene's depths; a near-opaque surface does not hide what is behind
// it; 16-bit sums overflow at about 22 fragments of weight 3000, which is counted; 8-bit revealage, the least
// that the paper asks for, stops at 0.5 / a steps under fragments of coverage a, so that thick smoke of thin
// puffs never hides the background.
#include <bit>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kWeights[] = {"eq7", "eq8", "eq9", "eq10", "colour_aware", "learnopengl"};
constexpr std::string_view kSums[] = {"half", "float"};
constexpr std::string_view kRevealages[] = {"unorm8", "half", "float"};
constexpr std::string_view kResolutions[] = {"full", "half", "quarter"};

class Wboit final : public Method {
 public:
  std::string_view id() const override { return "wboit"; }
  Traits traits() const override {
    return {
        .title = "Weighted blended",
        .source =
            "McGuire and Bavoil, JCGT 2(2) 2013, equations 7 to 10; McGuire's blog 2013; LearnOpenGL 2020",
        .transmission = "the mean of RGB",
        .emission = "in the weighted average where covered; added unattenuated where not",
        .limits = "the weight must be tuned to the scene's depths; near-opaque surfaces bleed",
        .street_rmse = 0.25};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.choice("weight", weight_, kWeights,
                   "which published guess of the transmittance weighs a fragment");
    visitor.number("depth_scale", depth_scale_,
                   {.min = 0.001,
                    .max = 1000.0,
                    .unit = "1/m",
                    .help = "the paper's depth units per metre: tunes the weight to the scene"});
    visitor.choice("sums", sums_, kSums,
                   "floats of the weighted sums: 16 bits overflow at about 22 fragments of weight 3000");
    visitor.choice("revealage", revealage_, kRevealages,
                   "of the background's share: 8 bits are the least published, and too coarse for smoke");
    visitor.choice("particles", particles_, kResolutions,
                   "resolution of soft particles: less is cheaper and blurs them, beside sharp surfaces");
  }

  Needs needs(glm::uvec2, const Transparents&) const override {
    Needs needs;
    weighted().add_needs(needs);
    return needs;
  }
  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  void record(const Picture& picture) override {
    const Weighted blend = weighted();
    if (particles_ != 0) blend.record_low_depth(picture);
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      for (const Transparents::Style& draw : shading(picture)) picture.transparents.draw(pass, draw);
    });
    blend.record_resolve(picture);
    blend.record_outputs(picture, "methods/wboit", constants());
  }

  std::vector<Transparents::Style> shading(const Picture& picture) const override {
    if (particles_ == 0) return {draw(picture, false)};
    return {draw(picture, false), draw(picture, true)};
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/wboit/probe.comp", constants(), weighted().sums(picture));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    return weighted().statistics(device, resources);
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "overflowed_pixels",
         .what = "Pixels whose sums are too large for their floats, so that they have lost their colour",
         .remedy = "Set `sums` to float, or lower `depth_scale`"}};
    return kShortfalls;
  }

 private:
  Weighted weighted() const {
    return {.full_floats = sums_ == 1,
            .revealage = Weighted::Revealage(int(Weighted::Revealage::kUnorm8) + revealage_),
            .low_divisor = 1u << particles_};
  }
  gpu::Constants constants() const {
    return {uint32_t(weight_), std::bit_cast<uint32_t>(depth_scale_), weighted().low_divisor};
  }
  Transparents::Style draw(const Picture& picture, bool low) const {
    const Weighted blend = weighted();
    const gpu::Image& depth = low ? blend.low_depth(picture.resources) : picture.opaque_depth;
    const glm::uvec2 size = low ? blend.low_size(picture.size) : picture.size;
    gpu::Constants with = constants();
    with.push_back(low ? 1u : 0u);
    return {.fragment = "methods/wboit/draw.frag",
            .targets = low ? blend.low_targets(picture.resources) : blend.targets(picture.resources),
            .depth_test = &depth,
            .opaque_depth = &depth,
            .area = {size.x, size.y},
            .vertex = particles_ == 0 ? "surface/card.vert" : "methods/wboit/cards_of_kind.vert",
            .constants = with,
            .bindings = {},
            .count_fragments = true,
            .covered = low ? blend.low_covered(picture.size) : glm::vec2(1.0f)};
  }

  int weight_ = 0;
  float depth_scale_ = 1.0f;
  int sums_ = 0, revealage_ = 1, particles_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_wboit() {
  return std::make_unique<Wboit>();
}

}  // namespace plume
