// A particle whose numbers nothing can be drawn with costs its own pixels: everything else is as if it were
// dead, whatever it is made of and whoever draws it; and it is told whose it is.
#include "sandbox/scene/bad_particles.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "sandbox/presets/read_effect.h"
#include "sandbox/workspace/living_particles.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

using shared::Particle;

constexpr std::string_view kKinds = R"(name = "Kinds"
[[emitter]]
name = "smoke"   # lit, and in its own shadow
  spawn = {bursts = [[0, 24]], life = 600}
  shape = {kind = "sphere", radius_m = 1.0}
  [emitter.look]
  radius_m = 0.5
  cross_section_m2 = 0.4
[[emitter]]
name = "fire"   # a light to the others
  spawn = {bursts = [[0, 12]], life = 600}
  shape = {kind = "sphere", radius_m = 0.5, offset_m = [0.5, 0.0, 0.5]}
  [emitter.look]
  radius_m = 0.3
  opacity = 0.3
  lit = false
  emission = [6.0, 3.0, 1.0]
[[emitter]]
name = "streaks"   # stretched along their velocity, and of the same fire
  spawn = {bursts = [[0, 12]], life = 600}
  shape = {kind = "sphere", radius_m = 1.5}
  motion = {speed = 0.2}
  [emitter.look]
  radius_m = 0.1
  opacity = 0.6
  stretch_s = 1.0
  emission = [0.5, 1.0, 2.0]
  transmission = [0.2, 0.6, 0.9]
[[emitter]]
name = "ribbon"
  spawn = {rate = 60, duration = 20, life = 600}
  motion = {velocity = [4.0, 0.5, 0.0]}
  shape = {kind = "point", offset_m = [-1.0, 0.0, 1.0]}
  [emitter.look]
  ribbon = true
  radius_m = 0.2
  opacity = 0.6
[[emitter]]
name = "glass"
  spawn = {bursts = [[0, 12]], life = 600}
  shape = {kind = "sphere", radius_m = 1.5}
  [emitter.look]
  mesh = ["chunk_a", "shard_a"]
  radius_m = 0.3
  opacity = 0.5
  gloss = 0.5
[[emitter]]
name = "debris"
  spawn = {bursts = [[0, 12]], life = 600}
  shape = {kind = "sphere", radius_m = 1.5}
  [emitter.look]
  mesh = "chunk_a"
  opaque = true
  radius_m = 0.3
[[emitter]]
name = "haze"
  spawn = {bursts = [[0, 12]], life = 600}
  shape = {kind = "sphere", radius_m = 1.0}
  [emitter.look]
  radius_m = 0.6
  opacity = 0.0
  distortion_deg = 3.0
)";

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();

struct Fault {
  const char* name;
  void (*plant)(Particle&);
};
constexpr Fault kFaults[] = {
    {"NaN position", [](Particle& p) { p.position.x = kNaN; }},
    {"+Inf position", [](Particle& p) { p.position.y = kInf; }},
    {"-Inf position", [](Particle& p) { p.position.z = -kInf; }},
    {"Inf behind the camera", [](Particle& p) { p.position.z = kInf; }},
    {"1e38 position", [](Particle& p) { p.position = glm::vec3(1e38f, 1e38f, -1e38f); }},
    {"NaN velocity", [](Particle& p) { p.velocity.y = kNaN; }},
    {"1e38 velocity", [](Particle& p) { p.velocity.x = -1e38f; }},
};

class BadParticlesTest : public GpuTest {
 protected:
  static constexpr uint32_t kTick = 30;
  static constexpr glm::uvec2 kSize{66, 38};

  BadParticlesTest() { stage_.go_to(kTick, kSize); }

  Effect effect() const {
    Effect effect = read_effect_text(kKinds, "kinds.toml");
    effect.id = "kinds";
    for (const MeshName& name : mesh_names(effect)) effect.meshes.push_back(library.mesh(name.id));
    return effect;
  }
  static SceneEdits with(Effect effect) {
    return {.effects = {{"kinds", std::move(effect)}}, .muted = {}, .frozen = {}};
  }
  static Scene scene() {
    Scene scene;
    scene.id = "room";
    scene.camera = {{.tick = 0, .position = {0, 1, 6}, .target = {0, 1, 0}, .vertical_fov_deg = 50}};
    scene.solids = {{.kind = SolidKind::kPlane, .size_m = {40, 0, 40}}};
    scene.depth_of_field = DepthOfField{.focus_m = 5, .aperture_mm = 60};
    scene.instances = {{.name = "it", .effect = "kinds", .call_tick = 0, .position = {0, 1, 0}}};
    return scene;
  }
  size_t kinds() const { return stage_.effects().at("kinds").emitters.size(); }
  const EmitterState& emitter(size_t kind) const {
    return stage_.simulation().instances().emitter_of(0, uint32_t(kind));
  }
  /// Of the births alive, one in the middle.
  uint32_t chosen(size_t kind) const {
    return uint32_t(emitter(kind).schedule.first_alive(kTick)) + emitter(kind).living() / 2;
  }
  void plant(size_t kind, void (*change)(Particle&)) { plant(kind, chosen(kind), change); }
  void plant(size_t kind, uint32_t birth, void (*change)(Particle&)) {
    const gpu::Buffer& pool = stage_.simulation().pool();
    const uint32_t slot = emitter(kind).base + birth % emitter(kind).slots();
    Particle particle = gpu::read<Particle>(device, pool)[slot];
    ASSERT_NE(particle.state & shared::kDeadAge, shared::kDeadAge) << "it is dead anyway";
    change(particle);
    write(slot, particle);
  }
  /// What is alive is moved there by stepping, so that all are as they were.
  void restore() {
    stage_.start_over();
    stage_.go_to(kTick, kSize);
  }
  static void kill(Particle& particle) { particle.state |= shared::kDeadAge; }

