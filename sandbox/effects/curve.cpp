#include "sandbox/effects/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plume {
namespace {

/// Between two keys, over t = 0..1: value = ((a t + b) t + c) t + d.
struct Cubic {
  double a, b, c, d, width;
  double at(double t) const { return ((a * t + b) * t + c) * t + d; }
  double slope(double t) const { return ((3 * a * t + 2 * b) * t + c) / width; }
  double bend(double t) const { return (6 * a * t + 2 * b) / (width * width); }
  /// Where it is level.
  std::vector<double> turns() const {
    if (std::abs(a) < 1e-12 * (std::abs(b) + std::abs(c))) {
      if (b == 0) return {};
      return {-c / (2 * b)};
    }
    const double square = b * b - 3 * a * c;
    if (square < 0) return {};
    const double q = -(b + std::copysign(std::sqrt(square), b));
    if (q == 0) return {0.0};
    return {q / (3 * a), c / q};
  }
};

Cubic segment(const Curve::Key& from, const Curve::Key& to) {
  const double width = double(to.at) - double(from.at), rise = double(to.value) - double(from.value);
  if (!from.out && !to.in) return {0, 0, rise, from.value, width};
  const double m0 = from.out ? *from.out * width : rise, m1 = to.in ? *to.in * width : rise;
  return {m0 + m1 - 2 * rise, 3 * rise - 2 * m0 - m1, m0, from.value, width};
}

/// The first key after `life`.
template <class Key>
size_t next_key(const std::vector<Key>& keys, float life) {
  return size_t(std::ranges::upper_bound(keys, life, {}, &Key::at) - keys.begin());
}

}  // namespace

float Curve::at(float life) const {
  const size_t next = next_key(keys, life);
  if (next == 0) return keys.front().value;
  if (next == keys.size()) return keys.back().value;
  const Key &from = keys[next - 1], &to = keys[next];
  const float f = (life - from.at) / (to.at - from.at);
  if (!from.out && !to.in) return from.value * (1.0f - f) + to.value * f;
  return float(segment(from, to).at(f));
}

Curve::Extremes Curve::extremes() const {
  const Place first{keys.front().value, keys.front().at, 0};
  Extremes result{first, first};
  const auto add = [&](Place place) {
    if (place.value < result.least.value) result.least = place;
    if (place.value > result.largest.value) result.largest = place;
  };
  for (size_t i = 1; i < keys.size(); ++i) {
    add({keys[i].value, keys[i].at, i});
    const Cubic cubic = segment(keys[i - 1], keys[i]);
    for (const double t : cubic.turns())
      if (t > 0 && t < 1) add({cubic.at(t), keys[i - 1].at + t * cubic.width, i - 1});
  }
  return result;
}

double Curve::sampling_error(uint32_t samples) const {
  // Outside its keys the curve is level. What is off by a kink and by a bend in one interval adds up; several
  // kinks in one add up too.
  const double h = 1.0 / (samples - 1);
  double most = 0;
  std::vector<std::array<double, 2>> kinks;  // at, size
  std::vector<double> bends;                 // the largest of each segment
  double slope = 0;
  for (size_t i = 0; i < keys.size(); ++i) {
    double after = 0, bend = 0;
    if (i + 1 < keys.size()) {
      const Cubic cubic = segment(keys[i], keys[i + 1]);
      after = cubic.slope(0);
      bend = std::max(std::abs(cubic.bend(0)), std::abs(cubic.bend(1)));
      bends.push_back(bend);
      kinks.push_back({keys[i].at, std::abs(after - slope)});
      slope = cubic.slope(1);
    } else {
      kinks.push_back({keys[i].at, std::abs(slope)});
    }
  }
  const double steepest_bend = bends.empty() ? 0 : *std::ranges::max_element(bends);
  for (uint32_t cell = 0; cell + 1 < samples; ++cell) {
    double here = steepest_bend * h * h / 8;
    for (const auto& [at, size] : kinks)
      if (at > cell * h && at < (cell + 1) * h) here += size * h / 4;
    most = std::max(most, here);
  }
  return most;
}

glm::vec3 Gradient::at(float life) const {
  const size_t next = next_key(keys, life);
  if (next == 0) return keys.front().value;
  if (next == keys.size()) return keys.back().value;
  const float f = (life - keys[next - 1].at) / (keys[next].at - keys[next - 1].at);
  return keys[next - 1].value * (1.0f - f) + keys[next].value * f;
}

}  // namespace plume
