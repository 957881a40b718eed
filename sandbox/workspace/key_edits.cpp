#include "sandbox/workspace/key_edits.h"

#include <algorithm>
#include <cmath>

namespace plume {
namespace {

template <class Keys>
float between_neighbours(const Keys& keys, size_t key, float at) {
  const float low = key > 0 ? keys[key - 1].at + kKeyDistance : 0.0f;
  const float high = key + 1 < keys.size() ? keys[key + 1].at - kKeyDistance : 1.0f;
  return low < high ? std::clamp(at, low, high) : keys[key].at;
}

template <class Keys>
std::optional<size_t> insert(Keys& keys, typename Keys::value_type key) {
  const auto next = std::ranges::lower_bound(keys, key.at, {}, &Keys::value_type::at);
  const bool crowded = (next != keys.end() && next->at - key.at < kKeyDistance) ||
                       (next != keys.begin() && key.at - std::prev(next)->at < kKeyDistance);
  if (crowded || key.at < 0 || key.at > 1) return {};
  const auto place = keys.insert(next, key);
  return size_t(place - keys.begin());
}

template <class Keys>
void remove(Keys& keys, size_t key) {
  if (keys.size() > 1) keys.erase(keys.begin() + std::ptrdiff_t(key));
}

}  // namespace

float rounded(double value, double grain) {
  // Divided rather than multiplied: the power of ten that is less than 1 is not exact.
  const double power = std::floor(std::log10(grain));
  const double step = std::pow(10.0, std::abs(power));
  return float(power < 0 ? std::round(value * step) / step : std::round(value / step) * step);
}

std::optional<size_t> add_key(Curve& curve, float at, float value) {
  return insert(curve.keys, {at, value});
}

std::optional<size_t> add_key(Gradient& gradient, float at) {
  return insert(gradient.keys, {at, gradient.at(at)});
}

void remove_key(Curve& curve, size_t key) {
  remove(curve.keys, key);
}

void remove_key(Gradient& gradient, size_t key) {
  remove(gradient.keys, key);
}

void move_key(Curve& curve, size_t key, float at, float value, const Limits& limits) {
  curve.keys[key].at = between_neighbours(curve.keys, key, at);
  curve.keys[key].value = float(std::clamp(double(value), limits.min, limits.max));
}

void move_key(Gradient& gradient, size_t key, float at) {
  gradient.keys[key].at = between_neighbours(gradient.keys, key, at);
}

Axis axis_of(const Curve& curve) {
  const auto [least, largest] = curve.extremes();
  double low = least.value, high = largest.value;
  if (low > 0 && low < 0.6 * high) low = 0;
  if (high < 0 && high > 0.6 * low) high = 0;
  if (high - low < 1e-6) {
    const double air = std::max(std::abs(high), 0.01);
    return {low - 0.5 * air, high + 0.5 * air};
  }
  const double air = 0.12 * (high - low);
  return {low == 0 ? low - 0.3 * air : low - air, high + air};
}

}  // namespace plume
