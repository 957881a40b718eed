// Moment-based transparency: the reconstruction against a model in double precision, its bounds, its
// published successes and its known failures.
#include <algorithm>
#include <bit>
#include <complex>

#include "renderer/probe.h"
#include "tests/gpu/avboit_probe.h"

namespace plume {
namespace {

using Map = std::map<std::string, std::string>;

struct Kind {
  const char* name;
  bool power;
  size_t nodes;
  float bias;
};
constexpr Kind kKinds[] = {{"power4", true, 2, 5e-7f}, {"power6", true, 3, 5e-6f},
                           {"power8", true, 4, 5e-5f}, {"trig2", false, 2, 4e-7f},
                           {"trig3", false, 3, 8e-7f}, {"trig4", false, 4, 1.5e-6f}};

struct Event {
  float w;    ///< warped depth
  float tau;  ///< absorbance
};

/// The same reconstruction on another road: the kernel's equations by elimination, its roots all at once, the
/// shares of the places from the equations of the moments. Complex, so that line and circle are one.
class Model {
 public:
  Model(const Kind& kind, const std::vector<Event>& events) : kind_(kind), mean_(2 * kind.nodes + 1) {
    for (const Event& e : events) total_ += double(e.tau);
    for (size_t k = 0; k < mean_.size(); ++k) {
      for (const Event& e : events) mean_[k] += double(e.tau) / total_ * std::pow(place(double(e.w)), int(k));
      const double wide[3][9] = {
          {1, 0, .375, 0, .375}, {1, 0, .48, 0, .451, 0, .45}, {1, 0, .75, 0, .67667, 0, .63, 0, .60030}};
      const double towards = kind.power ? wide[kind.nodes - 2][k] : double(k == 0);
      mean_[k] = mean_[k] * (1 - double(kind.bias)) + double(kind.bias) * towards;
    }
  }

  double transmittance(double w, double overestimation) const {
    const size_t n = kind_.nodes;
    std::vector<Complex> places{place(w)};
    std::vector<std::vector<Complex>> products(n + 1, std::vector<Complex>(n + 1));
    std::vector<Complex> right(n + 1);
    for (size_t i = 0; i <= n; ++i) {
      right[i] = std::conj(std::pow(places[0], int(i)));
      for (size_t k = 0; k <= n; ++k)
        products[i][k] = kind_.power ? mean_[i + k] : k >= i ? mean_[k - i] : std::conj(mean_[i - k]);
    }
    const std::vector<Complex> found = roots(solve(products, right));
    places.insert(places.end(), found.begin(), found.end());
    for (size_t i = 0; i <= n; ++i) {
      right[i] = mean_[i];
      for (size_t k = 0; k <= n; ++k) products[i][k] = std::pow(places[k], int(i));
    }
    const std::vector<Complex> shares = solve(products, right);
    double in_front = overestimation * shares[0].real();
    for (size_t k = 1; k <= n; ++k) in_front += shares[k].real() * part_in_front(places[k], w);
    return std::exp(-total_ * in_front);
  }

 private:
  using Complex = std::complex<double>;
  static constexpr double kPi = 3.14159265358979323846, kZone = 0.1 * kPi;

