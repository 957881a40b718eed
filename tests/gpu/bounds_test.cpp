// Every card the simulation makes lies within the bounds that were known before it ran.
#include "sandbox/effects/bounds.h"

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
          const glm::vec3 corner = card.center + u * card.axis_u + v * card.axis_v;
          bounds.add({corner, corner});
        }
      result.push_back(bounds);
    }
    return result;
  }

  /// Every card at some ticks is in the bounds.
  void check(Effect effect, int ticks, std::mt19937& random) {
    uint32_t last = 0;
    for (Emitter& emitter : effect.emitters) {
      emitter.look.camera_offset_m = 0;
      last = std::max(last, SpawnSchedule(emitter.spawn).last_tick());
    }
    const Bounds bounds = effect_bounds(effect, {.position = kPosition, .yaw_deg = kYaw, .wind = kWind});
    Simulation simulation(device, pipelines,
                          {{.name = "test",
                            .effect = &effect,
                            .tick = 0,
                            .position = kPosition,
                            .yaw_deg = kYaw,
                            .seed = uint32_t(random())}},
                          5, kWind);
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

/// One emitter with a little of everything.
Effect random_effect(std::mt19937& random, int number) {
  const auto chance = [&] { return float(random() % 1000) / 999.0f; };
  const auto between = [&](float low, float high) { return low + (high - low) * chance(); };
  const auto sometimes = [&](float low, float high) { return random() % 2 ? between(low, high) : 0.0f; };
  const auto vector = [&](float size) {
    return glm::vec3(between(-size, size), between(-size, size), between(-size, size));
  };
  const float low = between(-3, 6);
  const uint32_t life = 1 + uint32_t(random() % 60);
  return {.id = "random " + std::to_string(number),
          .emitters = {
              {.name = "e",
               .spawn = {.rate = {{0, 600.0}, {60, 600.0}},
                         .life_ticks = {life, life + uint32_t(random() % 200)}},
               .shape = {.kind = ShapeKind(random() % 6),
                         .radius_m = between(0.01f, 2),
                         .thickness = chance(),
                         .size_m = glm::abs(vector(3)),
                         .angle_deg = between(0, 90),
                         .offset_m = vector(2)},
               .motion = {.speed = {low, low + between(0, 8)},
                          .velocity = vector(3),
                          .gravity = sometimes(-1, 1),
                          .drag = sometimes(0, 6),
                          .wind = between(0, 2),
                          .buoyancy = sometimes(-4, 8),
                          .cooling_s = between(0.1f, 3),
                          .floor_y = random() % 2 ? between(-2, 1) : -1e30f,
                          .curl = {.strength = sometimes(0, 8),
                                   .scale_m = between(0.2f, 4),
                                   .speed = between(-1, 1),
                                   .octaves = 1 + uint32_t(random() % 3)},
                          .vortex = {.strength = sometimes(-5, 5),
                                     .radius_m = between(0.1f, 2),
                                     .pull = sometimes(-3, 6)}},
               .look = {.radius_m = Curve({{0.0f, between(0.01f, 1)}, {between(0.1f, 1), between(0.01f, 1)}}),
                        .radius_scale = {between(0.2f, 1), between(1, 2)},
                        .opacity = 1.0f,
                        .spin_deg_s = {-90, 90},
                        .stretch_s = sometimes(0, 0.2f)}}}};
}

TEST_F(BoundsTest, HoldEveryCardOfRandomEffects) {
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) check(random_effect(random, i), 5, random);
}

}  // namespace
}  // namespace plume
