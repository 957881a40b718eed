// Particles that are meshes: where their faces lie against the same rule in double precision, and how opaque
// ones stand among everything else.
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "shaders/effects/puff.h"
#include "shaders/shared/hash.h"
#include "tests/gpu/particle_looks.h"

namespace plume {
namespace {

constexpr double kTau = 2 * M_PI;

double random(uint32_t key, uint32_t n) {
  return (shared::hash(key + n * 0x9e3779b9u) >> 8) / 16777216.0;
}

struct Quaternion {
  glm::dvec3 v;
  double w;
  glm::dvec3 turn(glm::dvec3 p) const { return p + 2.0 * glm::cross(v, glm::cross(v, p) + w * p); }
};

glm::dvec3 axis_of(uint32_t key) {
  const double y = 1 - 2 * random(key, 33), around = kTau * random(key, 34), ring = std::sqrt(1 - y * y);
  return {ring * std::cos(around), y, ring * std::sin(around)};
}

Quaternion first_rotation(uint32_t key) {
  const double a = random(key, 30), b = kTau * random(key, 31), c = kTau * random(key, 32);
  return {{std::sqrt(1 - a) * std::sin(b), std::sqrt(1 - a) * std::cos(b), std::sqrt(a) * std::sin(c)},
          std::sqrt(a) * std::cos(c)};
}

class MeshParticles : public ParticleCards {
 protected:
  static Mesh wedge() {
    return {.id = "wedge",
            .triangles = {{{{0, 0, -0.5f}, {1, 0, 0.2f}, {0, 2, 0}}},
                          {{{0, 0, -0.5f}, {0, 2, 0}, {-0.4f, 0.1f, 1}}}}};
  }
  static Mesh sliver() { return {.id = "sliver", .triangles = {{{{-1, 0, 0}, {1, 0, 0}, {0, 0.1f, 0}}}}}; }
  static Effect effect_of(std::vector<Mesh> meshes, uint32_t count) {
    Effect effect{.id = "test", .name = "", .description = "", .emitters = {Emitter()}};
    Emitter& e = effect.emitters[0];
    e.name = "test";
    e.spawn.bursts = {{0, count}};
    e.spawn.life_ticks = {1000, 1000};
    e.look.opacity = Curve(0.5f);
    e.look.radius_m = Curve(0.3f);
    for (const Mesh& mesh : meshes) e.look.meshes.push_back({.id = mesh.id});
    effect.meshes = std::move(meshes);
    return effect;
  }
  static uint32_t key_of(const Effect& effect, const shared::Particle& p) {
    MeshTable table;
    const Call call{.name = "test", .effect = &effect, .tick = 0, .position = {}, .yaw_deg = 0, .seed = 1};
    return shared::hash_pair(emitter_data(call, 0, 1, {}, table).seed, p.birth);
  }
};

TEST_F(MeshParticles, FacesLieWhereKeyAndAgeSay) {
  Effect effect = effect_of({wedge(), sliver()}, 24);
  Emitter& e = effect.emitters[0];
  e.motion.speed = {0.2f, 0.5f};
  e.look.tumble_deg_s = {100, 700};
  e.look.radius_scale = {0.5f, 2.0f};
  constexpr uint32_t kTick = 37;
  const Simulation simulation = simulate(effect, kTick);
  const auto cards = cards_of(simulation);
  const auto particles = simulation.particles();
  ASSERT_EQ(48u, cards.size()) << "as many a particle as the largest mesh has faces";
  std::array<uint32_t, 2> chosen{};
  for (size_t i = 0; i < particles.size(); ++i) {
    const uint32_t key = key_of(effect, particles[i]), mesh = shared::hash(key + 36) % 2;
    ++chosen[mesh];
    const auto faces = mesh_triangles(effect.meshes[mesh]);
    double reach = 0;
    for (const auto& triangle : effect.meshes[mesh].triangles)
      for (const glm::vec3& corner : triangle) reach = std::max(reach, glm::length(glm::dvec3(corner)));
    const double scale = double(e.look.radius_m.at(0)) * (0.5 + 1.5 * random(key, 22)) / reach;
    const double angle = glm::radians(100 + 600 * random(key, 35)) * kTick / 60;
    const Quaternion before = first_rotation(key),
                     tumble{axis_of(key) * std::sin(angle / 2), std::cos(angle / 2)};
    for (size_t face = 0; face < 2; ++face) {
      const shared::Card& card = cards[2 * i + face];
      if (face >= faces.size()) {
        EXPECT_EQ(0.0f, card.optical_depth) << "nothing is drawn where there is no face";
        continue;
      }
      EXPECT_TRUE(is_triangle(card));
      const glm::dvec3 a(faces[face].corner), u(faces[face].edge_u), v(faces[face].edge_v);
      const Triangle expected{a, a + u, a + v}, found = corners(card);
      for (size_t c = 0; c < 3; ++c) {
        const glm::dvec3 place =
            glm::dvec3(particles[i].position) + tumble.turn(before.turn(expected[c] * scale));
        EXPECT_LT(glm::length(place - found[c]), 1e-5) << "particle " << i << " face " << face;
      }
    }
  }
  EXPECT_GT(chosen[0], 4u);
  EXPECT_GT(chosen[1], 4u);
}

TEST_F(MeshParticles, PiecesOnTheFloorStandOnItAndTumbleNoMore) {
  Effect effect = effect_of({wedge()}, 10);
  Emitter& e = effect.emitters[0];
  e.motion.gravity = 1;
  e.motion.floor_y = 0.25f;
  e.look.tumble_deg_s = {300, 400};
  const auto early = cards_of(simulate(effect, 100)), late = cards_of(simulate(effect, 130));
  for (size_t i = 0; i < early.size(); ++i)
    EXPECT_LT(glm::length(early[i].axis_u - late[i].axis_u) + glm::length(early[i].center - late[i].center),
              1e-6f);
  for (size_t piece = 0; piece < 10; ++piece) {
    double lowest = 1e9;
    for (size_t face = 0; face < 2; ++face)
      for (const glm::dvec3& corner : corners(late[2 * piece + face])) lowest = std::min(lowest, corner.y);
    EXPECT_NEAR(0.25, lowest, 1e-5);
  }
}

TEST_F(MeshParticles, GlossAddsWhatGlassMirrorsOfSkyAndSun) {
  Effect effect = effect_of({wedge()}, 200);
  Look& look = effect.emitters[0].look;
  for (const auto& card : cards_of(simulate(effect, 5))) EXPECT_EQ(glm::uvec2(0), card.emission);
  look.gloss = 0.75f;
  look.fade = Curve(0.5f);
  look.emission = Gradient(glm::vec3(0.25f, 0.125f, 0.0625f));
  Light light;
  light.sun_direction = glm::normalize(light.sun_direction);
  const glm::dvec3 sun(light.sun_direction), camera(0, 1, 10);
  size_t glints = 0, from_below = 0;
  const Simulation simulation = simulate(effect, 5);
  for (const auto& card : cards_of(simulation, light)) {
    const auto [corner, u_end, v_end] = corners(card);
    const glm::dvec3 to_eye = glm::normalize(camera - corner);
    glm::dvec3 normal = glm::normalize(glm::cross(u_end - corner, v_end - corner));
    if (glm::dot(normal, to_eye) < 0) normal = -normal;
    const glm::dvec3 from = glm::reflect(-to_eye, normal);
    const double fresnel = 0.04 + 0.96 * std::pow(1 - glm::dot(normal, to_eye), 5);
    const glm::dvec3 sky = glm::mix(glm::dvec3(light.horizon) * (from.y < 0 ? 0.4 : 1.0),
                                    glm::dvec3(light.zenith), 1 - std::exp(-3.5 * std::max(from.y, 0.0)));
    const glm::dvec3 glint =
        glm::dvec3(light.sun_color) * 150.0 * std::pow(std::max(glm::dot(from, sun), 0.0), 300);
    glints += glint.r > 0.1, from_below += from.y < -0.1;
    const glm::vec2 rg = glm::unpackHalf2x16(card.emission.x), b = glm::unpackHalf2x16(card.emission.y);
    for (int c = 0; c < 3; ++c) {
      const double expected = 0.5 * (double(look.emission.at(0)[c]) + 0.75 * fresnel * (sky[c] + glint[c]));
      // Halves, and a glint that a change of the angle by 1e-5 changes by 300 times as much.
      EXPECT_NEAR(expected, glm::vec3(rg, b.x)[c], 0.01 * expected);
    }
  }
  EXPECT_GT(glints, 0u);
  EXPECT_GT(from_below, 20u);
}

class Debris : public PresetFolderTest {
 protected:
  void SetUp() override {
    PresetFolderTest::SetUp();
    // Whichever way it is turned, a ball of radius 1 in it hides what is behind.
    write("meshes/cube.obj",
          "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
          "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    write("effects/debris.toml",
          "name = 'D'\n[[emitter]]\nname = 'd'\nspawn = {bursts = [[10, 1]], life = 20}\n"
          "[emitter.look]\nmesh = 'cube'\nopaque = true\nlit = false\nradius_m = 1.8\ncolor = [0.25, 0.5, "
          "0.125]\n"
          "tumble_deg_s = 90\n");
    scene_.light.sky = false;
    scene_.light.horizon = {0.2f, 0.3f, 0.5f};
    scene_.tonemap = Tonemap::kNone;
    scene_.camera = {{.tick = 0, .position = {0, 0, 8}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
    scene_.instances = {{.name = "d", .effect = "debris", .call_tick = 0}};
  }
  struct Shot {
    glm::vec3 middle, corner;
    std::vector<std::string> passes;
  };
  Shot shot(const Scene& scene, uint32_t tick, std::string_view id) {
    constexpr glm::uvec2 kSize{64, 36};
    Stage stage(device, pipelines, PresetLibrary(root_), scene);
    const Targets targets(device, kSize);
    stage.go_to(tick, kSize);
    EXPECT_EQ(uint32_t(scene.panes.size()), stage.transparents().count) << "pieces are no cards";
    MethodInstance method = instance(id);
    const FrameReport report =
        render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method);
    const auto pixels = read_picture(device, targets).linear.pixels;
    Shot result{.middle = pixels[18 * kSize.x + 32], .corner = pixels[0], .passes = {}};
    for (const auto& pass : report.passes) result.passes.push_back(pass.name);
    return result;
  }
  static void expect_color(glm::vec3 expected, glm::vec3 found, const char* what) {
    EXPECT_LT(glm::length(expected - found), 2e-3f)
        << what << ": " << found.r << " " << found.g << " " << found.b;
  }

  Scene scene_;
};

TEST_F(Debris, HidesWhatIsBehindItAndIsHiddenByWhatIsInFront) {
  const glm::vec3 own{0.25f, 0.5f, 0.125f}, white(1.0f);
  for (const char* id : {"reference", "avboit"}) {
    Scene scene = scene_;
    scene.panes = {{.position = {0, 0, -4}, .size_m = {60, 60}, .color = white, .coverage = 0.5f}};
    const Shot behind = shot(scene, 15, id);
    expect_color(own, behind.middle, "a pane behind it");
    expect_color(glm::mix(scene.light.horizon, white, 0.5f), behind.corner, "beside it");
    scene.panes[0].position.z = 3;
    expect_color(glm::mix(own, white, 0.5f), shot(scene, 15, id).middle, "a pane before it");
    Solid wall;
    wall.material = Material::kUnlit;
    wall.color = {0.7f, 0.1f, 0.1f};
    wall.position = {0, 0, 3};
    wall.size_m = {2, 2, 0.2f};
    scene.panes.clear();
    scene.solids = {wall};
    expect_color(wall.color, shot(scene, 15, id).middle, "a wall before it");
    scene.solids[0].position.z = -3;
    expect_color(own, shot(scene, 15, id).middle, "a wall behind it");
  }
}

TEST_F(Debris, StandsWhereCardsOfTheSameMeshesWould) {
  // Of two emitters, with meshes of different size, children that wait for their birth, and slots used again.
  write("meshes/wedge.obj", "v 0 0 -0.5\nv 1 0 0.2\nv 0 2 0\nv -0.4 0.1 1\nf 1 2 3\nf 1 3 4\n");
  const auto picture = [&](const std::string& solid) {
    const std::string look =
        "mesh = ['cube', 'wedge']\nlit = false\nradius_m = 0.7\n"
        "tumble_deg_s = 200\nemission = [0.1, 0.05, 0.2]\n" +
        solid;
    write("effects/debris.toml",
          "name = 'D'\n[[emitter]]\nname = 'a'\nspawn = {rate = 30, duration = 100, life = [12, 20]}\n"
          "motion = {speed = 5}\n[emitter.look]\ncolor = [0.25, 0.5, 0.125]\n" +
              look +
              "[[emitter]]\nname = 'b'\nparent = {emitter = 'a', on = 'death', count = 2}\n"
              "spawn = {life = 20}\nmotion = {speed = 3}\n[emitter.look]\ncolor = [0.5, 0.25, 0.75]\n" +
              look);
    Stage stage(device, pipelines, PresetLibrary(root_), scene_);
    return draw(stage, 71, {160, 90}, "reference").linear.pixels;
  };
  const auto pieces = picture("opaque = true\n"), cards = picture("opacity = 1\n");
  size_t drawn = 0, different = 0;
  for (size_t i = 0; i < pieces.size(); ++i) {
    drawn += glm::length(pieces[i] - scene_.light.horizon) > 1e-2f;
    different += glm::length(pieces[i] - cards[i]) > 1e-2f;
  }
  EXPECT_GT(drawn, pieces.size() / 20);
  EXPECT_LT(different, drawn / 100) << "edges, which are rounded differently";
}

TEST_F(Debris, IsLitByTheSunOnTheSideThatIsSeen) {
  write("meshes/sheet.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
  write("effects/debris.toml",
        "name = 'D'\n[[emitter]]\nname = 'd'\nspawn = {bursts = [[10, 1]], life = 20}\n"
        "look = {mesh = 'sheet', opaque = true, radius_m = 2, color = [0.25, 0.5, 0.125]}\n");
  const Effect effect = PresetLibrary(root_).effect("debris");
  scene_.light.horizon = scene_.light.zenith = glm::vec3(0.0f);
  scene_.light.sun_direction = glm::normalize(glm::vec3(0.6f, 0.5f, 0.4f));
  const glm::dvec3 sun(scene_.light.sun_direction);
  size_t lit = 0, turned_away = 0;
  for (uint32_t seed = 0; seed < 12; ++seed) {
    scene_.instances[0].seed = seed;
    MeshTable table;
    const Call call{
        .name = "d", .effect = &effect, .tick = 0, .position = {}, .yaw_deg = 0, .seed = seed, .layers = {}};
    const uint32_t key = shared::hash_pair(emitter_data(call, 0, scene_.seed, {}, table).seed, 0);
    glm::dvec3 normal = first_rotation(key).turn({0, 0, 1});
    if (std::abs(normal.z) < 0.3) continue;  // seen from its edge
    if (normal.z < 0) normal = -normal;
    const double facing = std::max(glm::dot(normal, sun), 0.0), shade = 0.75 + 0.5 * random(key, 37);
    lit += facing > 0.1, turned_away += facing == 0;
    expect_color(glm::vec3(0.25f, 0.5f, 0.125f) * scene_.light.sun_color * float(facing * shade),
                 shot(scene_, 15, "reference").middle, "a sheet");
  }
  EXPECT_GT(lit, 2u);
  EXPECT_GT(turned_away, 0u);
}

TEST_F(Debris, CostsNoPassWhenNoneIsAwake) {
  const auto has = [](const Shot& s, std::string_view name) {
    return std::ranges::find(s.passes, name) != s.passes.end();
  };
  for (const uint32_t tick : {5u, 40u}) {
    const Shot asleep = shot(scene_, tick, "reference");
    EXPECT_FALSE(has(asleep, "debris") || has(asleep, "debris depth")) << "tick " << tick;
    expect_color(scene_.light.horizon, asleep.middle, "nothing");
  }
  const Shot awake = shot(scene_, 15, "reference");
  EXPECT_TRUE(has(awake, "debris") && has(awake, "debris depth"));
}

TEST_F(Debris, AMeshThatIsNotThereIsNamedWhereTheEffectAsksForIt) {
  write("effects/debris.toml",
        "name = 'D'\n[[emitter]]\nname = 'd'\nspawn = {bursts = [[10, 1]], life = 20}\n"
        "look = {mesh = ['cube', 'cubes'], opaque = true}\n");
  try {
    PresetLibrary(root_).effect("debris");
    FAIL() << "nothing was thrown";
  } catch (const std::exception& error) {
    EXPECT_TRUE(
        std::string(error.what()).ends_with("debris.toml:5:16: unknown mesh `cubes`, did you mean `cube`?"))
        << error.what();
  }
}

}  // namespace
}  // namespace plume
