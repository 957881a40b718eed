#include "sandbox/effects/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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

/// Turning the instance does not change a box about it.
bool is_round_about_y(const Shape& shape) {
  using enum ShapeKind;
  return shape.kind != kBox && shape.kind != kLine && shape.kind != kMesh;
}

Box mesh_places(const Effect& effect, const Shape& shape) {
  const auto mesh = std::ranges::find(effect.meshes, shape.mesh.id, &Mesh::id);
  if (mesh == effect.meshes.end() || mesh->triangles.empty()) return {};
  Box box = exactly(mesh->triangles.front().front());
  for (const auto& triangle : mesh->triangles)
    for (const glm::vec3 corner : triangle)
      for (int c = 0; c < 3; ++c) join(box[c], exactly(corner[c]));
  for (Interval& axis : box) axis = axis * exactly(shape.scale);
  return box;
}

/// Places of birth about the shape's middle; the instance's frame.
Box birth_places(const Effect& effect, const Shape& shape) {
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
    case ShapeKind::kLine: {
      Box box{};
      for (int c = 0; c < 3; ++c) join(box[c], exactly(shape.to_m[c]));
      return box;
    }
    case ShapeKind::kMesh:
      return mesh_places(effect, shape);
  }
  return {};
}

/// Directions outwards: within the box of unit vectors.
Box outwards(const Shape& shape) {
  const Interval any = around(1);
  switch (shape.kind) {
    case ShapeKind::kPoint:
    case ShapeKind::kSphere:
    case ShapeKind::kMesh:
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
    case ShapeKind::kLine: {  // across it
      const glm::dvec3 along = glm::normalize(glm::dvec3(shape.to_m));
      const auto across = [](double d) { return around(std::sqrt(std::max(0.0, 1 - d * d)) + 1e-6); };
      return {across(along.x), across(along.y), across(along.z)};
    }
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

/// Of all octaves of a turbulence of that strength, along an axis.
double most_turbulence(float strength, uint32_t octaves) {
  double sum = 0, weight = std::abs(double(strength)) * kMostCurl;
  for (uint32_t octave = 0; octave < octaves; ++octave, weight /= 2) sum += weight;
  return sum;
}

/// The vectors of a field, and none outside it.
Box field_vectors(const std::optional<VectorField>& field, float yaw_deg) {
  Box box{};
  if (!field || !field->grid) return box;
  for (const glm::vec3 cell : field->grid->cells)
    for (int c = 0; c < 3; ++c) join(box[c], exactly(double(cell[c]) * double(field->strength)));
  for (Interval& axis : box) axis = axis + around(16 * kUlp * axis.most());
  return turn(box, yaw_deg);
}

bool adds_to_wind(const Motion& motion) {
  return motion.field && motion.field->use == VectorField::Use::kVelocity;
}

/// Accelerations that depend on the place.
Box anywhere(const Motion& motion, float yaw_deg) {
  double every = most_turbulence(motion.curl.strength, motion.curl.octaves);
  for (const Attractor& attractor : motion.attractors)  // 2^1.5 x / (1 + x^2)^1.5 is largest at x^2 = 1/2
    every += 1.0887 * std::abs(double(attractor.strength));
  // Across and along the arm: at right angles. The swirl is largest, and 1, at the core's radius.
  const double vortex = std::hypot(motion.vortex.strength, motion.vortex.pull);
  const Box vectors = adds_to_wind(motion) ? Box{} : field_vectors(motion.field, yaw_deg);
  return Box{around(every + vortex), around(every), around(every + vortex)} + vectors;
}

/// What ribbons reach beyond their half width at a bend, and meshes beyond the radius where they stand on
/// what their middle or their collider's surface was: kLongestMitre in shaders/effects/cards_ribbon.comp,
/// placed_mesh in tumble.glsl.
constexpr double kLongestMitre = 2.5, kStanding = 2.0;

/// How far from its place a particle is drawn that has this radius and goes this fast.
double reach_of(const Emitter& emitter, double radius, double speed) {
  const Look& look = emitter.look;
  if (look.ribbon) return kLongestMitre * radius;
  if (!look.meshes.empty())
    return kStanding * radius + emitter.motion.collision.value_or(Collision{}).radius_m;
  return std::hypot(radius, radius + speed * double(look.stretch_s));
}

/// The largest radius, by age.
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

double largest_step(const Path* path) {
  double most = 0;
  for (size_t i = 1; path && i < path->keys().size(); ++i) {
    const Path::Key &a = path->keys()[i - 1], &b = path->keys()[i];
    most = std::max(most, double(glm::distance(a.position, b.position)) / double(b.tick - a.tick));
  }
  return most * (1 + 4 * kUlp);
}

/// Where particles that leave a volume die, they are in it; `origin` is where the emitter can be.
Box kill_limits(const Motion& motion, const Box& origin, float yaw_deg) {
  constexpr double kFar = 1e30;
  Box limits{around(kFar), around(kFar), around(kFar)};
  for (const KillVolume& volume : motion.kill) {
    const Box place = origin + turn(exactly(volume.position_m), yaw_deg);
    if (volume.kind == KillVolume::Kind::kPlane) {
      const bool level = volume.normal.x == 0.0f && volume.normal.z == 0.0f;
      if (level && volume.normal.y > 0.0f) limits[1].low = std::max(limits[1].low, place[1].low);
      if (level && volume.normal.y < 0.0f) limits[1].high = std::min(limits[1].high, place[1].high);
      continue;
    }
    if (!volume.outside) continue;
    const Interval ball = around(volume.radius_m);
    const glm::vec3 half = volume.size_m * 0.5f;
    const Box inside = place + (volume.kind == KillVolume::Kind::kSphere
                                    ? Box{ball, ball, ball}
                                    : turn({around(half.x), around(half.y), around(half.z)}, yaw_deg));
    for (int c = 0; c < 3; ++c)
      limits[c] = {std::max(limits[c].low, inside[c].low), std::min(limits[c].high, inside[c].high)};
  }
  for (Interval& axis : limits) axis = axis + around(32 * kUlp * axis.most());
  return limits;
}

/// Colliders push out what is born in them: to anywhere on those that a birth may be in.
void push_out(Box& places, const Collision& collision, const std::vector<Solid>* solids) {
  const Box before = places;
  // Boxes push first, then round solids: twice through the list, in whatever order it is.
  std::vector<Solid> all = solids ? *solids : std::vector<Solid>{};
  for (size_t i = 0, count = all.size(); i < count; ++i) all.push_back(all[i]);
  for (const Solid& solid : all) {
    Box body = exactly(solid.position);
    const double round = solid.radius_m;
    switch (solid.kind) {
      case SolidKind::kPlane:  // a deep box: its lower side is far, so the way out is up or aside
        body = body + Box{around(solid.size_m.x / 2), Interval{}, around(solid.size_m.z / 2)};
        body[1].low = std::min(body[1].low, before[1].low);
        break;
      case SolidKind::kBox:
        body =
            body + turn({around(solid.size_m.x / 2), around(solid.size_m.y / 2), around(solid.size_m.z / 2)},
                        solid.yaw_deg);
        break;
      case SolidKind::kCapsule:
        for (int c = 0; c < 3; ++c) join(body[c], exactly(solid.end[c]));
        [[fallthrough]];
      case SolidKind::kSphere:
        body = body + Box{around(round), around(round), around(round)};
        break;
    }
    for (Interval& axis : body)
      axis = axis + around(double(collision.radius_m) + 2e-5 + 8 * kUlp * axis.most());
    bool apart = false;
    for (int c = 0; c < 3; ++c) apart |= body[c].high < places[c].low || body[c].low > places[c].high;
    if (apart) continue;
    for (int c = 0; c < 3; ++c) join(places[c], body[c]);
  }
}

double length_of(const Box& box, const std::array<bool, 3>& axes) {
  double square = 0;
  for (int c = 0; c < 3; ++c)
    if (axes[c]) square += box[c].most() * box[c].most();
  return std::sqrt(square);
}

/// All particles of an age: where they are, m, and how fast, m/s.
struct Cloud {
  Box places, velocities;
};

/// Axis by axis, a tick at a time.
void step_axis(Interval& place, Interval& velocity, Interval acceleration, Interval wind, double slowing) {
  const auto slowed = [&](double v, double a, double u) { return u + (v + a * kTickSeconds - u) * slowing; };
  velocity = {slowed(velocity.low, acceleration.low, wind.low),
              slowed(velocity.high, acceleration.high, wind.high)};
  const double size = velocity.most() + wind.most() + acceleration.most() * kTickSeconds;
  velocity = velocity + around(4 * kUlp * size);
  const Interval way = velocity * exactly(kTickSeconds);
  place = place + way + around(kUlp * (place.most() + way.most()));
}

/// What would fall below the floor lies on it, and no longer falls.
void lift(Interval& place, Interval& velocity, double floor) {
  if (!(place.low < floor)) return;
  if (place.high < floor) velocity.low = std::max(velocity.low, 0.0);
  velocity.high = std::max(velocity.high, 0.0);
  place = {floor, std::max(place.high, floor)};
}

/// In axes that an orbit or a collision mixes, only lengths can be followed: of the velocity, and of the way
/// from `from`, which an orbit turns about the emitter.
struct Mixed {
  std::array<bool, 3> axes{};
  Box from{};
  double way = 0, speed = 0;

  void step(const Box& acceleration, const Box& wind, double slowing, double extra_way, bool collides) {
    const double gained = length_of(acceleration, axes) * kTickSeconds;
    const double u = length_of(wind, axes);
    speed = (u * (1 - slowing) + (speed + gained) * slowing) * (1 + 8 * kUlp);
    way += extra_way;
    if (collides) {
      // A rebound is right to half a tick's gain, and each of 4 impacts may lift by 5 skins.
      speed += gained;
      const double far = std::max({from[0].most(), from[1].most(), from[2].most()}) + way;
      way += 20 * (1e-5 + 4e-7 * far) + gained * kTickSeconds;
    }
    way = (way + speed * kTickSeconds) * (1 + 4 * kUlp) +
          kUlp * (from[0].most() + from[1].most() + from[2].most());
  }
  void place(Cloud& cloud) const {
    for (int c = 0; c < 3; ++c) {
      if (!axes[c]) continue;
      cloud.places[c] = from[c] + around(way);
      cloud.velocities[c] = around(speed);
    }
  }
};

struct Journey {
  Box drawn;    // corners of cards
  Cloud cloud;  // of all ages, the one at which a particle dies included: where children may be born
};

Journey journey_of(const Effect& effect, const Emitter& emitter, const Placement& placement,
                   const Cloud* parents) {
  const Shape& shape = emitter.shape;
  const Motion& motion = emitter.motion;
  const Look& look = emitter.look;
  const float yaw = placement.yaw_deg, shape_yaw = is_round_about_y(shape) ? 0.0f : yaw;
  const Box origin =
      exactly(placement.position) + path_places(placement.path) + turn(exactly(shape.offset_m), yaw);
  const Box births = turn(birth_places(effect, shape), shape_yaw);
  Box outward = outwards(shape);
  for (Interval& axis : outward) axis = axis * Interval{motion.speed.min, motion.speed.max};
  Cloud cloud{(parents ? parents->places : origin) + births,
              turn(outward, shape_yaw) + turn(exactly(motion.velocity), yaw)};
  if (parents)
    for (int c = 0; c < 3; ++c)
      cloud.velocities[c] =
          cloud.velocities[c] + parents->velocities[c] * exactly(emitter.parent->inherit_velocity);
  for (int c = 0; c < 3; ++c) {
    cloud.places[c] = cloud.places[c] + around(8 * kUlp * cloud.places[c].most());
    cloud.velocities[c] = cloud.velocities[c] + around(8 * kUlp * cloud.velocities[c].most());
  }

  const Box somewhere = anywhere(motion, yaw);
  Box wind = exactly(placement.wind * motion.wind);
  if (adds_to_wind(motion)) wind = wind + field_vectors(motion.field, yaw);
  const double slowing = 1 / (1 + double(motion.drag) * kTickSeconds);
  const double cooling = std::exp(-kTickSeconds / double(motion.cooling_s));
  const Box limits = kill_limits(motion, origin, yaw);
  const bool collides = motion.collision.has_value(), orbits = motion.orbit != 0.0f;
  const double moved = orbits ? largest_step(placement.path) : 0;

  Mixed mixed{.axes = {orbits || collides, collides, orbits || collides}};
  Box started = cloud.places;  // where the first step leaves from
  if (collides) push_out(started, *motion.collision, placement.solids);
  if (started[1].low < motion.floor_y) started[1].high = std::max(started[1].high, double(motion.floor_y));
  mixed.from = started;
  if (orbits) {
    // Of arms, the emitter being anywhere on its path: turned ones are as long.
    Box arms = started;
    for (int c = 0; c < 3; ++c) arms[c] = arms[c] + Interval{-origin[c].high, -origin[c].low};
    mixed.from[0] = origin[0], mixed.from[2] = origin[2];
    mixed.way = length_of(arms, {true, false, true});
  }
  mixed.speed = length_of(cloud.velocities, mixed.axes);

  const CardSizes sizes(look, emitter.spawn.life_ticks);
  const double displaced =
      most_turbulence(motion.curl_displacement.amplitude_m, motion.curl_displacement.octaves);
  Journey journey{cloud.places, cloud};
  if (look.ribbon && parents) {  // whose head is at the parent
    const Interval head = around(reach_of(emitter, sizes.radius(0), 0) * (1 + 16 * kUlp) + displaced);
    for (int c = 0; c < 3; ++c) join(journey.drawn[c], parents->places[c] + head);
  }
  double buoyancy = motion.buoyancy;
  for (uint32_t age = 0;; ++age) {
    const double v = length_of(cloud.velocities, {true, true, true});
    const Interval card = around(reach_of(emitter, sizes.radius(age), v) * (1 + 16 * kUlp) + displaced);
    for (int c = 0; c < 3; ++c) join(journey.drawn[c], cloud.places[c] + card);

    const Box steady{Interval{}, exactly(buoyancy - kStandardGravity * double(motion.gravity)), Interval{}};
    buoyancy *= cooling;
    const Box acceleration = steady + somewhere;
    mixed.step(acceleration, wind, slowing, moved, collides);
    for (int c = 0; c < 3; ++c)
      if (!mixed.axes[c]) step_axis(cloud.places[c], cloud.velocities[c], acceleration[c], wind[c], slowing);
    mixed.place(cloud);
    lift(cloud.places[1], cloud.velocities[1], motion.floor_y);
    for (int c = 0; c < 3; ++c) join(journey.cloud.places[c], cloud.places[c]);
    for (int c = 0; c < 3; ++c) join(journey.cloud.velocities[c], cloud.velocities[c]);
    if (age + 1 >= emitter.spawn.life_ticks.max) return journey;
    for (int c = 0; c < 3; ++c) {
      Interval& place = cloud.places[c];
      place = {std::max(place.low, limits[c].low), std::min(place.high, limits[c].high)};
      if (place.low > place.high) return journey;  // none is left
    }
  }
}

Bounds rounded_outwards(const Box& box) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Bounds bounds;
  for (int c = 0; c < 3; ++c) {
    bounds.min[c] = std::nextafter(float(box[c].low), -kInfinity);
    bounds.max[c] = std::nextafter(float(box[c].high), kInfinity);
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
  std::vector<Cloud> clouds;  // parents stand before their children
  for (const Emitter& emitter : effect.emitters) {
    const Journey journey =
        journey_of(effect, emitter, placement, emitter.parent ? &clouds.at(emitter.parent->index) : nullptr);
    clouds.push_back(journey.cloud);
    result.push_back(rounded_outwards(journey.drawn));
  }
  return result;
}

Bounds effect_bounds(const Effect& effect, const Placement& placement) {
  Bounds all;
  for (const Bounds& bounds : emitter_bounds(effect, placement)) all.add(bounds);
  return all;
}

}  // namespace plume
