#include "sandbox/effects/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sandbox/effects/emitter_data.h"

namespace plume {
namespace {

constexpr double kTickSeconds = 1.0 / kTicksPerSecond;
constexpr double kStandardGravity = 9.81;
constexpr double kUlp = 1.0 / (1 << 23);  // of a float, relative: twice the rounding of one operation

/// The largest value of |curl_noise| in shaders/effects/noise.glsl. It is the cross product of two gradients
/// of value noise with corners in [-1, 1]. A gradient is a linear function of the corners, so it is longest
/// at a corner of their cube, all of them -1 or 1; over these 256 cases it is longest in the middle between
/// two opposite faces, 2 times the largest slope of the quintic, 15/8.
constexpr double kMostCurl = (2.0 * 15.0 / 8.0) * (2.0 * 15.0 / 8.0);

struct Interval {
  double low = 0, high = 0;
  double most() const { return std::max(std::abs(low), std::abs(high)); }
};
using Box = std::array<Interval, 3>;

Interval operator+(Interval a, Interval b) {
  return {a.low + b.low, a.high + b.high};
}
Interval operator*(Interval a, Interval b) {
  const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}
Interval around(double size) {
  return {-size, size};
}
Interval exactly(double value) {
  return {value, value};
}
Box exactly(glm::vec3 v) {
  return {exactly(v.x), exactly(v.y), exactly(v.z)};
}
Box operator+(const Box& a, const Box& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

void join(Interval& a, Interval b) {
  a = {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// As the particles' kernels turn vectors about +y.
Box turn(const Box& v, float yaw_deg) {
  const double yaw = glm::radians(double(yaw_deg));
  const Interval s = exactly(std::sin(yaw)), c = exactly(std::cos(yaw)), minus_s = exactly(-std::sin(yaw));
  return {v[0] * c + v[2] * s, v[1], v[2] * c + v[0] * minus_s};
}

/// All of them but boxes, as far as a box about them can tell.
bool is_round_about_y(const Shape& shape) {
  return shape.kind != ShapeKind::kBox;
}

/// Places of birth about the shape's middle; the instance's frame.
Box birth_places(const Shape& shape) {
  const Interval round = around(shape.radius_m);
  switch (shape.kind) {
    case ShapeKind::kPoint:
      return {};
    case ShapeKind::kSphere:
      return {round, round, round};
    case ShapeKind::kHemisphere:
      return {round, {0, shape.radius_m}, round};
    case ShapeKind::kBox:
      return {around(shape.size_m.x / 2), around(shape.size_m.y / 2), around(shape.size_m.z / 2)};
    case ShapeKind::kCone:
    case ShapeKind::kRing:
      return {round, {}, round};
  }
  return {};
}

/// Directions outwards: within the box of unit vectors.
Box outwards(const Shape& shape) {
  const Interval any = around(1);
  switch (shape.kind) {
    case ShapeKind::kPoint:
    case ShapeKind::kSphere:
      return {any, any, any};
    case ShapeKind::kHemisphere:
      return {any, {0, 1}, any};
    case ShapeKind::kBox:
      return {Interval{}, exactly(1), Interval{}};
    case ShapeKind::kCone: {
      const double angle = glm::radians(double(shape.angle_deg));
      return {around(std::sin(angle)), {std::cos(angle), 1}, around(std::sin(angle))};
    }
    case ShapeKind::kRing:
      return {any, {}, any};
  }
  return {any, any, any};
}

Box path_places(const Path* path) {
  if (!path) return {};
  Box box = exactly(path->keys().front().position);
  for (const Path::Key& key : path->keys())
    for (int c = 0; c < 3; ++c) join(box[c], exactly(key.position[c]));
  return box;
}

/// Accelerations that depend on the place, of any direction in an axis.
Box anywhere(const Motion& motion) {
  double curl = 0, strength = std::abs(double(motion.curl.strength));
  for (uint32_t octave = 0; octave < motion.curl.octaves; ++octave, strength /= 2)
    curl += strength * kMostCurl;
  // Across and along the arm: at right angles. The swirl is largest, and 1, at the core's radius.
  const double vortex = std::hypot(motion.vortex.strength, motion.vortex.pull);
  return {around(curl + vortex), around(curl), around(curl + vortex)};
}

/// The largest half diagonal of a card that does not move, by age.
class CardSizes {
 public:
  CardSizes(const Look& look, Range<uint32_t> life)
      : scale_(double(look.radius_scale.max)), life_(life), curves_(bake_curves(look)) {}
  double radius(uint32_t age) const {
    constexpr uint32_t kLast = shared::kCurveSamples - 1;
    // Lives are at least 1 tick; what is drawn is between the samples around each life's share.
    const uint32_t first = uint32_t(uint64_t(age) * kLast / life_.max);
    const uint32_t last = uint32_t((uint64_t(age) * kLast + life_.min - 1) / life_.min) + 1;
    double most = 0;
    for (uint32_t i = first > 0 ? first - 1 : 0; i <= std::min(last, kLast); ++i)
      most = std::max(most, double(curves_[i].x));
    return most * scale_ * (1 + 4 * kUlp);
  }

 private:
  double scale_;
  Range<uint32_t> life_;
  CurveTable curves_;
};

/// One axis of a particle's motion.
struct Axis {
  Interval place, velocity;

  void step(Interval acceleration, double wind, double slowing) {
    const auto slowed = [&](double v, double a) { return wind + (v + a * kTickSeconds - wind) * slowing; };
    velocity = {slowed(velocity.low, acceleration.low), slowed(velocity.high, acceleration.high)};
    const double size = velocity.most() + std::abs(wind) + acceleration.most() * kTickSeconds;
    velocity = velocity + around(4 * kUlp * size);
    const Interval way = velocity * exactly(kTickSeconds);
    place = place + way + around(kUlp * (place.most() + way.most()));
  }
  /// What would fall below the floor lies on it, and no longer falls.
  void stay_above(double floor) {
    if (!(place.low < floor)) return;
    if (place.high < floor) velocity.low = std::max(velocity.low, 0.0);
    velocity.high = std::max(velocity.high, 0.0);
    place = {floor, std::max(place.high, floor)};
  }
};

Bounds bounds_of(const Emitter& emitter, const Placement& placement) {
  const auto& [name, spawn, shape, motion, look] = emitter;
  const glm::vec3 wind = placement.wind * motion.wind;
  const Interval speed{motion.speed.min, motion.speed.max};
  Box outward = outwards(shape);
  for (Interval& axis : outward) axis = axis * speed;
  const float yaw = placement.yaw_deg, shape_yaw = is_round_about_y(shape) ? 0.0f : yaw;
  const Box places = exactly(placement.position) + path_places(placement.path) +
                     turn(exactly(shape.offset_m), yaw) + turn(birth_places(shape), shape_yaw);
  const Box velocities = turn(outward, shape_yaw) + turn(exactly(motion.velocity), yaw);
  const Box somewhere = anywhere(motion);
  const double slowing = 1 / (1 + double(motion.drag) * kTickSeconds);
  const double cooling = std::exp(-kTickSeconds / double(motion.cooling_s));
  const CardSizes sizes(look, spawn.life_ticks);

  std::array<Axis, 3> axes;
  for (int c = 0; c < 3; ++c)
    axes[c] = {places[c] + around(8 * kUlp * places[c].most()),
               velocities[c] + around(8 * kUlp * velocities[c].most())};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box drawn{Interval{kInfinity, -kInfinity}, {kInfinity, -kInfinity}, {kInfinity, -kInfinity}};
  double buoyancy = motion.buoyancy;
  for (uint32_t age = 0;; ++age) {
    const double v =
        glm::length(glm::dvec3(axes[0].velocity.most(), axes[1].velocity.most(), axes[2].velocity.most()));
    const double radius = sizes.radius(age);
    const Interval card = around(std::hypot(radius, radius + v * double(look.stretch_s)));
    for (int c = 0; c < 3; ++c) join(drawn[c], axes[c].place + card);
    if (age + 1 >= spawn.life_ticks.max) break;
    const Box steady{Interval{}, exactly(buoyancy - kStandardGravity * double(motion.gravity)), Interval{}};
    for (int c = 0; c < 3; ++c) axes[c].step(steady[c] + somewhere[c], wind[c], slowing);
    axes[1].stay_above(motion.floor_y);
    buoyancy *= cooling;
  }

  Bounds bounds;
  for (int c = 0; c < 3; ++c) {  // outwards to floats
    bounds.min[c] = std::nextafter(float(drawn[c].low), -std::numeric_limits<float>::infinity());
    bounds.max[c] = std::nextafter(float(drawn[c].high), std::numeric_limits<float>::infinity());
  }
  return bounds;
}

}  // namespace

bool Bounds::contains(glm::vec3 point) const {
  return glm::all(glm::lessThanEqual(min, point)) && glm::all(glm::lessThanEqual(point, max));
}

void Bounds::add(const Bounds& other) {
  min = glm::min(min, other.min);
  max = glm::max(max, other.max);
}

double Bounds::volume() const {
  if (empty()) return 0;
  const glm::dvec3 size = glm::dvec3(max) - glm::dvec3(min);
  return size.x * size.y * size.z;
}

std::vector<Bounds> emitter_bounds(const Effect& effect, const Placement& placement) {
  std::vector<Bounds> result;
  for (const Emitter& emitter : effect.emitters) result.push_back(bounds_of(emitter, placement));
  return result;
}

Bounds effect_bounds(const Effect& effect, const Placement& placement) {
  Bounds all;
  for (const Bounds& bounds : emitter_bounds(effect, placement)) all.add(bounds);
  return all;
}

}  // namespace plume
