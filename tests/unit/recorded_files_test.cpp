// What a recording writes: scenes and replays that read back as they were, to the bit.
#include <gtest/gtest.h>

#include "renderer/methods/method.h"
#include "renderer/methods/methods.h"
#include "sandbox/presets/library.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/write_replay.h"
#include "sandbox/presets/write_scene.h"

namespace plume {
namespace {

void expect_same(const CameraKey& a, const CameraKey& b) {
  EXPECT_EQ(a.tick, b.tick);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.target, b.target);
  EXPECT_EQ(a.vertical_fov_deg, b.vertical_fov_deg);
}

void expect_same(const Solid& a, const Solid& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.position, b.position);
  if (a.kind == SolidKind::kCapsule) {
    EXPECT_EQ(a.end, b.end);
  }
  if (a.kind == SolidKind::kBox || a.kind == SolidKind::kPlane) {
    EXPECT_EQ(a.size_m, b.size_m);
  }
  if (a.kind == SolidKind::kSphere || a.kind == SolidKind::kCapsule) {
    EXPECT_EQ(a.radius_m, b.radius_m);
  }
  if (a.kind == SolidKind::kBox) {
    EXPECT_EQ(a.yaw_deg, b.yaw_deg);
  }
}

void expect_same(const Pane& a, const Pane& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.yaw_deg, b.yaw_deg);
  EXPECT_EQ(a.pitch_deg, b.pitch_deg);
  EXPECT_EQ(a.size_m, b.size_m);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.coverage, b.coverage);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_EQ(a.diffusion_deg, b.diffusion_deg);
  EXPECT_EQ(a.emission, b.emission);
  EXPECT_EQ(a.draw_order, b.draw_order);
}

void expect_same(const Instance& a, const Instance& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.effect, b.effect);
  EXPECT_EQ(a.call_tick, b.call_tick);
  EXPECT_EQ(a.stop_tick, b.stop_tick);
  ASSERT_EQ(a.freezes.size(), b.freezes.size());
  for (size_t i = 0; i < a.freezes.size(); ++i) {
    EXPECT_EQ(a.freezes[i].from, b.freezes[i].from);
    EXPECT_EQ(a.freezes[i].until, b.freezes[i].until);
  }
  EXPECT_EQ(a.position, b.position);
  ASSERT_EQ(a.path.has_value(), b.path.has_value());
  if (a.path) {
    ASSERT_EQ(a.path->keys().size(), b.path->keys().size());
    for (size_t i = 0; i < a.path->keys().size(); ++i) {
      EXPECT_EQ(a.path->keys()[i].tick, b.path->keys()[i].tick);
      EXPECT_EQ(a.path->keys()[i].position, b.path->keys()[i].position);
    }
  }
  EXPECT_EQ(a.yaw_deg, b.yaw_deg);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.draw_order, b.draw_order);
  ASSERT_EQ(a.layers.size(), b.layers.size());
  for (size_t i = 0; i < a.layers.size(); ++i) {
    EXPECT_EQ(a.layers[i].layer, b.layers[i].layer);
    EXPECT_EQ(a.layers[i].camera_offset_m, b.layers[i].camera_offset_m);
  }
}

