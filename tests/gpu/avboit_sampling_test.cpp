// How the integral is read: each sampling against a model of it, on rays of random layers.
#include <algorithm>

#include "tests/gpu/avboit_probe.h"

namespace plume {
namespace {

using avboit::Sampling;

class AvboitSampling : public AvboitProbe {
 protected:
  AvboitSampling() {
    size = {16, 16};
    settings.exact_layers = 0;
    settings.splat = avboit::Splat::kWords32;
  }
  avboit::Settings settings;
  Random random{1};
  struct Layer {
    double z, tau;
  };

  /// What the shaders read in front of each layer, at the middle of the picture.
  std::vector<double> read(const Stages& s, const std::vector<Layer>& layers) {
    write_probe("sampling_probe.comp", R"(
#extension GL_EXT_scalar_block_layout : require
#include "shared/view.h"
layout(scalar, binding = 0) uniform View { ViewData view; };
#include "methods/avboit/volume.h"
#include "methods/avboit/transmittance.glsl"
layout(local_size_x = 64) in;
layout(scalar, binding = 1) readonly buffer Asked { vec2 asked[]; };   // depth, optical depth
layout(scalar, binding = 2) writeonly buffer Found { float found[]; };
layout(push_constant) uniform Push { uint count; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < count) found[i] = transmittance_at(vec2(8.5), slice_at(asked[i].x), vec3(asked[i].y)).transmittance.r;
})");
    std::vector<glm::vec2> asked;
    for (const Layer& l : layers) asked.push_back({float(l.z), float(l.tau)});
    const gpu::Buffer in = upload("asked", asked), out = upload("found", std::vector<float>(asked.size()));
    const auto image = [&](const char* name) { return &s.resources.image(name); };
    const auto buffer = [&](const char* name) { return &s.resources.buffer(name); };
    ask("sampling_probe.comp", {uint32_t(settings.sampling), settings.linear_splat ? 1u : 0u, 0u},
        {{"View", s.world->transparents().view},
         {"VolumeBlock", buffer("volume")},
         {"WarpTable", buffer("warp")},
         {"Layers", buffer("layers")},
         {"LayerTails", buffer("layer_tails")},
         {"integral", image("integral")},
         {"integral_rg", image("integral_rg")},
         {"integral_b", image("integral_b")},
         {"Asked", &in},
         {"Found", &out}},
        uint32_t(asked.size()), gpu::groups(asked.size(), 64));
    const auto found = gpu::read<float>(device, out);
    return {found.begin(), found.end()};
  }

  /// B-spline of a degree around 0, by its recurrence.
  static double b_spline(int degree, double x) {
    if (degree == 0) return x >= -0.5 && x < 0.5 ? 1 : 0;
    const double half = (degree + 1) / 2.0;
    return ((half + x) * b_spline(degree - 1, x + 0.5) + (half - x) * b_spline(degree - 1, x - 0.5)) / degree;
  }

