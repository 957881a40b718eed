#include <gtest/gtest.h>

#include <algorithm>

#include "sandbox/effects/effect.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/figure.h"

namespace plume {
namespace {

/// Every key a scene can have.
constexpr std::string_view kEveryKey = R"(
name = "Every key"
description = "What a scene can say."
seed = 4294967295
duration_ticks = 900
default_tick = 300
near_m = 0.05
far_m = 200
exposure = 1.5
tonemap = "none"
wind = [1, 0, -0.5]

[light]
sky = false
zenith = [0.1, 0.2, 0.3]
horizon = [0.4, 0.5, 0.6]
sun_direction = [0, 3, 4]
sun_color = [2, 2, 1]
self_shadow = false
shadow_cells = 64
fire_light = 2.5

[depth_of_field]
focus_m = 4.5
aperture_mm = 80

[[camera]]
position = [0, 1.7, 8]
target = [0, 1, 0]
vertical_fov_deg = 45
[[camera]]
tick = 600
position = [4, 1.7, 8]
target = [0, 1, 0]

[[solid]]
kind = "plane"
material = "asphalt"
color = [0.2, 0.2, 0.2]
position = [0, 0, 0]
size_m = [40, 30]
[[solid]]
kind = "box"
material = "brick"
position = [0, 1, -4]
size_m = [4, 2, 0.5]
yaw_deg = 30
[[solid]]
kind = "sphere"
material = "wood"
position = [1, 1, 1]
radius_m = 0.4
[[solid]]
kind = "capsule"
material = "concrete"
position = [1, 1, 1]
end = [1, 2, 1]
radius_m = 0.3
[[solid]]
kind = "figure"
position = [2, 0, -1]
yaw_deg = 90
height_m = 2
color = [0.3, 0.2, 0.1]

[[pane]]
position = [0, 1, 2]
yaw_deg = 10
pitch_deg = -5
size_m = [1.5, 2]
color = [0.1, 0, 0]
coverage = 0.5
transmission = [0.9, 0.1, 0.1]
diffusion_deg = 2.5
emission = [0, 0, 3]
draw_order = -3

[[instance]]
name = "first"
effect = "smoke_grenade"
call_tick = 60
stop_tick = 20000000
position = [0, 0, 1]
path = [[0, [0, 0, 0]], [30, [0.5, 0, -2]]]
yaw_deg = 45
seed = 7
draw_order = 12
[instance.layers]
core = 1.5
smoke = -0.25
[[instance]]
effect = "sparks"
)";

TEST(SceneReader, ReadsEveryKey) {
  const Scene scene = read_scene_text(kEveryKey, "every_key.toml");
  EXPECT_EQ(scene.id, "every_key");
  EXPECT_EQ(scene.name, "Every key");
  EXPECT_EQ(scene.description, "What a scene can say.");
  EXPECT_EQ(scene.seed, UINT32_MAX);
  EXPECT_EQ(scene.duration_ticks, 900u);
  EXPECT_EQ(scene.default_tick, 300u);
  EXPECT_EQ(scene.near_m, 0.05f);
  EXPECT_EQ(scene.far_m, 200.0f);
  EXPECT_EQ(scene.exposure, 1.5f);
  EXPECT_EQ(scene.tonemap, Tonemap::kNone);
  EXPECT_EQ(scene.wind, glm::vec3(1, 0, -0.5f));
  EXPECT_FALSE(scene.light.sky);
  EXPECT_EQ(scene.light.zenith, glm::vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(scene.light.horizon, glm::vec3(0.4f, 0.5f, 0.6f));
  EXPECT_FLOAT_EQ(scene.light.sun_direction.y, 0.6f);
  EXPECT_FLOAT_EQ(scene.light.sun_direction.z, 0.8f);
  EXPECT_EQ(scene.light.sun_color, glm::vec3(2, 2, 1));
  EXPECT_FALSE(scene.light.self_shadow);
  EXPECT_EQ(scene.light.shadow_cells, 64u);
  EXPECT_EQ(scene.light.fire_light, 2.5f);
  ASSERT_TRUE(scene.depth_of_field);
  EXPECT_EQ(scene.depth_of_field->focus_m, 4.5f);
  EXPECT_EQ(scene.depth_of_field->aperture_mm, 80.0f);

  ASSERT_EQ(scene.camera.size(), 2u);
  EXPECT_EQ(scene.camera[0].tick, 0u);
  EXPECT_EQ(scene.camera[0].vertical_fov_deg, 45.0f);
  EXPECT_EQ(scene.camera[1].tick, 600u);
  EXPECT_EQ(scene.camera[1].position, glm::vec3(4, 1.7f, 8));
  EXPECT_EQ(scene.camera[1].target, glm::vec3(0, 1, 0));

  ASSERT_GT(scene.solids.size(), 4u);
  EXPECT_EQ(scene.solids[0].kind, SolidKind::kPlane);
  EXPECT_EQ(scene.solids[0].material, Material::kAsphalt);
  EXPECT_EQ(scene.solids[0].color, glm::vec3(0.2f));
  EXPECT_EQ(scene.solids[0].size_m, glm::vec3(40, 0, 30));
  EXPECT_EQ(scene.solids[1].kind, SolidKind::kBox);
  EXPECT_EQ(scene.solids[1].material, Material::kBrick);
  EXPECT_EQ(scene.solids[1].position, glm::vec3(0, 1, -4));
  EXPECT_EQ(scene.solids[1].size_m, glm::vec3(4, 2, 0.5f));
  EXPECT_EQ(scene.solids[1].yaw_deg, 30.0f);
  EXPECT_EQ(scene.solids[2].kind, SolidKind::kSphere);
  EXPECT_EQ(scene.solids[2].material, Material::kWood);
  EXPECT_EQ(scene.solids[2].radius_m, 0.4f);
  EXPECT_EQ(scene.solids[3].kind, SolidKind::kCapsule);
  EXPECT_EQ(scene.solids[3].material, Material::kConcrete);
  EXPECT_EQ(scene.solids[3].end, glm::vec3(1, 2, 1));

  ASSERT_EQ(scene.panes.size(), 1u);
  EXPECT_EQ(scene.panes[0].position, glm::vec3(0, 1, 2));
  EXPECT_EQ(scene.panes[0].yaw_deg, 10.0f);
  EXPECT_EQ(scene.panes[0].pitch_deg, -5.0f);
  EXPECT_EQ(scene.panes[0].size_m, glm::vec2(1.5f, 2));
  EXPECT_EQ(scene.panes[0].color, glm::vec3(0.1f, 0, 0));
  EXPECT_EQ(scene.panes[0].coverage, 0.5f);
  EXPECT_EQ(scene.panes[0].transmission, glm::vec3(0.9f, 0.1f, 0.1f));
  EXPECT_EQ(scene.panes[0].diffusion_deg, 2.5f);
  EXPECT_EQ(scene.panes[0].emission, glm::vec3(0, 0, 3));
  EXPECT_EQ(scene.panes[0].draw_order, -3);

  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.instances[0].name, "first");
  EXPECT_EQ(scene.instances[0].effect, "smoke_grenade");
  EXPECT_EQ(scene.instances[0].call_tick, 60u);
  EXPECT_EQ(scene.instances[0].position, glm::vec3(0, 0, 1));
  EXPECT_EQ(scene.instances[0].stop_tick, kMaxTick);
  ASSERT_TRUE(scene.instances[0].path);
  EXPECT_EQ(scene.instances[0].path->keys().size(), 2u);
  EXPECT_EQ(scene.instances[0].path->at(15), glm::vec3(0.25f, 0, -1));
  EXPECT_EQ(scene.instances[0].yaw_deg, 45.0f);
  EXPECT_EQ(scene.instances[0].seed, 7u);
  EXPECT_EQ(scene.instances[0].draw_order, 12);
  ASSERT_EQ(scene.instances[0].layers.size(), 2u);
  EXPECT_EQ(scene.instances[0].layers[0].layer, "core");
  EXPECT_EQ(scene.instances[0].layers[0].camera_offset_m, 1.5f);
  EXPECT_EQ(scene.instances[0].layers[1].layer, "smoke");
  EXPECT_EQ(scene.instances[0].layers[1].camera_offset_m, -0.25f);
  EXPECT_EQ(scene.instances[1].name, "sparks");
  EXPECT_FALSE(scene.instances[1].call_tick.has_value());
  EXPECT_FALSE(scene.instances[1].stop_tick.has_value());
  EXPECT_FALSE(scene.instances[1].path.has_value());
}

TEST(SceneReader, ReadsASingleCamera) {
  const Scene scene =
      read_scene_text("name = 'x'\n[camera]\nposition = [0, 0, 1]\ntarget = [0, 0, 0]\n", "x.toml");
  ASSERT_EQ(scene.camera.size(), 1u);
  EXPECT_EQ(scene.camera[0].position, glm::vec3(0, 0, 1));
}

TEST(SceneReader, ALayerThatTheEffectDoesNotHaveIsToldWhichItHas) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  const auto message = [&](const std::string& effect, const std::string& layer) {
    const std::string text =
        "name = 'x'\n[camera]\nposition = [0, 0, 1]\ntarget = [0, 0, 0]\n[[instance]]\neffect = '" + effect +
        "'\n[instance.layers]\n" + layer + " = 0.5\n";
    const auto found = check_references(read_scene_text(text, "x.toml"), library);
    return found.empty() ? "" : to_string(found[0]);
  };
  EXPECT_EQ(message("marker", "plate"), "");
  EXPECT_EQ(message("marker", "plat"),
            "x.toml:8:8: unknown layer `plat`, did you mean `plate`? (of effect `marker`)");
  EXPECT_EQ(message("marker", "hat_and_coat"),
            "x.toml:8:16: unknown layer `hat_and_coat`, expected one of `plate`, `bar`, `icon` (of effect "
            "`marker`)");
  EXPECT_EQ(message("dust", "plate"),
            "x.toml:8:9: unknown layer `plate`, expected no `layers`: effect `dust` has none");
}