  Complex place(double w) const {
    return kind_.power ? Complex(w) : std::polar(1.0, (w + 1) * (kPi - kZone / 2));
  }
  double part_in_front(Complex at, double w) const {
    if (kind_.power) return at.real() < w ? 1 : 0;
    const double angle = std::arg(at) + (std::arg(at) < 0 ? 2 * kPi : 0);
    return angle < (w + 1) * (kPi - kZone / 2) ? 1 : std::clamp((angle - 2 * kPi + kZone) / kZone, 0.0, 1.0);
  }
  static std::vector<Complex> solve(std::vector<std::vector<Complex>> m, std::vector<Complex> x) {
    const size_t n = x.size();
    for (size_t i = 0; i < n; ++i) {
      size_t best = i;
      for (size_t k = i; k < n; ++k)
        if (std::abs(m[k][i]) > std::abs(m[best][i])) best = k;
      std::swap(m[i], m[best]);
      std::swap(x[i], x[best]);
      for (size_t k = 0; k < n; ++k) {
        if (k == i) continue;
        const Complex times = m[k][i] / m[i][i];
        for (size_t j = i; j < n; ++j) m[k][j] -= times * m[i][j];
        x[k] -= times * x[i];
      }
    }
    for (size_t i = 0; i < n; ++i) x[i] /= m[i][i];
    return x;
  }
  /// Of sum c_k x^k, by Aberth's iteration.
  static std::vector<Complex> roots(const std::vector<Complex>& c) {
    std::vector<Complex> x;
    for (size_t i = 0; i + 1 < c.size(); ++i) x.push_back(std::pow(Complex(0.4, 0.9), int(i)));
    for (int round = 0; round < 200; ++round)
      for (size_t i = 0; i < x.size(); ++i) {
        Complex value = 0, slope = 0, others = 0;
        for (size_t k = c.size(); k-- > 0;) slope = slope * x[i] + value, value = value * x[i] + c[k];
        if (std::abs(value) == 0) continue;
        for (size_t k = 0; k < x.size(); ++k)
          if (k != i) others += 1.0 / (x[i] - x[k]);
        x[i] -= 1.0 / (slope / value - others);
      }
    return x;
  }

  Kind kind_;
  double total_ = 0;
  std::vector<Complex> mean_;  ///< of place^k, biased
};

class MomentsTest : public AvboitProbe {
 protected:
  Random random{1};

  gpu::Constants constants(size_t kind, float overestimation = 0.25f) const {
    return {uint32_t(kind), 0u, 1u, std::bit_cast<uint32_t>(kKinds[kind].bias),
            std::bit_cast<uint32_t>(overestimation)};
  }

  struct Question {
    std::vector<Event> events;
    float w;
  };
  std::vector<float> reconstruct(size_t kind, const std::vector<Question>& questions) {
    write_probe("reconstruct_probe.comp", R"(
#extension GL_EXT_scalar_block_layout : require
#include "methods/moments/reconstruct.glsl"
layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Events { vec2 events[]; };
layout(scalar, binding = 1) readonly buffer Spans { uvec2 spans[]; };
layout(scalar, binding = 2) readonly buffer Asked { float asked[]; };
layout(scalar, binding = 3) writeonly buffer Found { float found[]; };
layout(push_constant) uniform Push { uint count; };
void main() {
  const uint q = gl_GlobalInvocationID.x;
  if (q >= count) return;
  float b0 = 0.0;
  vec4 low = vec4(0.0), high = vec4(0.0);
  for (uint i = spans[q].x; i < spans[q].y; ++i) {
    vec4 f, g;
    basis(events[i].x, f, g);
    b0 += events[i].y;
    low += f * events[i].y;
    high += g * events[i].y;
  }
  bool unsure;
  found[q] = transmittance_of(b0, low, high, asked[q], unsure);
})");
    std::vector<Event> events;
    std::vector<glm::uvec2> spans;
    std::vector<float> asked;
    for (const Question& q : questions) {
      spans.push_back({uint32_t(events.size()), uint32_t(events.size() + q.events.size())});
      events.insert(events.end(), q.events.begin(), q.events.end());
      asked.push_back(q.w);
    }
    const gpu::Buffer in = upload("events", events), ranges = upload("spans", spans),
                      depths = upload("asked", asked), out = upload("found", asked);
    ask("reconstruct_probe.comp", constants(kind),
        {{"Events", &in}, {"Spans", &ranges}, {"Asked", &depths}, {"Found", &out}},
        uint32_t(questions.size()), gpu::groups(questions.size(), 64));
    return gpu::read<float>(device, out);
  }