  /// The same, from the layers in double precision: only the table from depth to slice is the GPU's.
  std::vector<double> model(const Stages& s, const std::vector<Layer>& layers) const {
    const Warp warp = s.warp();
    const auto place = [&](const Layer& l) { return slice_at(s.volume(), warp, l.z); };
    std::vector<double> in_slice(warp.head.used + 2);
    for (const Layer& l : layers) {
      const double p = place(l), part = settings.linear_splat ? p - std::floor(p) : 0;
      in_slice[size_t(p)] += l.tau * (1 - part);
      in_slice[size_t(p) + 1] += l.tau * part;
    }
    // Optical depth in front of a place, where each slice's is spread evenly over it.
    const auto depth_before = [&](double x) {
      double sum = 0;
      for (size_t k = 0; k < in_slice.size(); ++k) sum += in_slice[k] * std::clamp(x - double(k), 0.0, 1.0);
      return sum;
    };
    const auto node = [&](double i) {
      const double t = std::exp(-depth_before(std::max(i, 0.0)));
      return settings.eight_bits ? std::round(t * 255) / 255 : t;
    };
    std::vector<double> result;
    for (const Layer& l : layers) {
      const double p = place(l), s0 = std::floor(p), g = settings.linear_splat ? p - s0 : 0;
      if (settings.sampling == Sampling::kSelfExcluded) {
        const double x = settings.linear_splat ? p + 0.5 : p;
        const double own =
            l.tau * ((1 - g) * std::clamp(x - s0, 0.0, 1.0) + g * std::clamp(x - s0 - 1, 0.0, 1.0));
        result.push_back(std::exp(-std::max(depth_before(x) - own, 0.0)));
        continue;
      }
      const double x =
          std::max((settings.sampling == Sampling::kPoint ? s0 : p + 1) - double(settings.bias), 0.0);
      if (settings.sampling == Sampling::kPoint) {
        result.push_back(node(std::floor(x)));
        continue;
      }
      const int degree = int(settings.sampling);
      double sum = 0;
      for (double i = std::floor(x) - 3; i <= std::floor(x) + 4; ++i)
        sum += b_spline(degree, x - i) * node(i);
      result.push_back(sum);
    }
    return result;
  }

