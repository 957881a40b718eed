// Fourier opacity mapping against its series in double precision, and against what is published of it.
#include <numbers>

#include "sandbox/measure/metrics.h"
#include "tests/gpu/absorbance_scene.h"

namespace plume {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::pair<const char*, uint32_t> kLengths[] = {{"7", 3}, {"9", 4}, {"15", 7}};

class FourierTest : public AbsorbanceTest {
 protected:
  using AbsorbanceTest::shoot;
  Shot shoot(const Map& settings) { return shoot("fourier", settings); }

  /// A tenth of the period is left free at each end.
  static double in_period(double place) { return 0.1 + 0.8 * place; }
  static std::vector<double> series(const std::vector<Step>& steps, uint32_t pairs) {
    std::vector<double> sums(2 * pairs + 1);
    for (const Step& s : steps) {
      const double angle = 2 * kPi * in_period(s.place);
      sums[0] += s.absorbance.r;
      for (uint32_t k = 1; k <= pairs; ++k) {
        sums[2 * k - 1] += s.absorbance.r * std::cos(k * angle);
        sums[2 * k] += s.absorbance.r * std::sin(k * angle);
      }
    }
    return sums;
  }
  static double absorbance_in_front(const std::vector<double>& sums, double x) {
    double sum = sums[0] * x;
    for (size_t k = 1; 2 * k < sums.size(); ++k) {
      const double angle = 2 * kPi * double(k) * x;
      sum += (sums[2 * k - 1] * std::sin(angle) + sums[2 * k] * (1 - std::cos(angle))) / (kPi * double(k));
    }
    return std::max(sum, 0.0);
  }
};

TEST_F(FourierTest, SumsTheWavesOfEveryFragment) {
  for (const auto& [coefficients, pairs] : kLengths)
    for (const bool scene_range : {false, true}) {
      SCOPED_TRACE(testing::Message() << coefficients << (scene_range ? " scene" : " pixel"));
      clear_cards();
      add_random_cards(12, true);
      const Shot shot = shoot({{"coefficients", coefficients}, {"range", scene_range ? "scene" : "pixel"}});
      std::vector<std::vector<glm::vec4>> images;
      for (uint32_t i = 0; 4 * i < 2 * pairs + 1; ++i)
        images.push_back(read_layer<glm::vec4>(shot.method.resources.image("series" + std::to_string(i)), 0));
      for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x) {
          const auto sums = series(steps_at(glm::dvec2(x, y) + 0.5, scene_range, false), pairs);
          for (uint32_t n = 0; n < sums.size(); ++n)
            ASSERT_NEAR(sums[n], double(images[n / 4][y * size.x + x][int(n % 4)]), 1e-4 * (1 + sums[0]))
                << x << ", " << y << ": " << n;
        }
    }
}

TEST_F(FourierTest, TellsWhatItsSeriesSays) {
  for (const auto& [coefficients, pairs] : kLengths) {
    clear_cards();
    std::vector<Step> steps;
    const auto depth_at = [](double place) { return 2 * std::exp2(place * 3); };
    for (const double place : {0.0, 0.13, 0.4, 0.45, 0.81, 1.0}) {
      const double tau = random.between(0.05, 0.6);
      add({.z = float(depth_at(place)), .optical_depth = float(tau)});
      steps.push_back({.place = place, .absorbance = glm::dvec3(tau)});
    }
    std::vector<float> depths, expected;
    for (int i = 0; i <= 40; ++i) {
      depths.push_back(float(depth_at(i / 40.0)));
      expected.push_back(float(std::exp(-absorbance_in_front(series(steps, pairs), in_period(i / 40.0)))));
    }
    depths.push_back(100.0f);  // behind everything the sum is exact
    double total = 0;
    for (const Step& s : steps) total += s.absorbance.r;
    expected.push_back(float(std::exp(-total)));
    const auto told = probe_at("fourier", {8, 6}, depths, {{"coefficients", coefficients}});
    for (size_t i = 0; i < told.size(); ++i)
      EXPECT_NEAR(expected[i], told[i].r, 1e-4) << "depth " << depths[i];
  }
}