  /// What reconstruction did to random pixels of 1 to 200 fragments that are everywhere, crowded or at one
  /// depth, faint or opaque, asked at a fragment and elsewhere.
  struct Sweep {
    uint32_t asked, not_finite, out_of_range, unsure;
    uint32_t beyond_bound;             ///< by more than 0.01, where overestimation is 0 or 1
    uint32_t wide, wide_beyond_bound;  ///< pixels with many fragments over all of the range
  };
  Sweep sweep(size_t kind, uint32_t pixels, float overestimation) {
    write_probe("sweep_probe.comp", R"(
#extension GL_EXT_scalar_block_layout : require
#include "shared/hash.h"
#include "methods/moments/reconstruct.glsl"
layout(local_size_x = 64) in;
layout(scalar, binding = 0) buffer Counts { uint asked, not_finite, out_of_range, unsure_count, beyond_bound, wide, wide_beyond; };
layout(push_constant) uniform Push { uint pixels; };

uint g_word;
float next() {
  g_word = hash(g_word);
  return float(g_word >> 8) / 16777216.0;
}
vec2 event(float center, float spread, float strength) {
  const float w = center + spread * (2.0 * next() - 1.0);
  return vec2(clamp(w, -1.0, 1.0), min(strength * next() + 1e-4, kMostAbsorbance));
}

void main() {
  const uint pixel = gl_GlobalInvocationID.x;
  if (pixel >= pixels) return;
  g_word = hash_pair(pixel, 7u);
  const uint count = uint(exp2(next() * log2(200.99)));
  const float center = 2.0 * next() - 1.0, spread = next() < 0.2 ? 0.0 : exp2(-16.0 * max(next() * 1.6 - 0.6, 0.0));
  const float strength = exp2(10.0 * next() - 6.5);
  const uint start = g_word, chosen = hash(pixel) % count;
  float b0 = 0.0;
  vec4 low = vec4(0.0), high = vec4(0.0);
  vec2 at = vec2(0.0, center + 2.0 * spread * (2.0 * next() - 1.0));
  at.y = clamp(at.y, -1.0, 1.0);
  g_word = start;
  for (uint i = 0u; i < count; ++i) {
    const vec2 e = event(center, spread, strength);
    vec4 f, g;
    basis(e.x, f, g);
    b0 += e.y;
    low += f * e.y;
    high += g * e.y;
    if (i == chosen) at.x = e.x;
  }
  g_word = start;
  vec2 before = vec2(0.0), until = vec2(0.0);
  const bool bounds = kOverestimation == 0.0 || kOverestimation == 1.0, is_wide = spread > 0.5 && count > 15u;
  for (uint i = 0u; bounds && i < count; ++i) {
    const vec2 e = event(center, spread, strength);
    before += e.y * vec2(lessThan(e.xx, at));
    until += e.y * vec2(lessThanEqual(e.xx, at));
  }
  for (int q = 0; q < 2; ++q) {
    bool unsure;
    const float t = transmittance_of(b0, low, high, at[q], unsure);
    atomicAdd(asked, 1u);
    if (isnan(t) || isinf(t)) atomicAdd(not_finite, 1u);
    if (!(t >= 0.0 && t <= 1.0)) atomicAdd(out_of_range, 1u);
    if (is_wide) atomicAdd(wide, 1u);
    const bool beyond = kOverestimation == 0.0 ? t < exp(-before[q]) - 0.01 : kOverestimation == 1.0 && t > exp(-until[q]) + 0.01;
    if (beyond) atomicAdd(beyond_bound, 1u);
    if (beyond && is_wide) atomicAdd(wide_beyond, 1u);
    if (unsure) atomicAdd(unsure_count, 1u);
  }
})");
    const gpu::Buffer counts = upload("counts", std::vector<uint32_t>(7));
    ask("sweep_probe.comp", constants(kind, overestimation), {{"Counts", &counts}}, pixels,
        gpu::groups(pixels, 64));
    return gpu::read<Sweep>(device, counts)[0];
  }