template <class List>
void expect_same_lists(const List& a, const List& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

void expect_same(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.duration_ticks, b.duration_ticks);
  EXPECT_EQ(a.default_tick, b.default_tick);
  EXPECT_EQ(a.near_m, b.near_m);
  EXPECT_EQ(a.far_m, b.far_m);
  EXPECT_EQ(a.exposure, b.exposure);
  EXPECT_EQ(a.tonemap, b.tonemap);
  EXPECT_EQ(a.wind, b.wind);
  EXPECT_EQ(a.light.sky, b.light.sky);
  EXPECT_EQ(a.light.zenith, b.light.zenith);
  EXPECT_EQ(a.light.horizon, b.light.horizon);
  EXPECT_EQ(a.light.sun_direction, b.light.sun_direction);
  EXPECT_EQ(a.light.sun_color, b.light.sun_color);
  EXPECT_EQ(a.light.self_shadow, b.light.self_shadow);
  EXPECT_EQ(a.light.shadow_cells, b.light.shadow_cells);
  EXPECT_EQ(a.light.fire_light, b.light.fire_light);
  ASSERT_EQ(a.depth_of_field.has_value(), b.depth_of_field.has_value());
  if (a.depth_of_field) {
    EXPECT_EQ(a.depth_of_field->focus_m, b.depth_of_field->focus_m);
    EXPECT_EQ(a.depth_of_field->aperture_mm, b.depth_of_field->aperture_mm);
  }
  expect_same_lists(a.camera, b.camera);
  expect_same_lists(a.solids, b.solids);
  expect_same_lists(a.panes, b.panes);
  expect_same_lists(a.instances, b.instances);
}

TEST(WrittenScene, ReadsBackAsEveryShippedSceneToTheBit) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const std::string& id : library.ids(PresetKind::kScene)) {
    SCOPED_TRACE(id);
    const Scene scene = library.scene(id);
    expect_same(read_scene_text(scene_text(scene), id + ".toml"), scene);
  }
}

TEST(WrittenScene, ReadsBackWhatWasNotSaid) {
  const Scene scene =
      read_scene_text("name = 'bare'\n[camera]\nposition = [0, 1, 5]\ntarget = [0, 1, 0]\n", "x.toml");
  expect_same(read_scene_text(scene_text(scene), "x.toml"), scene);
}

TEST(WrittenScene, KeepsWhatNoShippedSceneHas) {
  Scene scene;
  scene.name = "a \"name\"\nof two lines";
  scene.seed = UINT32_MAX;
  scene.tonemap = Tonemap::kNone;
  scene.light.sun_direction = glm::normalize(glm::vec3(0.1f, 0.77f, -0.3f));
  scene.camera = {{.tick = 7, .position = {0.1f, 1e-7f, -3}, .target = {1, 2, 3}}};
  Instance called, uncalled;
  called.name = "one";
  called.effect = "effects/3/smoke.toml";
  called.call_tick = 5;
  called.stop_tick = 9;
  called.freezes = {{6, 7}, {8, 20}};
  called.path.emplace(std::vector<Path::Key>{{0, {0, 0, 0}}, {9, {0.3f, 1, 2}}});
  called.seed = 4;
  LayerOffset layer;
  layer.layer = "far out";
  layer.camera_offset_m = -1.5f;
  called.layers.push_back(layer);
  uncalled.name = "not called";
  uncalled.effect = "smoke";
  scene.instances = {called, uncalled};
  expect_same(read_scene_text(scene_text(scene), "x.toml"), scene);
}

Replay recording() {
  Replay replay;
  replay.name = "Seen";
  replay.scene = "street";
  replay.frames = 1;
  replay.warmup = 0;
  replay.methods = {{.id = "avboit", .settings = parameter_texts(*make_method("avboit"))},
                    {.id = "wboit", .settings = {{"weight", "eq9"}, {"depth_scale", "0.1"}}}};
  replay.shots.resize(3);
  replay.shots[0].tick = replay.shots[1].tick = 12;
  replay.shots[0].method = 1;
  replay.shots[1].scene = "scenes/2/glass.toml";
  replay.shots[1].size = {320, 180};
  replay.shots[2].camera = CameraKey{.position = {0.1f, 2, 3}, .target = {1, 1e-3f, 0}};
  replay.shots[1].view = {.id = "flip"};
  replay.shots[2].view = {.id = "overdraw", .slice = 0, .logarithmic = true, .range = glm::vec2(0.1f, 1e-7f)};
  replay.capture.error_maps = false;
  replay.capture.hdr = true;
  return replay;
}

