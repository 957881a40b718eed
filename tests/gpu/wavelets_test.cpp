// Wavelet transparency against its transform in double precision, and against what is published of it.
#include "sandbox/measure/metrics.h"
#include "tests/gpu/absorbance_scene.h"

namespace plume {
namespace {

class WaveletsTest : public AbsorbanceTest {
 protected:
  using AbsorbanceTest::shoot;
  Shot shoot(const Map& settings) { return shoot("wavelets", settings); }
  /// Absorbance averaged over [from, to], in leaves, the last of which begins at place 1.
  static glm::dvec3 mean(const std::vector<Step>& steps, uint32_t leaves, double from, double to) {
    glm::dvec3 sum(0.0);
    for (const Step& s : steps)
      sum += s.absorbance * std::clamp((to - s.place * (leaves - 1)) / (to - from), 0.0, 1.0);
    return sum;
  }
  /// Coefficient n of all: the mean, then half the difference of the means over halves of each interval.
  static glm::dvec3 coefficient(const std::vector<Step>& steps, uint32_t n, uint32_t leaves) {
    if (n == 0) return mean(steps, leaves, 0, leaves);
    const double level = std::floor(std::log2(n)), width = leaves / std::exp2(level);
    const double from = (n - std::exp2(level)) * width;
    return 0.5 * (mean(steps, leaves, from, from + width / 2) -
                  mean(steps, leaves, from + width / 2, from + width));
  }
};

TEST_F(WaveletsTest, CoefficientsAreHalfTheDifferencesOfMeans) {
  for (uint32_t rank = 1; rank <= 4; ++rank)
    for (const bool scene_range : {false, true})
      for (const bool coloured : {false, true}) {
        SCOPED_TRACE(testing::Message() << "rank " << rank << (scene_range ? " scene" : " pixel")
                                        << (coloured ? " coloured" : ""));
        clear_cards();
        add_random_cards(12, coloured);
        const Shot shot = shoot({{"rank", std::to_string(rank)},
                                 {"range", scene_range ? "scene" : "pixel"},
                                 {"rgb", coloured ? "true" : "false"},
                                 {"unfold", "false"}});
        const auto found = gpu::read<float>(device, shot.method.resources.buffer("coefficients"));
        const uint32_t leaves = 2u << rank, channels = coloured ? 3 : 1, sums = coloured ? 4 : 1;
        ASSERT_EQ(size_t(size.x) * size.y * leaves * sums, found.size());
        for (uint32_t y = 0; y < size.y; ++y)
          for (uint32_t x = 0; x < size.x; ++x) {
            const auto steps = steps_at(glm::dvec2(x, y) + 0.5, scene_range, coloured);
            double total = 1;
            for (const Step& s : steps) total += s.absorbance.r;
            for (uint32_t n = 0; n < leaves; ++n)
              for (uint32_t c = 0; c < channels; ++c) {
                // What dims all channels alike, and what does not.
                const float* at = &found[((y * size.x + x) * leaves + n) * sums];
                ASSERT_NEAR(coefficient(steps, n, leaves)[int(c)],
                            double(at[0]) + (coloured ? double(at[1 + c]) : 0.0), 2e-5 * total)
                    << x << ", " << y << ": " << n << ", " << c;
              }
          }
      }
}

TEST_F(WaveletsTest, ReadsTheSameWhetherItsTransformIsInvertedFirstOrNot) {
  for (int rank = 1; rank <= 4; ++rank)
    for (const char* resolution : {"1/1", "1/4"}) {
      clear_cards();
      add_random_cards(12, rank % 2 == 0);
      Map settings{{"rank", std::to_string(rank)}, {"resolution", resolution}};
      const Image unfolded = shoot(settings).picture.linear;
      settings["unfold"] = "false";
      EXPECT_LT(max_abs(unfolded, shoot(settings).picture.linear).value, 1e-3) << "rank " << rank;
    }
}

TEST_F(WaveletsTest, TellsApartExactlyWhatLiesOnTheBoundariesOfLeaves) {
  scene.far_m = 100.0f;
  for (int rank = 1; rank <= 4; ++rank) {
    SCOPED_TRACE(rank);
    const int leaves = 2 << rank;
    clear_cards();
    std::vector<float> boundaries, expected;
    double through = 1;
    for (int k = 0; k < leaves; ++k) {
      const double z =
          double(scene.near_m) * std::pow(double(scene.far_m / scene.near_m), k / (leaves - 1.0));
      boundaries.push_back(float(z));
      expected.push_back(float(through));
      const double tau = k == 0 ? 0 : 0.1 + 0.07 * k;  // the near plane clips
      if (k > 0) add({.z = float(z), .optical_depth = float(tau), .color = {0.1f * float(k), 0.5f, 0.2f}});
      through *= std::exp(-tau);
    }
    const Map settings{{"rank", std::to_string(rank)}, {"range", "scene"}};
    const auto told = probe_at("wavelets", {8, 6}, boundaries, settings);
    for (size_t k = 0; k < told.size(); ++k) EXPECT_NEAR(expected[k], told[k].r, 2e-5) << "boundary " << k;
    const auto exact = draw_cards("reference").linear, drawn = shoot(settings).picture.linear;
    EXPECT_LT(rmse(exact, drawn), 1e-3);
  }
}

TEST_F(WaveletsTest, AFragmentDoesNotShadeItselfWhereverInItsLeafItLies) {
  scene.far_m = 100.0f;
  const auto least_and_most = [&](const char* exclude_self) {
    std::pair<float, float> seen(2, 0);
    for (int place = 0; place <= 16; ++place) {
      clear_cards();
      // Through leaf 4 of 8.
      const double x = (4 + place / 16.0) / 7;
      add({.z = float(double(scene.near_m) * std::pow(double(scene.far_m / scene.near_m), x)),
           .optical_depth = std::log(2.0f)});
      const Shot shot = shoot({{"rank", "2"}, {"range", "scene"}, {"exclude_self", exclude_self}});
      const float weight = weighted_sums(shot)[0].a / 0.5f;
      seen = {std::min(seen.first, weight), std::max(seen.second, weight)};
    }
    return seen;
  };
  const auto [least, most] = least_and_most("true");
  EXPECT_NEAR(1.0f, least, 1e-3);
  EXPECT_NEAR(1.0f, most, 1e-3);
  // A positive control. Half way through a leaf a fragment reads a quarter of itself.
  const auto [least_shaded, most_shaded] = least_and_most("false");
  EXPECT_NEAR(std::exp2(-0.25f), least_shaded, 2e-3);
  EXPECT_NEAR(1.0f, most_shaded, 1e-3);
}

TEST_F(WaveletsTest, AFragmentInACrowdIsNotShadedByItself) {
  // What it is weighted by is what the probe reads there when it is gone.
  scene.far_m = 100.0f;
  for (int rank = 1; rank <= 4; ++rank)
    for (const char* range : {"pixel", "scene"}) {
      SCOPED_TRACE(testing::Message() << "rank " << rank << " " << range);
      const Map settings{{"rank", std::to_string(rank)}, {"range", range}};
      clear_cards();
      for (const float z : {2.0f, 3.1f, 3.3f, 4.7f, 9.0f}) add({.z = z, .optical_depth = 0.4f + 0.1f * z});
      const float z = float(random.between(2.1, 8.9)), tau = 0.8f;
      const float told = probe_at("wavelets", {8, 6}, {z}, settings)[0].r;
      add({.z = z, .optical_depth = tau, .color = {1, 0, 0}});
      const glm::vec4 sums = weighted_sums(shoot(settings))[6 * size.x + 8];
      EXPECT_NEAR(told, sums.r / (1 - std::exp(-tau)), 2e-3);
    }
}

TEST_F(WaveletsTest, ErrorsFallWithRankOnSmoke) {
  Stage stage(device, pipelines, library, library.scene("grenade"));
  const uint32_t tick = stage.scene().default_tick;
  const glm::uvec2 picture{160, 90};
  const Image exact = draw(stage, tick, picture, "reference").linear;
  double last = 0.027;
  for (const char* rank : {"1", "2", "3", "4"}) {
    const double error = rmse(exact, draw(stage, tick, picture, "wavelets", {{"rank", rank}}).linear);
    EXPECT_LT(error, 0.8 * last) << "rank " << rank;
    last = error;
  }
}

TEST_F(WaveletsTest, IsFiniteAndPlausibleAtExtremes) {
  size = {9, 7};
  for (const uint32_t number : {1u, 200u})
    for (const float tau : {1e-4f, 1.0f, 200.0f})
      for (const bool together : {false, true}) {
        if (together && (number == 1 || tau == 1e-4f)) continue;
        for (const Map& settings : std::vector<Map>{{},
                                                    {{"rank", "1"}},
                                                    {{"rank", "4"}, {"rgb", "true"}},
                                                    {{"range", "scene"}},
                                                    {{"exclude_self", "false"}},
                                                    {{"resolution", "1/4"}}}) {
          SCOPED_TRACE(testing::Message() << number << " of " << tau << (together ? " together " : " ")
                                          << (settings.empty() ? "" : settings.begin()->first));
          clear_cards();
          for (uint32_t i = 0; i < number; ++i)
            add({.z = together ? 4.0f : 2.0f + 0.03f * float(i),
                 .optical_depth = tau,
                 .color = glm::vec3(0.5f),
                 .transmission = i == 0 ? glm::vec3(0, 1e-4f, 0) : glm::vec3(0.0f)});
          const float expected = 0.5f * (1 - std::exp(-tau * float(number)));
          for (const glm::vec3& pixel : shoot(settings).picture.linear.pixels)
            for (int c = 0; c < 3; ++c)
              ASSERT_NEAR(expected, pixel[c], 2e-3 * double(std::max(expected, 0.1f)));
        }
      }
}

TEST_F(WaveletsTest, CountsWhatItClampsAndWhatLiesOutsideTheRange) {
  scene.far_m = 50.0f;
  add({.z = 3, .optical_depth = shared::kOpaqueDepth});
  add({.z = 4, .optical_depth = 15});
  add({.z = 60, .optical_depth = 1});
  const uint32_t pixels = size.x * size.y;
  for (const char* id : {"wavelets", "fourier"})
    for (const bool scene_range : {false, true}) {
      const Shot shot = shoot(id, {{"range", scene_range ? "scene" : "pixel"}});
      const auto counts = shot.method.method->statistics(device, shot.method.resources);
      EXPECT_EQ(pixels, counts["absorbance_clamped"].get<uint32_t>()) << id;
      EXPECT_EQ(scene_range ? pixels : 0u, counts["outside_range"].get<uint32_t>()) << id;
    }
}

TEST_F(WaveletsTest, CoarseCellsSeeWhatAnyOfTheirPixelsSees) {
  size = {37, 21};  // no multiple of a cell
  scene.light.horizon = {0.2f, 0.3f, 0.5f};
  add({.z = 5, .optical_depth = 0.7f, .color = {0.8f, 0.1f, 0.1f}});
  add({.z = 8, .optical_depth = 1.1f, .color = {0.1f, 0.8f, 0.1f}});
  add({.z = 13, .optical_depth = 0.9f, .color = {0.1f, 0.1f, 0.8f}});
  // A wall before the cards, up to within a cell. Beside it nothing may change.
  Solid wall;
  wall.material = Material::kUnlit;
  wall.color = {0.1f, 0.1f, 0.1f};
  wall.position = {-50.05f, 0, -2};
  wall.size_m = {100, 100, 0.1f};
  for (const bool with_wall : {false, true}) {
    if (with_wall) scene.solids = {wall};
    const Image fine = shoot({}).picture.linear;
    for (const char* resolution : {"1/2", "1/4", "1/8"}) {
      SCOPED_TRACE(testing::Message() << resolution << (with_wall ? " with a wall" : ""));
      const Image coarse = shoot({{"resolution", resolution}}).picture.linear;
      for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = with_wall ? 24 : 0; x < size.x; ++x)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(fine.at(x, y)[c], coarse.at(x, y)[c], 2e-3) << x << ", " << y;
    }
  }
}

/// How much a pixel of a near-opaque card changes while the camera moves half a metre, where the exact
/// picture does not change, of 255.
class WaveletsDolly : public WaveletsTest {
 protected:
  int swing_of(std::string_view id, const Map& settings) {
    Stage stage(device, pipelines, library, library.scene("card_dolly"));
    const Targets targets(device, {64, 36});
    MethodInstance reference = instance("reference"), method = instance(id, settings);
    constexpr int kSteps = 25;
    std::vector<std::array<uint8_t, 3>> exact, low, high;
    std::vector<bool> still;
    for (int step = 0; step <= kSteps; ++step) {
      CameraKey camera = stage.scene().camera[0];
      camera.position.z -= 0.5f * float(step) / kSteps;
      stage.go_to(0, targets.size, camera);
      const auto now = draw(stage, targets, reference).display.pixels,
                 drawn = draw(stage, targets, method).display.pixels;
      if (step == 0) exact = now, low = high = drawn, still.assign(now.size(), true);
      for (size_t i = 0; i < now.size(); ++i) {
        still[i] = still[i] && now[i] == exact[i];
        for (size_t c = 0; c < 3; ++c) {
          low[i][c] = std::min(low[i][c], drawn[i][c]);
          high[i][c] = std::max(high[i][c], drawn[i][c]);
        }
      }
    }
    int most = 0;
    for (size_t i = 0; i < still.size(); ++i)
      for (size_t c = 0; c < 3; ++c)
        if (still[i] && *std::ranges::max_element(exact[i]) >= 60)
          most = std::max(most, high[i][c] - low[i][c]);
    return most;
  }
};

TEST_F(WaveletsDolly, SwingsTheColoursOfCardsThatPassThroughLeavesOfAFixedRange) {
  // The published known failure. Leaves of 0.2 octaves: the dolly of 0.09 octaves passes a part of one.
  const Map fixed{{"rank", "2"}, {"range", "scene"}, {"near", "5"}, {"far", "20"}};
  Map published = fixed;
  published["exclude_self"] = "false";
  EXPECT_GT(swing_of("wavelets", published), 30);
  EXPECT_GT(swing_of("wavelets", fixed), 10);
  // In a range of their own the cards keep their places.
  EXPECT_LE(swing_of("wavelets", {{"rank", "2"}}), 1);
  EXPECT_LE(swing_of("avboit", {}), 1);
}

TEST_F(WaveletsTest, AFaintLayerFarBehindMovesTheLeavesOfAPixelsRange) {
  // The same failure where the range is each pixel's own: what stretches it shifts everything in it.
  const auto colour_with_haze_at = [&](float z) {
    clear_cards();
    for (int k = 0; k < 3; ++k) {
      glm::vec3 color(0.05f);
      color[k] = 0.8f;
      add({.z = 8 + 0.25f * float(k), .optical_depth = 5.3f, .color = color});
    }
    add({.z = z, .optical_depth = 0.01f});
    return shoot({}).picture.display.at(8, 6);
  };
  const auto exact = [&] { return draw_cards("reference").display.at(8, 6); };
  const auto difference = [](const auto& a, const auto& b) {
    int most = 0;
    for (size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int(a[c]) - int(b[c])));
    return most;
  };
  const auto close = colour_with_haze_at(8.75f), far = colour_with_haze_at(60);
  EXPECT_LE(difference(close, exact()), 10);
  EXPECT_GT(difference(far, exact()), 25);
}

}  // namespace
}  // namespace plume