  /// What the method tells of the middle of the picture.
  std::vector<glm::vec3> told(const std::vector<float>& depths, Map settings = {},
                              std::string_view id = "moments") {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance(id, settings);
    const Probe probe(device, size / 2u, depths);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
    return probe.read_answer(device);
  }
  static int difference(const std::array<uint8_t, 3>& a, const std::array<uint8_t, 3>& b) {
    int worst = 0;
    for (size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(int(a[c]) - int(b[c])));
    return worst;
  }
};

TEST_F(MomentsTest, AMillionRandomPixelsOfEveryKindHaveATransmittance) {
  for (size_t kind = 0; kind < 6; ++kind) {
    SCOPED_TRACE(kKinds[kind].name);
    const Sweep s = sweep(kind, 1000000, 0.25f);
    EXPECT_EQ(2000000u, s.asked);
    EXPECT_EQ(0u, s.not_finite);
    EXPECT_EQ(0u, s.out_of_range);
    EXPECT_LT(s.unsure, s.asked / 25) << "of these, four in five have one depth or nearly one";
  }
}

TEST_F(MomentsTest, WithoutAndWithFullOverestimationPowerMomentsBoundTheTransmittance) {
  for (size_t kind = 0; kind < 3; ++kind)
    for (const float overestimation : {0.0f, 1.0f}) {
      SCOPED_TRACE(testing::Message() << kKinds[kind].name << " " << overestimation);
      const Sweep s = sweep(kind, 60000, overestimation);
      EXPECT_GT(s.wide, 8000u);
      EXPECT_EQ(0u, s.wide_beyond_bound);
      EXPECT_LT(s.beyond_bound, s.asked / 50) << "nearly singular equations are solved by their rounding";
    }
  EXPECT_GT(sweep(3, 60000, 0.0f).wide_beyond_bound, 100u) << "a positive control: a circle has no front end";
}

TEST_F(MomentsTest, ReconstructionIsThatOfAModelInDoublePrecision) {
  for (size_t kind = 0; kind < 6; ++kind) {
    SCOPED_TRACE(kKinds[kind].name);
    std::vector<Question> questions;
    for (int i = 0; i < 3000; ++i) {
      Question q{.events = {}, .w = random.f(-1, 1)};
      const uint32_t count = 1 + random.below(i % 2 ? 6 : 60);
      for (uint32_t k = 0; k < count; ++k)
        q.events.push_back({random.f(-1, 1), float(random.octaves(0.01, i % 4 < 2 ? 0.3 : 8))});
      if (i % 3 == 0) q.w = q.events[random.below(count)].w;
      questions.push_back(q);
    }
    const std::vector<float> found = reconstruct(kind, questions);
    std::vector<double> apart;
    for (size_t i = 0; i < questions.size(); ++i)
      apart.push_back(
          std::abs(double(found[i]) -
                   Model(kKinds[kind], questions[i].events).transmittance(double(questions[i].w), 0.25)));
    std::ranges::sort(apart);
    EXPECT_LT(apart[apart.size() / 2], 2e-6);
    EXPECT_LT(apart[apart.size() * 99 / 100], 0.003);
    EXPECT_LT(apart[apart.size() * 999 / 1000], 0.05) << "as many fragments as places, or fewer";
  }
}

TEST_F(MomentsTest, ASingleFragmentIsReconstructed) {
  size = {8, 8};
  for (const Kind& kind : kKinds)
    for (const float coverage : {0.1f, 0.5f, 0.99f, 1.0f}) {
      SCOPED_TRACE(testing::Message() << kind.name << " coverage " << coverage);
      clear_cards();
      add({.z = 7, .optical_depth = coverage < 1 ? -std::log1p(-coverage) : shared::kOpaqueDepth});
      const auto t = told({6.0f, 6.99f, 7.01f, 9.0f}, {{"moments", kind.name}});
      for (const size_t before : {0u, 1u}) EXPECT_NEAR(1, t[before].r, 1e-3);
      for (const size_t behind : {2u, 3u}) EXPECT_NEAR(1 - coverage, t[behind].r, 1e-3);
    }
}

TEST_F(MomentsTest, TwoWellSeparatedLayersAreReconstructedByFourMoments) {
  size = {8, 8};
  add({.z = 3, .optical_depth = -std::log1p(-0.6f)});
  add({.z = 12, .optical_depth = -std::log1p(-0.7f)});
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.name);
    const auto t = told({2.5f, 3.5f, 6.0f, 11.0f, 14.0f}, {{"moments", kind.name}});
    const float exact[] = {1, 0.4f, 0.4f, 0.4f, 0.12f};
    for (size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(exact[i], t[i].r, 0.005) << "depth " << i;
  }
}

TEST_F(MomentsTest, ColoursBleedThroughThreeNearOpaqueCardsInSmoke) {
  size = {16, 8};
  const auto draw_stack = [&](std::string_view id, const Map& settings, bool smoke) {
    clear_cards();
    add({.z = 5, .optical_depth = 4.6f, .color = {0.8f, 0, 0}});
    add({.z = 6, .optical_depth = 4.6f, .color = {0, 0.8f, 0}});
    add({.z = 7, .optical_depth = 4.6f, .color = {0, 0, 0.8f}});
    for (int i = 0; smoke && i < 12; ++i)
      add({.z = 3.1f + 0.6f * float(i), .optical_depth = 0.05f, .color = glm::vec3(0.1f)});
    return draw_cards(id, settings).display.at(8, 4);
  };
  const auto exact = draw_stack("reference", {}, true), alone = draw_stack("reference", {}, false);
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.name);
    const Map settings{{"moments", kind.name}};
    EXPECT_LE(difference(alone, draw_stack("moments", settings, false)), 2) << "as many layers as places";
    const auto drawn = draw_stack("moments", settings, true);
    EXPECT_GT(drawn[1], exact[1] + 10) << "the second card";
  }
  EXPECT_LE(difference(exact, draw_stack("avboit", {}, true)), 4) << "a positive control";
}

