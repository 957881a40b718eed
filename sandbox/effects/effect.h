// What an effect is: emitters, and for each how particles are born, move and look. Plain data, read from
// presets/effects/*.toml; see effects/spawn_schedule.h for births and shaders/effects/ for the simulation.
#ifndef PLUME_EFFECTS_EFFECT_H
#define PLUME_EFFECTS_EFFECT_H

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sandbox/effects/curve.h"
#include "sandbox/effects/field_grid.h"
#include "sandbox/effects/mesh.h"

namespace plume {

constexpr int kTicksPerSecond = 60;
constexpr uint32_t kMaxTick = 20'000'000;  ///< of anything that a file or a command line names: 3.9 days

constexpr uint32_t kMaxLife = 36'000;  ///< ticks that a particle can live: 10 minutes

/// An inclusive range that each particle draws one value from, uniformly.
template <class Value>
struct Range {
  Value min, max;
  bool operator==(const Range&) const = default;
};

/// Births of one emitter, in ticks since the instance was called; effects/spawn_schedule.h adds them up.
struct Spawn {
  struct RateKey {
    uint32_t tick;
    double per_second;
    bool operator==(const RateKey&) const = default;
  };
  struct Burst {
    uint32_t tick;
    uint32_t count;
    bool operator==(const Burst&) const = default;
  };
  std::vector<RateKey>
      rate;  ///< linear between keys; 0 before the first and after the last; ticks ascend strictly
  std::vector<Burst> bursts;  ///< ticks ascend strictly
  Range<uint32_t> life_ticks{60, 60};
  double per_metre = 0;  ///< births for each metre that the instance travels on its path
  bool operator==(const Spawn&) const = default;
};

/// What happens to a parent when it bears children. kLife: they come one by one while it lives.
enum class BirthEvent : uint32_t { kBirth, kLife, kDeath, kCollision };

/// Emitters of children are born of the particles of another emitter, where these are, instead of by a rate.
struct Parent {
  std::string emitter;  ///< of the same effect, earlier in the file
  uint32_t index = 0;   ///< of that emitter
  BirthEvent event = BirthEvent::kBirth;
  uint32_t count = 1;        ///< children a parent; kCollision: a collision; kLife: follows from the life
  uint32_t collisions = 1;   ///< kCollision: how many of them bear
  uint32_t first_tick = 0;   ///< kLife: age of the parent at which the first child comes
  uint32_t every_ticks = 1;  ///< kLife: between children
  float inherit_velocity = 0.0f;  ///< share of the parent's