  static std::vector<double> exact(const std::vector<Layer>& layers) {
    std::vector<double> result;
    for (const Layer& l : layers) {
      double tau = 0;
      for (const Layer& other : layers) tau += other.z < l.z ? other.tau : 0;
      result.push_back(std::exp(-tau));
    }
    return result;
  }
  std::vector<Layer> random_layers(int count, double from, double to, double least_alpha, double most_alpha) {
    std::vector<Layer> layers;
    clear_cards();
    for (int i = 0; i < count; ++i) {
      const float z = random.f(from, to);
      const float tau = float(-std::log1p(-random.between(least_alpha, most_alpha)));
      layers.push_back({double(z), double(tau)});
      add({.z = z, .optical_depth = tau});
    }
    return layers;
  }
};

TEST_F(AvboitSampling, EachIsWhatItsModelSays) {
  for (const bool adaptive : {true, false})
    for (const Sampling sampling : {Sampling::kSelfExcluded, Sampling::kPoint, Sampling::kLinear,
                                    Sampling::kQuadratic, Sampling::kCubic})
      for (const bool linear : {true, false})
        for (const float bias : {0.0f, 1.5f, 2.5f}) {
          if (sampling == Sampling::kSelfExcluded && bias > 0) continue;
          settings.adaptive = adaptive;
          settings.sampling = sampling;
          settings.linear_splat = linear;
          settings.bias = bias;
          SCOPED_TRACE(testing::Message() << (adaptive ? "avboit" : "vboit") << " sampling " << int(sampling)
                                          << " linear splat " << linear << " bias " << bias);
          const std::vector<Layer> layers = random_layers(24, 3, 14, 0.02, 0.5);
          const Stages s = run_stages(settings, Until::kIntegrate);
          const auto found = read(s, layers), expected = model(s, layers);
          // Where point sampling looks is a step: leave out what lies at one.
          const Warp warp = s.warp();
          for (size_t i = 0; i < layers.size(); ++i) {
            const double p = slice_at(s.volume(), warp, layers[i].z);
            if (std::abs(p - std::round(p)) < 0.01 && (sampling == Sampling::kPoint || !linear)) continue;
            // Half floats (2^-11 of the value), shares in steps of 1/4096, and 1e-3 slices of a logarithm.
            ASSERT_NEAR(expected[i], found[i], 2e-3) << "layer at " << layers[i].z;
          }
        }
}

TEST_F(AvboitSampling, EightBitsAreATransmittanceInSteps) {
  settings.sampling = Sampling::kLinear;
  settings.eight_bits = true;
  const std::vector<Layer> layers = random_layers(24, 3, 14, 0.02, 0.5);
  const Stages s = run_stages(settings, Until::kIntegrate);
  const auto found = read(s, layers), expected = model(s, layers);
  double worst = 0;
  for (size_t i = 0; i < layers.size(); ++i) worst = std::max(worst, std::abs(expected[i] - found[i]));
  EXPECT_LT(worst, 1.01 / 255) << "a node may round the other way";
  settings.eight_bits = false;
  const auto smooth = read(run_stages(settings, Until::kIntegrate), layers);
  double difference = 0;
  for (size_t i = 0; i < layers.size(); ++i)
    difference = std::max(difference, std::abs(smooth[i] - found[i]));
  EXPECT_GT(difference, 0.2 / 255);
}

TEST_F(AvboitSampling, SelfExclusionIsMoreThanTwiceAsAccurateAsABiasOfTwoSlices) {
  // Rays through a smoke grenade's bank: forty puffs within three metres.
  double error[2] = {0, 0};
  for (int ray = 0; ray < 12; ++ray) {
    const auto layers = random_layers(40, 6, 9, 0.03, 0.4);
    const auto truth = exact(layers);
    for (const bool biased : {false, true}) {
      settings.sampling = biased ? Sampling::kLinear : Sampling::kSelfExcluded;
      settings.bias = 2;
      const auto found = read(run_stages(settings, Until::kIntegrate), layers);
      for (size_t i = 0; i < layers.size(); ++i)
        error[biased] += std::pow((found[i] - truth[i]) * (1 - std::exp(-layers[i].tau)), 2);
    }
  }
  const double ratio = std::sqrt(error[1] / error[0]);
  RecordProperty("ratio", std::to_string(ratio));
  EXPECT_GT(ratio, 2);
}

TEST_F(AvboitSampling, ThePictureIsTheSumOfWhatIsReadInFrontOfEachLayer) {
  for (const auto& [name, sampling] :
       {std::pair("self_excluded", Sampling::kSelfExcluded), std::pair("linear", Sampling::kLinear),
        std::pair("cubic", Sampling::kCubic)}) {
    settings.sampling = sampling;
    const auto layers = random_layers(20, 4, 9, 0.05, 0.4);
    for (int c = 0; c < 3; ++c) {  // three of them shine, a channel each
      glm::vec3 color(0.0f);
      color[c] = 1.0f;
      scalar[size_t(5 * c + 3)].ambient = make_card({.color = color}).ambient;
    }
    const auto expected = model(run_stages(settings, Until::kIntegrate), layers);
    const DrawnPicture drawn = draw_cards("avboit", {{"sampling", name},
                                                     {"exact_layers", "0"},
                                                     {"splat", "words32"},
                                                     {"normalise", "false"},
                                                     {"zero_depth", "off"}});
    for (size_t c = 0; c < 3; ++c) {
      const double alpha = 1 - std::exp(-layers[5 * c + 3].tau);
      for (const glm::vec3& pixel : drawn.linear.pixels)
        ASSERT_NEAR(alpha * expected[5 * c + 3], double(pixel[glm::length_t(c)]), 2e-3) << name;
    }
  }
}

TEST_F(AvboitSampling, TheProbeIsExactInEmptySpace) {
  const auto told = [&](const std::vector<float>& depths, const char* sparse) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance("avboit", {{"sparse", sparse}});
    const Probe probe(device, size / 2u, depths);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
    return probe.read_answer(device);
  };
  for (const char* sparse : {"true", "false"}) {
    SCOPED_TRACE(sparse);
    clear_cards();
    for (const glm::vec3& t : told({0.5f, 10.0f}, sparse))
      EXPECT_EQ(glm::vec3(1.0f), t) << "nothing is there";
    for (int i = 0; i < 5; ++i) add({.z = 4.0f + float(i), .optical_depth = 0.4f});
    const auto t = told({0.5f, 3.5f, 4.5f, 5.5f, 6.5f, 7.5f, 9.0f, 500.0f}, sparse);
    for (int i = 0; i < 8; ++i)
      EXPECT_NEAR(std::exp(-0.4 * std::clamp(i - 1, 0, 5)), t[size_t(i)].r, 2e-3) << i;
  }
}

}  // namespace
}  // namespace plume