TEST_F(MomentsTest, AFarLayerMovesNearTransmittance) {
  size = {8, 8};
  const std::vector<float> depths{4.5f, 5.5f, 6.5f};
  const auto moved_by_a_far_layer = [&](const Map& settings, std::string_view id) {
    clear_cards();
    for (int i = 0; i < 8; ++i) add({.z = 4 + 0.5f * float(i), .optical_depth = 0.2f});
    const auto alone = told(depths, settings, id);
    add({.z = 60, .optical_depth = 5});
    const auto with = told(depths, settings, id);
    float most = 0;
    for (size_t i = 0; i < depths.size(); ++i) most = std::max(most, std::abs(with[i].r - alone[i].r));
    return most;
  };
  // Between the camera's planes the warp stays as it is.
  for (const Kind& kind : kKinds)
    EXPECT_GT(moved_by_a_far_layer({{"moments", kind.name}, {"depth_bounds", "planes"}}, "moments"),
              kind.nodes == 2 ? 0.05f : 0.01f)
        << kind.name;
  EXPECT_LT(moved_by_a_far_layer({}, "avboit"), 1e-4f) << "a positive control";
}

TEST_F(MomentsTest, LowerResolutionsSeeTheSameFragments) {
  size = {34, 18};  // no multiple of a cell
  for (int i = 0; i < 6; ++i)
    add({.z = 4 + float(i), .optical_depth = 0.3f + 0.1f * float(i), .color = {0.1f * float(i), 0.4f, 0.8f}});
  add({.z = 8.5f, .optical_depth = 1, .transmission = {0.9f, 0.4f, 0.1f}});
  for (const char* channels : {"true", "false"}) {
    const auto full = draw_cards("moments", {{"rgb", channels}}).linear.pixels;
    for (const char* resolution : {"1/2", "1/4", "1/8"}) {
      const auto drawn =
          draw_cards("moments", {{"rgb", channels}, {"resolution", resolution}}, true).linear.pixels;
      for (size_t i = 0; i < drawn.size(); ++i)
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(full[i][c], drawn[i][c], 0.002f) << resolution << " pixel " << i;
    }
  }
}

TEST_F(MomentsTest, TheOrderOfDrawsChangesNothingInAnyKind) {
  Stage stage(device, pipelines, library, library.scene("street"));
  const Targets targets(device, {96, 54});
  stage.go_to(260, targets.size);
  std::vector<uint32_t> backwards(stage.transparents().count);
  std::iota(backwards.rbegin(), backwards.rend(), 0u);
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(testing::Message() << kind.name);
    MethodInstance method = instance("moments", {{"moments", kind.name}});
    stage.go_to(260, targets.size);
    const auto forwards = GpuTest::draw(stage, targets, method).display.pixels;
    stage.set_draw_order(backwards);
    const auto reversed = GpuTest::draw(stage, targets, method).display.pixels;
    int worst = 0, beyond = 0;
    for (size_t i = 0; i < forwards.size(); ++i) {
      worst = std::max(worst, difference(forwards[i], reversed[i]));
      beyond += difference(forwards[i], reversed[i]) > 2;
    }
    EXPECT_LE(worst, kind.nodes == 4 ? 8 : 2)
        << "eight numbers sum in another order to another nearly singular system";
    EXPECT_LE(beyond, kind.nodes == 4 ? 5 : 0);
  }
}