  static bool is_finite(const Image& image) {
    return std::ranges::all_of(image.pixels, [](glm::vec3 p) { return std::isfinite(p.x + p.y + p.z); });
  }
  static bool same(const Image& a, const Image& b) {
    return a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(glm::vec3)) == 0;
  }
  Image picture(MethodInstance& method) { return draw(stage_, targets_, method).linear; }

  Stage stage_{device, pipelines, library, scene(), with(effect())};
  Targets targets_{device, kSize, stage_.post()};

 private:
  void write(uint32_t slot, const Particle& particle) {
    gpu::Frame frame(device, pipelines);
    frame.pass("plant", [&](gpu::Pass& pass) {
      pass.update(stage_.simulation().pool(), std::span(&particle, 1), slot);
    });
    frame.finish();
  }
};

class BadParticlesOf : public BadParticlesTest, public testing::WithParamInterface<std::string> {};

INSTANTIATE_TEST_SUITE_P(All, BadParticlesOf, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

TEST_P(BadParticlesOf, LeaveThePictureOfTheOthersAsItIs) {
  MethodInstance method = instance(GetParam());
  if (!method.method->missing(device).empty()) GTEST_SKIP() << "the device lacks what it needs";
  const Image all = picture(method);
  EXPECT_EQ(0u, bad_particles(stage_).count);
  for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, kill);
  const Image without = picture(method);
  EXPECT_FALSE(same(all, without)) << "those that die are not seen";
  EXPECT_EQ(0u, bad_particles(stage_).count);
  for (const size_t first : {0u, 3u}) {  // faults to begin with
    restore();
    for (size_t kind = 0; kind < kinds(); ++kind)
      plant(kind, kFaults[(first + kind) % std::size(kFaults)].plant);
    const Image bad = picture(method);
    EXPECT_TRUE(is_finite(bad));
    EXPECT_TRUE(same(without, bad)) << "from " << kFaults[first].name << " on";
    EXPECT_EQ(kinds(), bad_particles(stage_).count);
  }
}

TEST_F(BadParticlesTest, AreCountedAndTheirOwnerIsTold) {
  MethodInstance method = instance("wboit");
  for (size_t kind = 0; kind < kinds(); ++kind)
    for (const Fault& fault : kFaults) {
      const std::string& name = stage_.effects().at("kinds").emitters[kind].name;
      SCOPED_TRACE(name + ": " + fault.name);
      restore();
      plant(kind, fault.plant);
      picture(method);
      const BadParticles bad = bad_particles(stage_);
      EXPECT_EQ(1u, bad.count);
      ASSERT_TRUE(bad.first);
      EXPECT_EQ("kinds", bad.first->effect);
      EXPECT_EQ("it", bad.first->instance);
      EXPECT_EQ(name, bad.first->emitter);
      EXPECT_EQ(chosen(kind), bad.first->birth);
    }
}

TEST_F(BadParticlesTest, ShadeNothingAndLightNothing) {
  MethodInstance method = instance("wboit");
  const auto light = [&] {
    picture(method);
    const Lighting& lighting = stage_.lighting();
    std::vector<std::vector<std::byte>> bytes{
        gpu::read_bytes(device, lighting.grids()), gpu::read_bytes(device, lighting.volume(0)),
        gpu::read_bytes(device, lighting.volume(1)), gpu::read_bytes(device, lighting.fire_lights())};
    bytes.back().resize(4 + lighting.fires() * sizeof(shared::FireLight));
    return bytes;
  };
  ASSERT_TRUE(stage_.lighting().shadows());
  ASSERT_EQ(1u, stage_.lighting().fires());
  const auto all = light();
  for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, kill);
  const auto without = light();
  EXPECT_NE(all[1], without[1]);
  EXPECT_NE(all[3], without[3]);
  for (const Fault& fault : kFaults) {
    SCOPED_TRACE(fault.name);
    restore();
    for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, fault.plant);
    const auto bad = light();
    for (size_t part = 0; part < bad.size(); ++part) EXPECT_TRUE(without[part] == bad[part]) << part;
    for (const size_t volume : {1u, 2u}) {
      const std::span halves(reinterpret_cast<const uint16_t*>(bad[volume].data()), bad[volume].size() / 2);
      EXPECT_TRUE(std::ranges::all_of(halves, [](uint16_t half) { return (half & 0x7C00) != 0x7C00; }));
    }
  }
}

