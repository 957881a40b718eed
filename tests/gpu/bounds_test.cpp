// Every card the simulation makes lies within the bounds that were known before it ran.
#include "sandbox/effects/bounds.h"

#include <optional>
#include <random>

#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::vec3 kPosition{0.5f, 0.2f, -1.0f}, kWind{0.4f, 0.0f, 0.1f};
constexpr float kYaw = 30.0f;

class BoundsTest : public GpuTest {
 protected:
  /// The corners of all cards at a tick, as a camera sees them that looks along `forward`.
  std::vector<Bounds> card_bounds(Simulation& simulation, const Bounds& all, glm::vec3 forward) {
    const glm::vec3 middle = 0.5f * (all.min + all.max);
    const float distance = glm::distance(all.min, all.max) + 1.0f;  // nothing is behind the camera
    const CameraKey camera{.position = middle - distance * forward, .target = middle};
    view.mapped<shared::ViewData>()[0] = make_view(Scene{}, camera, {16, 16}, simulation.tick());
    const gpu::Buffer cards(
        device,
        {.owner = "test", .label = "cards", .bytes = (simulation.cards() + 1) * sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    std::vector<Bounds> result;
    const auto all_cards = gpu::read<shared::Card>(device, cards);
    for (uint32_t i = 0; i < simulation.cards(); ++i) {
      const shared::Card& card = all_cards[i];
      if (card.axis_u == glm::vec3(0.0f)) continue;  // just dead
      Bounds bounds;
      for (const float u : {-1.0f, 1.0f})
        for (const float v : {-1.0f, 1.0f}) {
          if (u + v > 0 && (card.layers & shared::kCardTriangle)) continue;
          const glm::vec3 corner = card.center + u * card.axis_u + v * card.axis_v;
          bounds.add({corner, corner});
        }
      result.push_back(bounds);
    }
    return result;
  }

  /// Every card at some ticks is in the bounds.
  void check(Effect effect, int ticks, std::mt19937& random, std::optional<Path> path = {},
             const std::vector<Solid>& solids = {}) {
    uint32_t last = 0;
    for (uint32_t i = 0; i < effect.emitters.size(); ++i) {
      effect.emitters[i].look.camera_offset_m = 0;
      const Lineage lineage = lineage_of(effect.emitters, i);
      const SpawnContext context{
          .path = path ? &*path : nullptr, .per_root = lineage.per_root, .life = lineage.life};
      last = std::max(last, SpawnSchedule(lineage.spawn, context).last_tick());
    }
    const Bounds bounds = effect_bounds(effect, {.position = kPosition,
                                                 .yaw_deg = kYaw,
                                                 .path = path ? &*path : nullptr,
                                                 .wind = kWind,
                                                 .solids = &solids});
    Simulation simulation(device, pipelines,
                          {{.name = "test",
                            .effect = &effect,
                            .tick = 0,
                            .position = kPosition,
                            .path = path,
                            .yaw_deg = kYaw,
                            .seed = uint32_t(random())}},
                          5, kWind, solids);
    Bounds seen;
    for (int i = 0; i < ticks; ++i) {
      simulation.seek(last * uint32_t(i + 1) / uint32_t(ticks + 1));
      const float turn = float(random() % 628) / 100.0f;
      for (const Bounds& card :
           card_bounds(simulation, bounds, glm::normalize(glm::vec3(std::cos(turn), 0.3f, std::sin(turn)))))
        seen.add(card);
    }
    EXPECT_FALSE(seen.empty()) << effect.id;
    // What the camera's own arithmetic adds: cards are placed by way of the camera.
    const float slack = 1e-5f * (glm::distance(bounds.min, bounds.max) + glm::length(kPosition));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(bounds.min - slack, seen.min)) &&
                glm::all(glm::lessThanEqual(seen.max, bounds.max + slack)))
        << effect.id << ": cards from " << seen.min.x << " " << seen.min.y << " " << seen.min.z << " to "
        << seen.max.x << " " << seen.max.y << " " << seen.max.z << ", bounds from " << bounds.min.x << " "
        << bounds.min.y << " " << bounds.min.z << " to " << bounds.max.x << " " << bounds.max.y << " "
        << bounds.max.z << ", " << bounds.volume() / seen.volume() << " times the volume";
  }

  gpu::Buffer view{
      device, {.owner = "test", .label = "view", .bytes = sizeof(shared::ViewData), .host_visible = true}};
};

