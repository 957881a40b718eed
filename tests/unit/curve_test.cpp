#include "sandbox/effects/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sandbox/effects/emitter_data.h"
#include "sandbox/presets/library.h"

namespace plume {
namespace {

TEST(Curve, IsLinearWhereNoSlopeIsGiven) {
  const Curve curve({{0.2f, 1}, {0.6f, 3}});
  EXPECT_EQ(curve.at(0), 1.0f);
  EXPECT_FLOAT_EQ(curve.at(0.3f), 1.5f);
  EXPECT_EQ(curve.at(1), 3.0f);
}

TEST(Curve, HasTheGivenSlopesAtItsKeys) {
  const Curve curve({{0, 1, {}, 2}, {0.5f, 0.5f, -3, 4}, {1, 2, 0, {}}});
  const auto slope = [&](double at, double step) {
    return (curve.at(float(at + step)) - curve.at(float(at))) / step;
  };
  EXPECT_NEAR(slope(0, 1e-3), 2, 0.05);
  EXPECT_NEAR(slope(0.5, -1e-3), -3, 0.05);
  EXPECT_NEAR(slope(0.5, 1e-3), 4, 0.05);
  EXPECT_NEAR(slope(1, -1e-3), 0, 0.05);
  EXPECT_FLOAT_EQ(curve.at(0.5f), 0.5f);
}

TEST(Curve, TheSlopesOfTheChordMakeItStraight) {
  const Curve curve({{0.25f, 1, 8, 8}, {0.5f, 3}});
  for (float life = 0; life <= 1; life += 0.01f)
    EXPECT_NEAR(curve.at(life), std::clamp(1 + 8 * (life - 0.25f), 1.0f, 3.0f), 1e-6f);
}

Curve random_curve(std::mt19937& random) {
  const auto between = [&](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  std::vector<Curve::Key> keys;
  for (float at = between(0, 0.3f); at <= 1; at += between(0.05f, 0.5f)) {
    Curve::Key key{at, between(-2, 2)};
    if (random() % 2) key.in = between(-20, 20);
    if (random() % 2) key.out = between(-20, 20);
    keys.push_back(key);
  }
  return Curve(keys);
}

TEST(Curve, ExtremesAreThoseOfAFineWalk) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const Curve curve = random_curve(random);
    float low = curve.at(0), high = low;
    for (int n = 0; n <= 5000; ++n) {
      const float v = curve.at(float(n) / 5000);
      low = std::min(low, v), high = std::max(high, v);
    }
    const auto [least, largest] = curve.extremes();
    EXPECT_LE(least.value, low + 1e-5);
    EXPECT_GE(largest.value, high - 1e-5);
    EXPECT_NEAR(least.value, low, 5e-3);
    EXPECT_NEAR(largest.value, high, 5e-3);
    EXPECT_NEAR(curve.at(float(least.at)), least.value, 1e-5);
    EXPECT_NEAR(curve.at(float(largest.at)), largest.value, 1e-5);
  }
}

double measured_sampling_error(const Curve& curve, uint32_t samples) {
  double most = 0;
  const auto sample = [&](uint32_t i) { return double(curve.at(float(i) / float(samples - 1))); };
  for (int n = 0; n <= 4000; ++n) {
    const double at = n / 4000.0 * (samples - 1);
    const uint32_t i = std::min(uint32_t(at), samples - 2);
    const double interpolated = sample(i) * (i + 1 - at) + sample(i + 1) * (at - i);
    most = std::max(most, std::abs(interpolated - double(curve.at(float(n) / 4000))));
  }
  return most;
}

TEST(Curve, SamplingErrorIsBounded) {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const Curve curve = random_curve(random);
    for (const uint32_t samples : {32u, 64u})
      EXPECT_LE(measured_sampling_error(curve, samples), curve.sampling_error(samples) + 1e-4) << i;
  }
  EXPECT_EQ(Curve(3).sampling_error(2), 0.0);
}

/// The worst is 0.153: smoke that fades in within a fiftieth of its life. With 32 samples it would be 0.38.
TEST(Curve, ShippedCurvesAreSampledFinelyEnough) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    const Effect effect = library.effect(id);
    for (const Emitter& emitter : effect.emitters)
      for (const Curve& curve :
           {emitter.look.radius_m, emitter.look.fade, emitter.look.opacity.value_or(Curve(0.0f))}) {
        const double largest = std::max(1e-9, curve.extremes().largest.value);
        const double error = measured_sampling_error(curve, shared::kCurveSamples) / largest;
        EXPECT_LE(error, curve.sampling_error(shared::kCurveSamples) / largest + 1e-5)
            << id << "/" << emitter.name;
        EXPECT_LE(error, 0.16) << id << "/" << emitter.name;
      }
  }
}

TEST(Gradient, IsLinearBetweenKeys) {
  const Gradient gradient({{0.5f, {0, 1, 2}}, {1, {1, 1, 0}}});
  EXPECT_EQ(gradient.at(0.25f), glm::vec3(0, 1, 2));
  EXPECT_EQ(gradient.at(0.75f), glm::vec3(0.5f, 1, 1));
}

}  // namespace
}  // namespace plume