  /// Children that one parent of a life of at most so many ticks can have.
  uint32_t children(uint32_t longest_life) const {
    if (event == BirthEvent::kCollision) return count * collisions;
    if (event != BirthEvent::kLife) return count;
    return longest_life > first_tick ? (longest_life - first_tick - 1) / every_ticks + 1 : 0;
  }
  bool operator==(const Parent&) const = default;
};
constexpr uint32_t kMostGenerations = 2;  ///< of children below an emitter that has a rate

enum class ShapeKind : uint32_t { kPoint, kSphere, kHemisphere, kBox, kCone, kRing, kLine, kMesh };

/// Where particles are born and which way is outwards, in the instance's frame (y up).
struct Shape {
  ShapeKind kind = ShapeKind::kPoint;
  float radius_m = 0.0f;   ///< sphere, hemisphere, cone base, ring
  float thickness = 1.0f;  ///< 0 = surface only .. 1 = whole volume (sphere, hemisphere, cone, ring)
  glm::vec3 size_m{0.0f};  ///< box, full extents
  float angle_deg = 0.0f;  ///< cone half angle around +y
  glm::vec3 to_m{0.0f};    ///< line: its other end, as seen from the first; outwards is across it, all around
  MeshName mesh;           ///< mesh: births all over its surface, outwards is its normal
  float scale = 1.0f;      ///< mesh: metres for a unit of its file
  glm::vec3 offset_m{0.0f};
  bool operator==(const Shape&) const = default;
};

struct Curl {
  float strength = 0.0f;  ///< m/s^2, acceleration at full noise amplitude
  float scale_m = 1.0f;   ///< wavelength
  float speed = 0.0f;     ///< wavelengths per second the field drifts upwards
  uint32_t octaves = 1;   ///< 1..3
  bool operator==(const Curl&) const = default;
};

/// A line vortex through the emitter's origin along +y.
struct Vortex {
  float strength = 0.0f;  ///< m/s^2 tangential at the core radius
  float radius_m = 1.0f;
  float pull = 0.0f;  ///< m/s^2 towards the axis
  bool operator==(const Vortex&) const = default;
};

/// Pulls towards the nearest point of a segment, or to a point where both ends are the same: a softened point
/// mass.
struct Attractor {
  glm::vec3 from_m{0.0f}, to_m{0.0f};
  float strength = 0.0f;  ///< m/s^2 at the radius, towards it; negative repels
  float radius_m = 1.0f;  ///< inside, it softens to 0
  bool operator==(const Attractor&) const = default;
};

/// Vectors on a grid that stands around the emitter: presets/fields/*.fga.
struct VectorField {
  enum class Use : uint32_t {
    kForce,    ///< m/s^2
    kVelocity  ///< m/s, added to the wind that drag pulls to
  };
  std::string id;
  std::shared_ptr<const FieldGrid> grid;
  Use use = Use::kForce;
  float strength = 1.0f;  ///< times the file's vectors
  float scale = 1.0f;     ///< metres per unit of the file's bounds
  glm::vec3 offset_m{0.0f};
  /// By what is in the grid, which each reading makes anew.
  bool operator==(const VectorField& other) const;
};

/// Where particles end.
struct KillVolume {
  enum class Kind : uint32_t { kBox, kSphere, kPlane };
  Kind kind = Kind::kBox;
  glm::vec3 position_m{0.0f};          ///< centre; plane: a point on it
  glm::vec3 size_m{1.0f};              ///< box, full extents
  float radius_m = 0.5f;               ///< sphere
  glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< plane: what is behind it dies
  bool outside = false;                ///< box, sphere: what is not inside dies
  bool operator==(const KillVolume&) const = default;
};

enum class CollisionResponse : uint32_t { kBounce, kSlide, kDie, kStick };

/// With the scene's solids; a particle meets them as a ball.
struct Collision {
  CollisionResponse response = CollisionResponse::kBounce;
  float bounce = 0.0f;       ///< share of the normal speed that is left: the coefficient of restitution
  float friction = 0.0f;     ///< Coulomb's coefficient
  float radius_m = 0.0f;     ///< of the particle's body
  float event_speed = 0.5f;  ///< m/s: slower impacts are no collision events
  bool operator==(const Collision&) const = default;
};

/// Curl noise that moves what is drawn and leaves the state alone.
struct Displacement {
  float amplitude_m = 0.0f;
  float scale_m = 1.0f;  ///< wavelength
  float speed = 0.0f;    ///< wavelengths per second the field drifts upwards
  uint32_t octaves = 1;  ///< 1..3
  float grow_s = 0.0f;   ///< age at which it has its full amplitude
  bool operator==(const Displacement&) const = default;
};

/// Places and directions are in the emitter's frame: about its origin, turned with the instance.
struct Motion {
  Range<float> speed{0.0f, 0.0f};  ///< m/s along the shape's outward direction
  glm::vec3 velocity{0.0f};        ///< m/s added at birth
  float gravity = 0.0f;            ///< multiples of 9.81 m/s^2
  float drag = 0.0f;               ///< 1/s, pulls the velocity to the wind's
  float wind = 1.0f;               ///< share of the scene's wind this emitter feels
  float buoyancy = 0.0f;           ///< m/s^2 upwards at birth
  float cooling_s = 1.0f;          ///< time in which buoyancy falls to 1/e
  float floor_y = -1e30f;          ///< metres in world space: particles stop falling there (ground plane)
  Curl curl;
  Vortex vortex;
  float orbit = 0.0f;  ///< revolutions/s about +y through the origin: turns position and velocity
  std::vector<Attractor> attractors;
  std::optional<VectorField> field;
  std::vector<KillVolume> kill;
  std::optional<Collision> collision;
  Displacement curl_displacement;
  /// No state is kept: place and velocity follow from the age. With gravity, drag, wind and displacement
  /// only.
  bool analytic = false;
  bool operator==(const Motion&) const = default;
};

enum class TextureKind : uint32_t { kPuff, kDisc, kSoft, kSolid };

/// How a particle looks. Optical depth at the centre of a card comes either from a cross-section (physical:
/// growth thins) or from the artist's opacity curve; exactly one of them is given.
struct Look {
  TextureKind texture = TextureKind::kPuff;
  Curve radius_m{0.5f};
  Range<float> radius_scale{1.0f, 1.0f};  ///< drawn once per particle
  std::optional<float> cross_section_m2;  ///< C: alpha = 1 - exp(-C / (pi r^2)) for the mean of the puff
  std::optional<Curve> opacity;           ///< alpha over life, instead of a cross-section
  Curve fade{1.0f};                       ///< multiplies the optical depth over life
  Gradient color{glm::vec3(0.7f)};        ///< linear albedo
  Gradient emission{glm::vec3(0.0f)};     ///< linear radiance of a fully dense texel
  bool lit = true;                        ///< albedo is lit by sun and sky; otherwise it is radiance itself
  float feather_m = 0.0f;                 ///< z-feather: fades over this distance in front of opaque surfaces
  float near_fade_m = 0.0f;               ///< thins nearer than this to the camera; not what bends
  glm::vec3 transmission{0.0f};           ///< share of light that passes where covered: coloured smoke
  float diffusion_deg = 0.0f;             ///< standard deviation of the angle by which that is scattered
  float distortion_deg = 0.0f;   ///< bends what is seen through it at full slope; it then shows nothing else
  float camera_offset_m = 0.0f;  ///< moves depth along the camera ray, positive towards the camera
  std::string layer;             ///< name of one of the effect's layers, "" = none
  float flipbook_fps = 8.0f;
  float flipbook_loops = 0.0f;  ///< over a life, besides: frames then follow life instead of time
  bool ribbon = false;  ///< consecutive births are joined to a band, twice the radius wide; soft or solid
  uint32_t ribbon_births = 0;  ///< after so many a new ribbon begins; 0: all are one
  Range<float> spin_deg_s{0.0f, 0.0f};
  std::vector<MeshName>
      meshes;  ///< each particle is one of these, its farthest corner at the radius; empty: a flat card
  Range<float> tumble_deg_s{0.0f, 0.0f};  ///< of meshes, about an axis of their own
  float gloss = 0.0f;                     ///< of transparent meshes: share of a glass surface's reflections
  bool opaque = false;                    ///< of meshes: solid pieces that cover what is behind them
  float stretch_s = 0.0f;                 ///< card grows along its velocity by speed * this
  int draw_order = 0;  ///< the artist's, for methods that take it: lower ones are drawn first, behind
};

/// A named camera offset that emitters share: artists' layering. Renderers keep its depths apart.
struct Layer {
  std::string name;
  float camera_offset_m = 0.0f;
};

struct Emitter {
  std::string name;
  std::optional<Parent> parent;  ///< then `spawn` has a life only
  Spawn spawn;
  Shape shape;
  Motion motion;
  Look look;
};

/// What an instance does while nobody sees it.
enum class OffScreen : uint32_t {
  kContinue,  ///< its time goes on: it is then as if it had been seen all the while
  kPause,     ///< its time stands still
};

struct Effect {
  std::string id;  ///< file name without extension
  std::string name;
  std::string description;
  OffScreen off_screen = OffScreen::kContinue;
  std::vector<Layer> layers;
  std::vector<Emitter> emitters;
  std::vector<Mesh> meshes;  ///< each that an emitter names, once
  std::string text;          ///< that it was read from
};

/// Whether the particles of emitter `i` of one version of an effect have the same states as those of `j` of
/// another: what they look like does not matter, what their ancestors do does.
bool same_states(const Effect& a, size_t i, const Effect& b, size_t j);

}  // namespace plume
#endif
