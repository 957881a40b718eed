// What a hand does to the keys of a curve or a gradient: they stay apart, in order and in their limits, and
// numbers stay short enough to be read in a file.
#ifndef PLUME_WORKSPACE_KEY_EDITS_H
#define PLUME_WORKSPACE_KEY_EDITS_H

#include <optional>

#include "sandbox/presets/field.h"

namespace plume {

/// Of a life, between two keys.
constexpr float kKeyDistance = 0.001f;

/// To the power of ten at or below `grain`, such as what a pixel is worth.
float rounded(double value, double grain);

/// The index of the new key; nothing where there is no room for one.
std::optional<size_t> add_key(Curve& curve, float at, float value);
/// In the color that the gradient has there.
std::optional<size_t> add_key(Gradient& gradient, float at);
/// The last one stays.
void remove_key(Curve& curve, size_t key);
void remove_key(Gradient& gradient, size_t key);
/// As near as its neighbours and the limits allow. The ends of a life are 0 and 1.
void move_key(Curve& curve, size_t key, float at, float value, const Limits& limits);
void move_key(Gradient& gradient, size_t key, float at);

/// The least and the largest value to draw of a curve: all of it, 0 where that is near, and some air.
struct Axis {
  double low, high;
};
Axis axis_of(const Curve& curve);

}  // namespace plume
#endif
