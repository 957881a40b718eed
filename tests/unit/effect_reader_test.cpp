#include <gtest/gtest.h>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_effect.h"

namespace plume {
namespace {

/// Every key an effect can have.
constexpr std::string_view kEveryKey = R"(
name = "Every key"
description = "What an effect can say."

[[emitter]]
name = "body"

[emitter.spawn]
rate = [[0, 0], [30, 90.5], [60, 0]]
bursts = [[0, 40], [10, 5]]
per_metre = 2.5
life = [60, 90]

[emitter.shape]
kind = "cone"
radius_m = 0.25
thickness = 0.5
angle_deg = 20
offset_m = [0, 0.1, 0]

[emitter.motion]
speed = [1, 2.5]
velocity = [0, 1, 0]
gravity = -0.1
drag = 0.8
wind = 0.5
buoyancy = 1.2
cooling_s = 2.5
floor_y = 0.05
curl = { strength = 1.5, scale_m = 2, speed = 0.2, octaves = 3 }
vortex = { strength = -2, radius_m = 0.75, pull = 0.3 }
orbit = -0.5
attractor = [{ position = [1, 2, 3], strength = 4, radius_m = 0.5 }, { from = [1, 0, 0], to = [0, 0, 1], strength = -1 }]
field = { file = "swirl", as = "velocity", strength = 3, scale = 2, offset_m = [0, 1, 0] }
kill = [{ kind = "box", position = [0, 9, 0], size_m = [20, 1, 20] }, { kind = "sphere", radius_m = 30, where = "outside" }, { kind = "plane", normal = [0, 0, 1] }]
collision = { response = "bounce", bounce = 0.4, friction = 0.3, radius_m = 0.02, event_speed = 1.5 }
curl_displacement = { amplitude_m = 0.1, scale_m = 0.5, speed = 0.3, octaves = 2, grow_s = 0.7 }

[emitter.look]
texture = "soft"
radius_m = [[0, 0.2], [1, 1.4]]
radius_scale = [0.8, 1.2]
cross_section_m2 = 0.35
fade = [[0, 0, 0], [0.1, 1, 2, -3], [1, 0]]
lit = true
color = [0.5, 0.6, 0.7]
emission = [[0, [9, 4, 1]], [0.3, [0, 0, 0]]]
feather_m = 0.3
near_fade_m = 2.5
camera_offset_m = 1.5
flipbook_fps = 12
diffusion_deg = 1.5
spin_deg_s = [-30, 30]
stretch_s = 0.02
draw_order = -2

[[emitter]]
name = "glow"
spawn = { rate = 60, duration = 30, life = 20 }
shape = { kind = "box", size_m = [1, 0, 2] }
look = { texture = "disc", opacity = [[0, 1], [1, 0]], lit = false, color = [8, 4, 1] }
)";

TEST(EffectReader, ReadsEveryKey) {
  const Effect effect = read_effect_text(kEveryKey, PLUME_SOURCE_PRESETS "/effects/every_key.toml");
  EXPECT_EQ(effect.id, "every_key");
  EXPECT_EQ(effect.name, "Every key");
  EXPECT_EQ(effect.description, "What an effect can say.");
  ASSERT_EQ(effect.emitters.size(), 2u);

  const Emitter& body = effect.emitters[0];
  EXPECT_EQ(body.name, "body");
  ASSERT_EQ(body.spawn.rate.size(), 3u);
  EXPECT_EQ(body.spawn.rate[1].tick, 30u);
  EXPECT_EQ(body.spawn.rate[1].per_second, 90.5);
  ASSERT_EQ(body.spawn.bursts.size(), 2u);
  EXPECT_EQ(body.spawn.bursts[1].tick, 10u);
  EXPECT_EQ(body.spawn.bursts[1].count, 5u);
  EXPECT_EQ(body.spawn.per_metre, 2.5);
  EXPECT_EQ(body.spawn.life_ticks.min, 60u);
  EXPECT_EQ(body.spawn.life_ticks.max, 90u);
  EXPECT_EQ(body.shape.kind, ShapeKind::kCone);
  EXPECT_EQ(body.shape.radius_m, 0.25f);
  EXPECT_EQ(body.shape.thickness, 0.5f);
  EXPECT_EQ(body.shape.angle_deg, 20.0f);
  EXPECT_EQ(body.shape.offset_m, glm::vec3(0, 0.1f, 0));
  EXPECT_EQ(body.motion.speed.max, 2.5f);
  EXPECT_EQ(body.motion.velocity, glm::vec3(0, 1, 0));
  EXPECT_EQ(body.motion.gravity, -0.1f);
  EXPECT_EQ(body.motion.drag, 0.8f);
  EXPECT_EQ(body.motion.wind, 0.5f);
  EXPECT_EQ(body.motion.buoyancy, 1.2f);
  EXPECT_EQ(body.motion.cooling_s, 2.5f);
  EXPECT_EQ(body.motion.floor_y, 0.05f);
  EXPECT_EQ(body.motion.curl.strength, 1.5f);
  EXPECT_EQ(body.motion.curl.scale_m, 2.0f);
  EXPECT_EQ(body.motion.curl.speed, 0.2f);
  EXPECT_EQ(body.motion.curl.octaves, 3u);
  EXPECT_EQ(body.motion.vortex.strength, -2.0f);
  EXPECT_EQ(body.motion.vortex.radius_m, 0.75f);
  EXPECT_EQ(body.motion.vortex.pull, 0.3f);
  EXPECT_EQ(body.motion.orbit, -0.5f);
  ASSERT_EQ(body.motion.attractors.size(), 2u);
  EXPECT_EQ(body.motion.attractors[0].from_m, glm::vec3(1, 2, 3));
  EXPECT_EQ(body.motion.attractors[0].to_m, glm::vec3(1, 2, 3));
  EXPECT_EQ(body.motion.attractors[0].radius_m, 0.5f);
  EXPECT_EQ(body.motion.attractors[1].to_m, glm::vec3(0, 0, 1));
  EXPECT_EQ(body.motion.attractors[1].strength, -1.0f);
  EXPECT_EQ(body.motion.field->use, VectorField::Use::kVelocity);
  EXPECT_EQ(body.motion.field->strength, 3.0f);
  EXPECT_EQ(body.motion.field->scale, 2.0f);
  EXPECT_EQ(body.motion.field->offset_m, glm::vec3(0, 1, 0));
  EXPECT_EQ(body.motion.field->grid->size, glm::uvec3(10));
  ASSERT_EQ(body.motion.kill.size(), 3u);
  EXPECT_EQ(body.motion.kill[0].size_m, glm::vec3(20, 1, 20));
  EXPECT_FALSE(body.motion.kill[0].outside);
  EXPECT_EQ(body.motion.kill[1].radius_m, 30.0f);
  EXPECT_TRUE(body.motion.kill[1].outside);
  EXPECT_EQ(body.motion.kill[2].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(body.motion.collision->response, CollisionResponse::kBounce);
  EXPECT_EQ(body.motion.collision->bounce, 0.4f);
  EXPECT_EQ(body.motion.collision->friction, 0.3f);
  EXPECT_EQ(body.motion.collision->radius_m, 0.02f);
  EXPECT_EQ(body.motion.collision->event_speed, 1.5f);
  EXPECT_EQ(body.motion.curl_displacement.amplitude_m, 0.1f);
  EXPECT_EQ(body.motion.curl_displacement.scale_m, 0.5f);
  EXPECT_EQ(body.motion.curl_displacement.speed, 0.3f);
  EXPECT_EQ(body.motion.curl_displacement.octaves, 2u);
  EXPECT_EQ(body.motion.curl_displacement.grow_s, 0.7f);
  EXPECT_EQ(body.look.texture, TextureKind::kSoft);
  EXPECT_FLOAT_EQ(body.look.radius_m.at(0.5f), 0.8f);
  EXPECT_EQ(body.look.radius_scale.min, 0.8f);
  EXPECT_EQ(body.look.cross_section_m2, 0.35f);
  EXPECT_FALSE(body.look.opacity.has_value());
  ASSERT_EQ(body.look.fade.keys.size(), 3u);
  EXPECT_EQ(body.look.fade.keys[0].out, 0.0f);
  EXPECT_EQ(body.look.fade.keys[1].in, 2.0f);
  EXPECT_EQ(body.look.fade.keys[1].out, -3.0f);
  EXPECT_FALSE(body.look.fade.keys[2].in.has_value());
  EXPECT_FALSE(body.look.radius_m.keys[1].in.has_value());
  EXPECT_TRUE(body.look.lit);
  EXPECT_EQ(body.look.color.at(1), glm::vec3(0.5f, 0.6f, 0.7f));
  EXPECT_EQ(body.look.emission.at(0), glm::vec3(9, 4, 1));
  EXPECT_EQ(body.look.feather_m, 0.3f);
  EXPECT_EQ(body.look.near_fade_m, 2.5f);
  EXPECT_EQ(body.look.camera_offset_m, 1.5f);
  EXPECT_EQ(body.look.flipbook_fps, 12.0f);
  EXPECT_EQ(body.look.diffusion_deg, 1.5f);
  EXPECT_EQ(body.look.spin_deg_s.min, -30.0f);
  EXPECT_EQ(body.look.stretch_s, 0.02f);
  EXPECT_EQ(body.look.draw_order, -2);

  const Emitter& glow = effect.emitters[1];
  ASSERT_EQ(glow.spawn.rate.size(), 2u);
  EXPECT_EQ(glow.spawn.rate[0].tick, 0u);
  EXPECT_EQ(glow.spawn.rate[1].tick, 30u);
  EXPECT_EQ(glow.spawn.rate[1].per_second, 60.0);
  EXPECT_EQ(glow.spawn.life_ticks.min, 20u);
  EXPECT_EQ(glow.shape.size_m, glm::vec3(1, 0, 2));
  EXPECT_EQ(glow.look.texture, TextureKind::kDisc);
  EXPECT_EQ(glow.look.opacity->at(0.5f), 0.5f);
  EXPECT_FALSE(glow.look.cross_section_m2.has_value());
  EXPECT_FALSE(glow.look.lit);
  EXPECT_EQ(glow.look.draw_order, 0);
  EXPECT_EQ(glow.look.color.at(0), glm::vec3(8, 4, 1));
}

TEST(EffectReader, ReadsEveryShapeAndTexture) {
  const std::string head = "name = 'x'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 1]], life = 1}\n";
  const std::pair<const char*, ShapeKind> shapes[] = {
      {"kind = 'point'", ShapeKind::kPoint},
      {"kind = 'sphere', radius_m = 1", ShapeKind::kSphere},
      {"kind = 'hemisphere', radius_m = 1", ShapeKind::kHemisphere},
      {"kind = 'box', size_m = [1, 1, 1]", ShapeKind::kBox},
      {"kind = 'cone', angle_deg = 1", ShapeKind::kCone},
      {"kind = 'ring', radius_m = 1", ShapeKind::kRing}};
  for (const auto& [shape, kind] : shapes) {
    const std::string text = head + "shape = {" + shape + "}\nlook = {opacity = 1}\n";
    EXPECT_EQ(read_effect_text(text, "x.toml").emitters[0].shape.kind, kind);
  }
  const std::pair<const char*, TextureKind> textures[] = {
      {"puff", TextureKind::kPuff}, {"disc", TextureKind::kDisc}, {"soft", TextureKind::kSoft}};
  for (const auto& [name, kind] : textures) {
    const std::string text = head + "look = {opacity = 1, texture = '" + name + "'}\n";
    EXPECT_EQ(read_effect_text(text, "x.toml").emitters[0].look.texture, kind);
  }
}

TEST(EffectReader, AcceptsExactlyAsManyAliveAsFit) {
  const auto read = [](uint32_t count) {
    read_effect_text(
        "name = 'x'\n[[emitter]]\nname = 'e'\nlook.opacity = 1\nspawn = {life = 9, bursts = [[0, 3999999], "
        "[8, " +
            std::to_string(count) + "]]}\n",
        "x.toml");
  };
  EXPECT_NO_THROW(read(1));
  EXPECT_THROW(read(2), FileErrors);
}

TEST(EffectReader, NamesTheFileInEveryDiagnostic) {
  try {
    read_effect_text("nam = 1", "some/file.toml");
    FAIL() << "expected FileErrors";
  } catch (const FileErrors& errors) {
    ASSERT_EQ(errors.diagnostics().size(), 3u);
    for (const Diagnostic& diagnostic : errors.diagnostics()) EXPECT_EQ(diagnostic.file, "some/file.toml");
    EXPECT_EQ(std::string(errors.what()),
              "some/file.toml:1:1: missing key `name`, expected a non-empty text in quotes\n"
              "some/file.toml:1:1: missing key `emitter`, expected 1 to 64 tables [[emitter]]\n"
              "some/file.toml:1:1: unknown key `nam`, did you mean `name`?");
  }
}

/// Of one emitter with this shape and this look, what is wrong.
std::vector<std::string> mistakes_with(const std::string& shape, const std::string& look) {
  std::vector<std::string> messages;
  try {
    read_effect_text("name = 'E'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 1]], life = 1}\nshape = {" +
                         shape + "}\nlook = {" + look + "}\n",
                     "e.toml");
  } catch (const FileErrors& errors) {
    for (const Diagnostic& d : errors.diagnostics()) messages.push_back(to_string(d));
  }
  return messages;
}

TEST(EffectReader, ReadsLinesMeshesRibbonsAndFlipbooksOverLife) {
  const Effect effect = read_effect_text(R"(
name = "E"
[[emitter]]
name = "glass"
spawn = { bursts = [[0, 1]], life = 1 }
shape = { kind = "mesh", mesh = "pane", scale = 2 }
look = { mesh = ["a", "b"], opacity = 0.5, tumble_deg_s = [10, 20], gloss = 0.75 }
[[emitter]]
name = "debris"
spawn = { bursts = [[0, 1]], life = 1 }
shape = { kind = "line", to_m = [1, 2, 3] }
look = { mesh = "chunk", opaque = true }
[[emitter]]
name = "trail"
spawn = { bursts = [[0, 1]], life = 1 }
look = { ribbon = true, texture = "solid", opacity = 0.5, ribbon_births = 12 }
[[emitter]]
name = "puff"
spawn = { bursts = [[0, 1]], life = 1 }
look = { opacity = 0.5, flipbook_loops = 1 }
)",
                                         "e.toml");
  const Emitter &glass = effect.emitters[0], &debris = effect.emitters[1], &trail = effect.emitters[2],
                &puff = effect.emitters[3];
  EXPECT_EQ(ShapeKind::kMesh, glass.shape.kind);
  EXPECT_EQ("pane", glass.shape.mesh.id);
  EXPECT_EQ(6u, glass.shape.mesh.line);
  EXPECT_EQ(2.0f, glass.shape.scale);
  ASSERT_EQ(2u, glass.look.meshes.size());
  EXPECT_EQ("b", glass.look.meshes[1].id);
  EXPECT_EQ(20.0f, glass.look.tumble_deg_s.max);
  EXPECT_EQ(0.75f, glass.look.gloss);
  EXPECT_EQ(glm::vec3(1, 2, 3), debris.shape.to_m);
  EXPECT_TRUE(debris.look.opaque);
  EXPECT_TRUE(trail.look.ribbon);
  EXPECT_EQ(TextureKind::kSolid, trail.look.texture);
  EXPECT_EQ(12u, trail.look.ribbon_births);
  EXPECT_EQ(1.0f, puff.look.flipbook_loops);
  EXPECT_EQ(0.0f, puff.look.flipbook_fps);
  EXPECT_EQ(4u, mesh_names(effect).size());
}

TEST(EffectReader, RejectsWhatAMeshALineOrARibbonCannotBe) {
  const std::string look = "opacity = 1";
  EXPECT_EQ(mistakes_with("kind = 'line', to_m = [0, 0, 0]", look),
            std::vector<std::string>{
                "e.toml:5:32: a line without length, expected an end at least 0.001 m from its "
                "beginning"});
  EXPECT_EQ(1u, mistakes_with("kind = 'line'", look).size()) << "to_m is missing";
  EXPECT_EQ(1u, mistakes_with("kind = 'mesh'", look).size()) << "mesh is missing";
  EXPECT_EQ(1u, mistakes_with("kind = 'mesh', mesh = ['a', 'b']", look).size()) << "one mesh";
  const std::string point = "kind = 'point'";
  EXPECT_EQ(1u, mistakes_with(point, "mesh = [], opacity = 1").size());
  EXPECT_EQ(1u, mistakes_with(point, "mesh = 'a', opaque = true, opacity = 1").size()) << "solid pieces";
  EXPECT_EQ(1u, mistakes_with(point, "mesh = 'a', opacity = 1, spin_deg_s = 3").size()) << "not a sprite";
  EXPECT_EQ(1u, mistakes_with(point, "ribbon = true, opacity = 1, texture = 'puff'").size());
  EXPECT_EQ(1u, mistakes_with(point, "opacity = 1, flipbook_loops = 1, flipbook_fps = 8").size());
  EXPECT_EQ(1u, mistakes_with(point, "opacity = 1, tumble_deg_s = 8").size()) << "not a mesh";
}

std::vector<std::string> mistakes_of_motion(const std::string& motion, const std::string& look = "",
                                            const std::string& parent = "") {
  try {
    const std::string spawn =
        parent.empty() ? "spawn = {bursts = [[0, 1]], life = 9}\n" : "spawn = {life = 9}\n";
    read_effect_text(
        "name = 'E'\n[[emitter]]\nname = 'first'\nspawn = {bursts = [[0, 1]], life = 9}\nlook = "
        "{opacity = 1}\n[[emitter]]\nname = 'e'\n" +
            parent + spawn + "motion = {" + motion + "}\nlook = {" + (look.empty() ? "opacity = 1" : look) +
            "}\n[bounds]\nsize_m = [1, 1, 1]\n",
        "e.toml");
  } catch (const FileErrors& errors) {
    std::vector<std::string> messages;
    for (const Diagnostic& d : errors.diagnostics()) messages.push_back(to_string(d));
    return messages;
  }
  return {};
}

TEST(EffectReader, AnalyticMotionIsThatOfGravityDragAndWindAlone) {
  EXPECT_EQ(mistakes_of_motion(
                "analytic = true, gravity = 1, drag = 2, wind = 0.5, velocity = [1, 2, 3], speed = 4, "
                "curl_displacement = {amplitude_m = 1}"),
            std::vector<std::string>{});
  for (const std::string other :
       {"buoyancy = 1", "floor_y = 0", "curl = {strength = 1}", "vortex = {strength = 1}", "orbit = 1",
        "attractor = {position = [0, 0, 0], strength = 1}", "kill = {kind = 'sphere', radius_m = 1}",
        "collision = {response = 'die'}"}) {
    EXPECT_EQ(mistakes_of_motion("analytic = false, " + other), std::vector<std::string>{});
    const auto found = mistakes_of_motion("analytic = true, " + other);
    ASSERT_EQ(1u, found.size()) << other;
    EXPECT_NE(std::string::npos, found[0].find("beside `analytic`")) << found[0];
  }
  EXPECT_EQ(1u,
            mistakes_of_motion("analytic = true", "", "parent = {emitter = 'first', on = 'death'}\n").size());
  EXPECT_EQ(1u, mistakes_of_motion("analytic = true", "mesh = 'a', opaque = true").size());
}

TEST(EffectReader, BoundsAreForWhatKeepsAState) {
  const auto kill_volumes = [](const std::string& motion) {
    return read_effect_text(
               "name = 'E'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 1]], life = 9}\nlook = "
               "{opacity = 1}\nmotion = {" +
                   motion + "}\n[bounds]\nsize_m = [1, 1, 1]\n",
               "e.toml")
        .emitters[0]
        .motion.kill.size();
  };
  EXPECT_EQ(1u, kill_volumes("gravity = 1"));
  EXPECT_EQ(0u, kill_volumes("gravity = 1, analytic = true"));
}

}  // namespace
}  // namespace plume