TEST(SceneReader, TurnsAFigureIntoSolids) {
  const Scene scene = read_scene_text(kEveryKey, "x.toml");
  const auto parts = standing_figure({2, 0, -1}, 90, 2, {0.3f, 0.2f, 0.1f}, Material::kPlain);
  ASSERT_EQ(scene.solids.size(), 4 + parts.size());
  EXPECT_EQ(scene.solids.back().kind, SolidKind::kSphere);
  EXPECT_EQ(scene.solids.back().position, parts.back().position);
  EXPECT_EQ(scene.solids.back().color, glm::vec3(0.3f, 0.2f, 0.1f));
}

TEST(Figure, StandsOnItsFeetAndIsAsTallAsAsked) {
  float low = 1e9f, high = -1e9f;
  for (const Solid& part : standing_figure({3, 5, 7}, 30, 1.8f, glm::vec3(0.5f), Material::kPlain)) {
    const float end = part.kind == SolidKind::kCapsule ? part.end.y : part.position.y;
    low = std::min({low, part.position.y - part.radius_m, end - part.radius_m});
    high = std::max({high, part.position.y + part.radius_m, end + part.radius_m});
  }
  EXPECT_NEAR(low, 5.0f, 1e-3f);
  EXPECT_NEAR(high, 6.8f, 1e-3f);
}

TEST(Figure, LooksAlongItsYaw) {
  // Feet point to +z at yaw 0 and to +x at yaw 90, like every other yaw about +y.
  const auto toe = [](float yaw) {
    const Solid foot = standing_figure({0, 0, 0}, yaw, 1.0f, glm::vec3(0.5f), Material::kPlain).front();
    return foot.end - foot.position;
  };
  EXPECT_GT(toe(0).z, 0.05f);
  EXPECT_GT(toe(90).x, 0.05f);
  EXPECT_NEAR(toe(90).z, -toe(0).x, 1e-6f);
}

}  // namespace
}  // namespace plume