TEST_F(BoundsTest, HoldEveryCardOfShippedEffects) {
  std::mt19937 random(1);
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    Effect effect = library.effect(id);
    for (Emitter& emitter : effect.emitters)  // fewer of the same: the mist has 200 000
      if (emitter.spawn.rate.size() > 0 && SpawnSchedule(emitter.spawn).capacity() > 2000)
        for (Spawn::RateKey& key : emitter.spawn.rate) key.per_second /= 100;
    check(effect, 10, random);
  }
}

/// Numbers for effects that nobody would draw.
class Dice {
 public:
  explicit Dice(std::mt19937& random) : random_(random) {}
  uint32_t below(uint32_t n) { return uint32_t(random_() % n); }
  float between(float low, float high) { return low + (high - low) * float(below(1000)) / 999.0f; }
  float sometimes(float low, float high) { return below(2) ? between(low, high) : 0.0f; }
  glm::vec3 vector(float size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

 private:
  std::mt19937& random_;
};

/// A little of everything that pushes.
Motion random_motion(Dice& dice) {
  const float low = dice.between(-3, 6);
  return {.speed = {low, low + dice.between(0, 8)},
          .velocity = dice.vector(3),
          .gravity = dice.sometimes(-1, 1),
          .drag = dice.sometimes(0, 6),
          .wind = dice.between(0, 2),
          .buoyancy = dice.sometimes(-4, 8),
          .cooling_s = dice.between(0.1f, 3),
          .floor_y = dice.below(2) ? dice.between(-2, 1) : -1e30f,
          .curl = {.strength = dice.sometimes(0, 8),
                   .scale_m = dice.between(0.2f, 4),
                   .speed = dice.between(-1, 1),
                   .octaves = 1 + dice.below(3)},
          .vortex = {.strength = dice.sometimes(-5, 5),
                     .radius_m = dice.between(0.1f, 2),
                     .pull = dice.sometimes(-3, 6)}};
}

Emitter random_emitter(Dice& dice) {
  const uint32_t life = 1 + dice.below(60);
  return {.name = "e",
          .spawn = {.rate = {{0, 600.0}, {60, 600.0}}, .life_ticks = {life, life + dice.below(200)}},
          .shape = {.kind = ShapeKind(dice.below(7)),
                    .radius_m = dice.between(0.01f, 2),
                    .thickness = dice.between(0, 1),
                    .size_m = glm::abs(dice.vector(3)),
                    .angle_deg = dice.between(0, 90),
                    .to_m = dice.vector(3),
                    .offset_m = dice.vector(2)},
          .motion = random_motion(dice),
          .look = {.radius_m = Curve(
                       {{0.0f, dice.between(0.01f, 1)}, {dice.between(0.1f, 1), dice.between(0.01f, 1)}}),
                   .radius_scale = {dice.between(0.2f, 1), dice.between(1, 2)},
                   .opacity = 1.0f,
                   .spin_deg_s = {-90, 90},
                   .stretch_s = dice.sometimes(0, 0.2f)}};
}

Effect random_effect(Dice& dice, int number) {
  return {.id = "random " + std::to_string(number), .emitters = {random_emitter(dice)}};
}

TEST_F(BoundsTest, HoldEveryCardOfRandomEffects) {
  std::mt19937 random(2);
  Dice dice(random);
  for (int i = 0; i < 50; ++i) check(random_effect(dice, i), 5, random);
}

TEST_F(BoundsTest, HoldWhatIsAttractedTurnedKilledAndDisplaced) {
  std::mt19937 random(3);
  Dice dice(random);
  const auto grid = std::make_shared<FieldGrid>(FieldGrid{
      .size = {2, 1, 1}, .low = glm::vec3(-3), .high = glm::vec3(3), .cells = {{4, 0, 1}, {0, -3, 2}}});
  for (int i = 0; i < 8; ++i) {
    Effect effect = random_effect(dice, i);
    Motion& motion = effect.emitters[0].motion;
    motion.orbit = dice.sometimes(-1, 1);
    if (dice.below(2)) motion.attractors = {{dice.vector(3), dice.vector(3), dice.between(-9, 9), 0.5f}};
    if (dice.below(2)) motion.field = VectorField{.grid = grid, .use = VectorField::Use(dice.below(2))};
    if (dice.below(2))
      motion.kill = {{.position_m = dice.vector(1), .size_m = glm::vec3(5), .outside = true}};
    if (dice.below(2)) motion.kill.push_back({.kind = KillVolume::Kind::kPlane, .position_m = {0, -2, 0}});
    motion.curl_displacement = {.amplitude_m = dice.sometimes(0, 1), .scale_m = 0.7f, .octaves = 2};
    std::optional<Path> path;
    if (dice.below(2)) path = Path({{0, {0, 0, 0}}, {20, dice.vector(5)}, {50, dice.vector(5)}});
    check(effect, 5, random, path);
  }
}

TEST_F(BoundsTest, HoldWhatCollides) {
  std::mt19937 random(4);
  Dice dice(random);
  const std::vector<Solid> solids = {
      {.kind = SolidKind::kPlane, .position = {0, -1, 0}, .size_m = {20, 0, 20}},
      {.kind = SolidKind::kBox, .position = {1, 0, 0}, .size_m = {2, 1, 3}, .yaw_deg = 20},
      {.kind = SolidKind::kSphere, .position = {-1, 1, 0}, .radius_m = 1},
      {.kind = SolidKind::kCapsule, .position = {0, 2, 2}, .end = {3, 3, 2}, .radius_m = 0.5f}};
  for (int i = 0; i < 12; ++i) {
    Effect effect = random_effect(dice, i);
    Motion& motion = effect.emitters[0].motion;
    motion.curl.strength = 0;  // it would hide what collisions do
    motion.orbit = dice.below(4) ? 0.0f : 0.5f;
    motion.collision = Collision{.response = CollisionResponse(dice.below(4)),
                                 .bounce = dice.between(0, 1),
                                 .friction = dice.sometimes(0, 1),
                                 .radius_m = dice.sometimes(0, 0.2f)};
    check(effect, 5, random, {}, solids);
  }
}

TEST_F(BoundsTest, HoldMeshesRibbonsAndTrailsOfChildren) {
  std::mt19937 random(7);
  Dice dice(random);
  for (int i = 0; i < 8; ++i) {
    Effect effect = random_effect(dice, i);
    Emitter& first = effect.emitters[0];
    first.look.ribbon = i % 2 == 0;
    if (!first.look.ribbon) {
      effect.meshes = {{.id = "shard", .triangles = {{{{0, 0, 0}, {1, 0, 0}, {0, 0.3f, -2}}}}}};
      first.look.meshes = {{.id = "shard"}};
    }
    if (i % 4 < 2) {
      Emitter child = first;
      child.name = "child";
      child.spawn.rate = {};
      child.parent = Parent{.emitter = "e", .index = 0, .event = BirthEvent::kLife, .every_ticks = 9};
      effect.emitters.push_back(child);
    }
    check(effect, 3, random);
  }
}

TEST_F(BoundsTest, HoldWhatIsBornInASolidAndPushedOut) {
  std::mt19937 random(6);
  const Effect effect{.id = "pushed out",
                      .emitters = {{.name = "e",
                                    .spawn = {.bursts = {{0, 20}}, .life_ticks = {9, 9}},
                                    .motion = {.collision = Collision{}},
                                    .look = {.radius_m = 0.1f, .opacity = 1.0f}}}};
  check(effect, 5, random, {}, {{.kind = SolidKind::kBox, .position = kPosition, .size_m = {9, 7, 8}}});
}

TEST_F(BoundsTest, HoldChildrenThatFlyOnAsTheirParents) {
  std::mt19937 random(7);
  Effect effect{.id = "inherited",
                .emitters = {{.name = "parent",
                              .spawn = {.bursts = {{0, 20}}, .life_ticks = {20, 20}},
                              .motion = {.speed = {5, 5}},
                              .look = {.radius_m = 0.1f, .opacity = 1.0f}}}};
  Emitter child = effect.emitters[0];
  child.name = "child";
  child.parent = Parent{.event = BirthEvent::kDeath, .count = 2, .inherit_velocity = 1.5f};
  child.spawn = {.life_ticks = {30, 30}};
  child.motion = {};
  effect.emitters.push_back(child);
  check(effect, 9, random);
}

TEST_F(BoundsTest, HoldChildren) {
  std::mt19937 random(5);
  Dice dice(random);
  for (int i = 0; i < 12; ++i) {
    Effect effect = random_effect(dice, i);
    effect.emitters[0].spawn = {.bursts = {{0, 5}, {7, 5}}, .life_ticks = {20, 60}};
    for (uint32_t parent = 0; parent < 1 + i % 2u; ++parent) {
      Emitter child = random_emitter(dice);
      child.spawn = {.life_ticks = {10, 40}};
      child.parent = Parent{.index = parent,
                            .event = BirthEvent(dice.below(3)),
                            .count = 3,
                            .first_tick = 2,
                            .every_ticks = 5,
                            .inherit_velocity = dice.between(-1, 2)};
      effect.emitters.push_back(child);
    }
    check(effect, 5, random);
  }
}

}  // namespace
}  // namespace plume