TEST(WrittenReplay, ReadsBackShotByShot) {
  const Replay replay = recording(), read = read_replay_text(replay_text(replay), "x.toml");
  EXPECT_EQ(read.name, replay.name);
  EXPECT_EQ(read.scene, replay.scene);
  EXPECT_EQ(read.size, replay.size);
  EXPECT_EQ(read.frames, 1u);
  EXPECT_EQ(read.warmup, 0u);
  EXPECT_TRUE(read.ticks.empty());
  EXPECT_TRUE(read.camera.empty());
  EXPECT_TRUE(read.capture.images);
  EXPECT_FALSE(read.capture.error_maps);
  EXPECT_TRUE(read.capture.hdr);
  ASSERT_EQ(read.methods.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.methods[i].id, replay.methods[i].id);
    const auto made = make_method(read.methods[i].id), wanted = make_method(read.methods[i].id);
    for (const auto& [name, value] : read.methods[i].settings) set_parameter(*made, name, value);
    for (const auto& [name, value] : replay.methods[i].settings) set_parameter(*wanted, name, value);
    EXPECT_EQ(parameter_texts(*made), parameter_texts(*wanted));
  }
  ASSERT_EQ(read.shots.size(), replay.shots.size());
  for (size_t i = 0; i < read.shots.size(); ++i) {
    EXPECT_EQ(read.shots[i].tick, replay.shots[i].tick);
    EXPECT_EQ(read.shots[i].method, replay.shots[i].method);
    EXPECT_EQ(read.shots[i].scene, replay.shots[i].scene);
    EXPECT_EQ(read.shots[i].size, replay.shots[i].size);
    EXPECT_EQ(read.shots[i].view, replay.shots[i].view);
    ASSERT_EQ(read.shots[i].camera.has_value(), replay.shots[i].camera.has_value());
    if (read.shots[i].camera) expect_same(*read.shots[i].camera, *replay.shots[i].camera);
  }
}

TEST(WrittenReplay, ReadsBackTicksAndTheirCamera) {
  Replay replay = recording();
  replay.shots.clear();
  replay.ticks = {1, 5};
  replay.seed = 9;
  replay.camera = {{.tick = 1}, {.tick = 4, .vertical_fov_deg = 33.3f}};
  replay.capture.ticks = {5};
  const Replay read = read_replay_text(replay_text(replay), "x.toml");
  EXPECT_EQ(read.ticks, replay.ticks);
  EXPECT_EQ(read.seed, replay.seed);
  EXPECT_EQ(read.capture.ticks, replay.capture.ticks);
  expect_same_lists(read.camera, replay.camera);
}

TEST(WrittenReplay, KeepsPixelsAndNumbersThatAFileWritesOtherwise) {
  const Replay replay = read_replay_text(R"(
name = "x"
scene = "s"
ticks = [0]
[[method]]
id = "wboit"
depth_scale = "01."
[capture]
pixels = [[3, 5], [639, 0]]
)",
                                         "x.toml");
  const Replay read = read_replay_text(replay_text(replay), "x.toml");
  EXPECT_EQ(read.capture, replay.capture);
  EXPECT_EQ(read.methods.at(0).settings.at("depth_scale"), "1");
}

TEST(ParameterTexts, GiveEveryMethodTheSameValuesToTheBit) {
  for (const std::string& id : method_ids()) {
    const auto method = make_method(id), other = make_method(id);
    for (const auto& parameter : parameter_list(*method))
      if (parameter["type"] == "number")  // a share of the range that no short decimal has
        set_parameter(*method, parameter["name"].get<std::string>(),
                      std::to_string(parameter["min"].get<double>() +
                                     (parameter["max"].get<double>() - parameter["min"].get<double>()) / 7));
    for (const auto& [name, value] : parameter_texts(*method)) set_parameter(*other, name, value);
    EXPECT_EQ(parameter_values(*method), parameter_values(*other)) << id;
  }
}

}  // namespace
}  // namespace plume
