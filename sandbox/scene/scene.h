// What a scene is: opaque solids, transparent panes, light, a camera on a timeline, and the effect instances
// it declares. Plain data, read from presets/scenes/*.toml. Metres, y up, right-handed, linear colours, ticks
// of 1/60 s.
#ifndef PLUME_SCENE_SCENE_H
#define PLUME_SCENE_SCENE_H

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/effects/clock.h"
#include "sandbox/effects/path.h"

namespace plume {

enum class Material : uint32_t {
  kPlain,
  kAsphalt,
  kBrick,
  kWood,
  kConcrete,
  kUnlit
};  // unlit: colour is radiance
enum class SolidKind : uint32_t { kPlane, kBox, kSphere, kCapsule };
/// As files have them, in the order of the enumerators.
constexpr std::string_view kMaterialNames[] = {"plain", "asphalt", "brick", "wood", "concrete", "unlit"};
constexpr std::string_view kSolidNames[] = {"plane", "box", "sphere", "capsule"};

/// An analytic opaque body: drawn, casts shadows, and is what particles will collide with.
struct Solid {
  SolidKind kind = SolidKind::kBox;
  Material material = Material::kPlain;
  glm::vec3 color{0.5f};
  glm::vec3 position{0.0f};  ///< plane: any point on it (normal is +y); box, sphere: centre; capsule: one end
  glm::vec3 end{0.0f};       ///< capsule: other end
  glm::vec3 size_m{1.0f};    ///< box: full extents; plane: extents in x and z
  float radius_m = 0.5f;     ///< sphere, capsule
  float yaw_deg = 0.0f;      ///< box, about +y
  bool operator==(const Solid&) const = default;
};

/// A flat transparent rectangle (glass, card, painted quad).
struct Pane {
  glm::vec3 position{0.0f};  ///< centre
  float yaw_deg = 0.0f;      ///< 0 faces +z
  float pitch_deg = 0.0f;
  glm::vec2 size_m{1.0f};
  glm::vec3 color{0.0f};         ///< reflected radiance where covered (not premultiplied)
  float coverage = 1.0f;         ///< alpha, 0..1
  glm::vec3 transmission{0.0f};  ///< share of light that passes where covered
  float diffusion_deg = 0.0f;    ///< standard deviation of the angle by which what passes is scattered
  glm::vec3 emission{0.0f};
  int draw_order = 0;  ///< the artist's, for methods that take it: lower ones are drawn first, behind
  bool operator==(const Pane&) const = default;
};

/// A thin lens: what is nearer or farther than the focus blurs.
struct DepthOfField {
  float focus_m = 5.0f;       ///< view depth that is sharp
  float aperture_mm = 25.0f;  ///< diameter of the opening
  bool operator==(const DepthOfField&) const = default;
};

struct CameraKey {
  uint32_t tick = 0;
  glm::vec3 position{0.0f, 1.7f, 8.0f};
  glm::vec3 target{0.0f, 1.0f, 0.0f};
  float vertical_fov_deg = 50.0f;
  bool operator==(const CameraKey&) const = default;
};

enum class Tonemap : uint32_t { kNone, kAces };
constexpr std::string_view kTonemapNames[] = {"none", "aces"};

struct Light {
  bool sky = true;  ///< false: the background is `horizon` everywhere
  glm::vec3 zenith{0.25f, 0.45f, 0.85f};
  glm::vec3 horizon{0.75f, 0.8f, 0.85f};
  glm::vec3 sun_direction{0.4f, 0.7f, 0.5f};  ///< towards the sun; normalised by the reader
  glm::vec3 sun_color{3.0f, 2.8f, 2.5f};      ///< irradiance / pi
  bool self_shadow = true;                    ///< smoke shadows itself, other smoke and what stands around
  uint32_t shadow_cells = 48;                 ///< of the extinction volume, each way
  float fire_light = 1.0f;  ///< what glows lights smoke and what stands around, times this; 0: it does not
  bool operator==(const Light&) const = default;
};

/// Where a file names another preset, for messages once that name is looked up.
struct FilePosition {
  std::string file;
  uint32_t line = 1, column = 1;
  bool operator==(const FilePosition&) const = default;
};

/// What a scene says of a layer of an effect: its camera offset here, instead of the effect's.
struct LayerOffset {
  std::string layer;
  float camera_offset_m = 0.0f;
  FilePosition at;
  bool operator==(const LayerOffset&) const = default;
};

struct Instance {
  std::string name;
  std::string effect;  ///< id of an effect
  FilePosition effect_at;
  std::optional<uint32_t> call_tick;  ///< nothing: declared but not called; costs nothing
  std::optional<uint32_t> stop_tick;  ///< nothing is born from here on; what lives goes on
  std::vector<Freeze> freezes;        ///< one after the other
  glm::vec3 position{0.0f};
  std::optional<Path> path;  ///< where it goes from there
  float yaw_deg = 0.0f;
  uint32_t seed = 0;
  int draw_order = 0;  ///< added to that of the effect's emitters
  std::vector<LayerOffset> layers;
  bool operator==(const Instance&) const = default;
};

struct Scene {
  std::string id;
  std::string file;  ///< that it was read from; "": none
  std::string name;
  std::string description;
  uint32_t seed = 1;
  uint32_t duration_ticks = 600;
  uint32_t default_tick = 0;  ///< the tick `compare` shows when none is asked for
  float near_m = 0.1f;
  float far_m = 500.0f;
  float exposure = 1.0f;
  Tonemap tonemap = Tonemap::kAces;
  glm::vec3 wind{0.0f};  ///< m/s
  Light light;
  std::optional<DepthOfField> depth_of_field;  ///< nothing: everything is sharp
  std::vector<CameraKey> camera;               ///< at least one; ticks ascend strictly; linear between keys
  std::vector<Solid> solids;
  std::vector<Pane> panes;
  std::vector<Instance> instances;
  bool operator==(const Scene&) const = default;
};

/// The camera at a tick: linear between keys, constant outside them.
CameraKey camera_at(const std::vector<CameraKey>& keys, uint32_t tick);

}  // namespace plume
#endif