TEST_F(BadParticlesTest, MayBeSoByTheirColoursAlone) {
  MethodInstance method = instance("wboit");
  constexpr uint32_t kFire = 1, kBirths = 12;
  for (uint32_t birth = 0; birth < kBirths; ++birth) plant(kFire, birth, kill);
  const Image without = picture(method);
  for (const float number : {kNaN, kInf})
    for (const bool glow : {true, false}) {
      SCOPED_TRACE(testing::Message() << number << (glow ? " emission" : " colour"));
      Effect changed = effect();
      Look& look = changed.emitters[kFire].look;
      for (auto& key : (glow ? look.emission : look.color).keys) key.value.g = number;
      stage_.revise(with(changed));
      restore();
      if (!glow)  // the others stand in the light of a fire that is not seen
        EXPECT_TRUE(is_finite(picture(method)));
      else
        EXPECT_TRUE(same(without, picture(method)));
      EXPECT_EQ(kBirths, bad_particles(stage_).count);
    }
}

/// Half floats and sums of squares end long before a file's numbers do.
TEST_F(BadParticlesTest, AreNotMadeOfAFireThatIsTooDimToSum) {
  MethodInstance method = instance("wboit");
  for (const float radiance : {1e-24f, 1e-30f, 1e-38f}) {
    Effect dim = effect();
    for (auto& key : dim.emitters[1].look.emission.keys) key.value = glm::vec3(radiance);
    stage_.revise(with(dim));
    stage_.go_to(kTick, kSize);
    EXPECT_TRUE(is_finite(picture(method)));
    const auto fires = gpu::read<float>(device, stage_.lighting().fire_lights());
    ASSERT_EQ(1u, stage_.lighting().fires());
    for (size_t i = 1; i < 1 + sizeof(shared::FireLight) / 4; ++i)
      EXPECT_TRUE(std::isfinite(fires[i])) << i << " of a fire of " << radiance;
  }
}

TEST_F(BadParticlesTest, MoveOnWithoutMeetingOthers) {
  stage_.go_to(kTick + 3, kSize);
  const std::vector<Particle> expected = stage_.simulation().particles();
  restore();
  for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, kFaults[0].plant);
  for (uint32_t tick = 1; tick <= 3; ++tick) stage_.go_to(kTick + tick, kSize);
  const std::vector<Particle> stepped = stage_.simulation().particles();
  ASSERT_EQ(expected.size(), stepped.size());
  size_t differ = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (std::memcmp(&expected[i], &stepped[i], sizeof expected[i]) == 0) continue;
    EXPECT_TRUE(std::isnan(stepped[i].position.x));
    ++differ;
  }
  EXPECT_EQ(kinds(), differ);
  MethodInstance method = instance("wboit");
  picture(method);
  EXPECT_EQ(kinds(), bad_particles(stage_).count) << "they are still told of";
}

TEST_F(BadParticlesTest, DoNotMoveTheCameraThatLooksAtTheOthers) {
  for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, kill);
  const Ball expected = ball_round(stage_, 0);
  for (const Fault& fault : kFaults) {
    restore();
    for (size_t kind = 0; kind < kinds(); ++kind) plant(kind, fault.plant);
    const Ball ball = ball_round(stage_, 0);
    if (std::string_view(fault.name).ends_with("velocity")) continue;  // where they are is known
    EXPECT_EQ(expected.centre, ball.centre) << fault.name;
    EXPECT_EQ(expected.radius_m, ball.radius_m) << fault.name;
  }
}

TEST_F(BadParticlesTest, AreToldOfInWords) {
  plant(0, kFaults[0].plant);
  plant(5, kFaults[0].plant);
  MethodInstance method = instance("wboit");
  picture(method);
  const BadParticles bad = bad_particles(stage_);
  EXPECT_EQ(fmt::format("2 particles are not finite, and left out; first: kinds (it) / smoke #{}", chosen(0)),
            to_text(bad));
  EXPECT_NE(remedy(bad).find("`smoke` in kinds.toml"), std::string::npos) << remedy(bad);
  const nlohmann::json first{
      {"effect", "kinds"}, {"instance", "it"}, {"emitter", "smoke"}, {"birth", chosen(0)}};
  EXPECT_EQ((nlohmann::json{{"count", 2}, {"first", first}}), to_json(bad));
  restore();
  picture(method);
  EXPECT_EQ("", to_text(bad_particles(stage_)));
  EXPECT_EQ(nlohmann::json(), to_json(bad_particles(stage_))["first"]);
}

}  // namespace
}  // namespace plume