TEST_F(FourierTest, AFragmentDoesNotShadeItselfWhereverItLies) {
  scene.far_m = 100.0f;
  for (int place = 1; place <= 8; ++place)
    for (const bool exclude_self : {true, false}) {
      clear_cards();
      add({.z = float(double(scene.near_m) * std::pow(double(scene.far_m / scene.near_m), place / 8.0)),
           .optical_depth = std::log(2.0f)});
      const Shot shot = shoot({{"range", "scene"}, {"exclude_self", exclude_self ? "true" : "false"}});
      const float weight = weighted_sums(shot)[0].a / 0.5f;
      if (exclude_self)
        EXPECT_NEAR(1.0f, weight, 1e-3);
      else
        EXPECT_NEAR(std::sqrt(0.5f), weight, 0.05f)
            << "a positive control: it reads half of itself, give or take a ripple";
    }
}

TEST_F(FourierTest, RingsAroundAThickCard) {
  // The published known failure: light is lost in front of the card, and comes back behind it.
  const auto depth_at = [](double place) { return float(2 * std::exp2(place * 3)); };
  std::vector<float> depths;
  for (int i = 1; i < 100; ++i) depths.push_back(depth_at(i / 100.0));
  const auto lost_and_back = [&](const char* id, const Map& settings) {
    clear_cards();
    add({.z = depth_at(0), .optical_depth = 0.001f});
    add({.z = depth_at(0.5), .optical_depth = 5.3f});
    add({.z = depth_at(1), .optical_depth = 0.001f});
    const auto told = probe_at(id, {8, 6}, depths, settings);
    float lost = 0, back = 0, least = 1;
    for (size_t i = 0; i < told.size(); ++i) {
      if (depths[i] < depth_at(0.3)) lost = std::max(lost, 1 - told[i].r);
      back = std::max(back, told[i].r - least);
      least = std::min(least, told[i].r);
    }
    return std::pair(lost, back);
  };
  for (const auto& [coefficients, pairs] : kLengths) {
    const auto [lost, back] = lost_and_back("fourier", {{"coefficients", coefficients}});
    EXPECT_GT(lost, 0.1f) << coefficients;
    EXPECT_GT(back, 0.1f) << coefficients;
  }
  const auto [lost, back] = lost_and_back("wavelets", {});
  EXPECT_LT(lost, 0.01f);
  EXPECT_LT(back, 0.001f);
}

TEST_F(FourierTest, ErrorsFallWithTheLengthOfTheSeriesOnSmoke) {
  Stage stage(device, pipelines, library, library.scene("grenade"));
  const uint32_t tick = stage.scene().default_tick;
  const glm::uvec2 picture{160, 90};
  const Image exact = draw(stage, tick, picture, "reference").linear;
  double last = 0.05;
  for (const auto& [coefficients, pairs] : kLengths) {
    const double error =
        rmse(exact, draw(stage, tick, picture, "fourier", {{"coefficients", coefficients}}).linear);
    EXPECT_LT(error, 0.95 * last) << coefficients;
    last = error;
  }
}

TEST_F(FourierTest, IsFiniteAndPlausibleAtExtremes) {
  size = {9, 7};
  for (const uint32_t number : {1u, 200u})
    for (const float tau : {1e-4f, 200.0f})
      for (const Map& settings : std::vector<Map>{{}, {{"coefficients", "15"}}, {{"resolution", "1/4"}}}) {
        clear_cards();
        for (uint32_t i = 0; i < number; ++i)
          add({.z = 2.0f + 0.03f * float(i), .optical_depth = tau, .color = glm::vec3(0.5f)});
        const float expected = 0.5f * (1 - std::exp(-tau * float(number)));
        for (const glm::vec3& pixel : shoot(settings).picture.linear.pixels)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(expected, pixel[c], 2e-3 * double(std::max(expected, 0.1f)))
                << number << " of " << tau;
      }
}

}  // namespace
}  // namespace plume