TEST_F(MomentsTest, SmokeBesideASilhouetteIsInTheMomentsOfItsCell) {
  size = {32, 16};
  Solid wall;
  wall.material = Material::kUnlit;
  wall.position = {-10.3f, 0, -5};  // its right edge stands within a cell
  wall.size_m = {20, 40, 0.5f};
  scene.solids = {wall};
  for (int i = 0; i < 4; ++i) {
    glm::vec3 color(0.1f);
    color[i % 3] = 0.8f;
    add({.z = 7 + float(i), .optical_depth = 0.7f, .color = color});
  }
  const auto full = draw_cards("moments").linear, low = draw_cards("moments", {{"resolution", "1/8"}}).linear;
  float worst = 0;
  for (size_t i = 0; i < full.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(full.pixels[i][c] - low.pixels[i][c]));
  EXPECT_LT(worst, 0.002f);
}

TEST_F(MomentsTest, RgbMomentsTintWhatLiesBehindAndTheMeanDoesNot) {
  size = {8, 8};
  add({.z = 5, .optical_depth = 5, .transmission = {0.05f, 0.9f, 0.05f}});
  add({.z = 8, .optical_depth = 2, .color = {0.6f, 0.6f, 0.6f}});
  const glm::vec3 exact = draw_cards("reference").linear.at(4, 4);
  const glm::vec3 each = draw_cards("moments").linear.at(4, 4),
                  mono = draw_cards("moments", {{"rgb", "false"}}).linear.at(4, 4);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(exact[c], each[c], 0.05f);
  EXPECT_GT(std::abs(exact.g - mono.g), 0.2f) << "a positive control";
}

TEST_F(MomentsTest, ManyOpaqueCardsDoNotTurnBlack) {
  size = {8, 8};
  for (const Kind& kind : kKinds)
    for (const uint32_t count : {2u, 8u, 60u}) {
      SCOPED_TRACE(testing::Message() << count << " cards " << kind.name);
      clear_cards();
      for (uint32_t i = 0; i < count; ++i)
        add({.z = random.f(5, 9), .optical_depth = shared::kOpaqueDepth, .color = glm::vec3(0.5f)});
      for (const glm::vec3& pixel : draw_cards("moments", {{"moments", kind.name}}).linear.pixels)
        ASSERT_NEAR(0.5f, pixel.r, 2.0f / 255);
    }
}

TEST_F(MomentsTest, DepthBoundsEncloseWhatIsSeen) {
  for (int i = 0; i < 40; ++i)
    add({.z = float(random.octaves(0.05, 200)),
         .half_size = {random.octaves(0.1, 9), random.octaves(0.1, 9)},
         .at = {random.f(-20, 20), random.f(-10, 10)},
         .yaw = random.f(-3, 3),
         .pitch = random.f(-1, 1)});
  double nearest = 1e9, farthest = 0;
  for (const shared::Card& card : cards())
    if (const CardBounds b = bounds_of(card, view()); b.seen) {
      nearest = std::min(nearest, b.nearest);
      farthest = std::max(farthest, b.farthest);
    }
  const std::unique_ptr<World> w = world();
  MethodInstance method = instance("moments");
  render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method);
  const nlohmann::json told_of = method.method->statistics(device, method.resources);
  EXPECT_NEAR(nearest, told_of["nearest_m"].get<double>(), nearest * 1e-5);
  EXPECT_NEAR(farthest, told_of["farthest_m"].get<double>(), farthest * 1e-5);
}

}  // namespace
}  // namespace plume
