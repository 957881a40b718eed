// Only what a scene calls for is simulated, and what slept is as if it never had.
#include <random>

#include "sandbox/scene/view.h"
#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

class DemandTest : public MovingParticles {
 protected:
  /// Lives for about two seconds in a ball of 3 m.
  static Emitter puffs(const std::string& name) {
    Emitter e = emitter(0);
    e.name = name;
    e.spawn.bursts = {{0, 40}};
    e.spawn.rate = {{20, 60}, {90, 30}};
    e.spawn.life_ticks = {30, 90};
    e.motion.speed = {0.2f, 1};
    e.motion.drag = 1;
    e.motion.curl = {.strength = 2};
    e.motion.kill = {{.kind = KillVolume::Kind::kSphere, .radius_m = 3, .outside = true}};
    return e;
  }
  /// On a row, 12 m apart, called one after the other.
  std::vector<Call> calls(const Effect& effect, uint32_t count) {
    std::vector<Call> result;
    for (uint32_t i = 0; i < count; ++i)
      result.push_back({.name = std::to_string(i),
                        .effect = &effect,
                        .tick = 15 * i,
                        .position = {12.0f * float(i), 0, 0},
                        .yaw_deg = 0,
                        .seed = i});
    return result;
  }
  Views looking(glm::vec3 from, glm::vec3 at) {
    Scene scene;
    const CameraKey camera{.position = from, .target = at, .vertical_fov_deg = 40};
    return std::vector{view_volume(make_view(scene, camera, {160, 90}, 0))};
  }
  Views at_nothing() { return looking({0, 100, 0}, {0, 200, 1}); }
  Views at_call(uint32_t i) { return looking({12.0f * float(i), 0, 8}, {12.0f * float(i), 0, 0}); }
};

TEST_F(DemandTest, StateIsExactAfterAnyScriptOfCameraMoves) {
  Emitter trail = puffs("trail");
  trail.parent = Parent{.emitter = "puffs", .index = 0, .event = BirthEvent::kLife, .every_ticks = 30};
  trail.spawn.bursts.clear(), trail.spawn.rate.clear();
  const Effect effect = effect_of({puffs("puffs"), trail});
  Simulation sleeper(device, pipelines, calls(effect, 4), 1, {0.1f, 0, 0});
  Simulation waking(device, pipelines, calls(effect, 4), 1, {0.1f, 0, 0});
  std::mt19937 random(5);
  std::uniform_real_distribution<float> place(-10, 50), height(-2, 6);
  std::map<uint32_t, uint64_t> hashes;
  uint64_t saved = 0;
  for (int script = 0; script < 200; ++script) {
    uint32_t tick = uint32_t(random() % 150);
    for (int move = 0; move < 5; ++move) {
      sleeper.go_to(tick, looking({place(random), height(random), 9}, {place(random), 0, 0}));
      tick += random() % 3 == 0 ? uint32_t(random() % 40) : 1u;
    }
    sleeper.go_to(tick, kEverything);
    if (!hashes.contains(tick)) {
      waking.seek(tick);
      hashes[tick] = waking.state_hash();
    }
    ASSERT_EQ(hashes[tick], sleeper.state_hash()) << "script " << script << " at tick " << tick;
  }
  for (const InstanceDemand& demand : sleeper.demand()) saved += demand.ticks_saved;
  EXPECT_GT(saved, 1000u) << "something slept";
}

TEST_F(DemandTest, WhatNobodySeesHasNoMemoryAndNoDispatchAndSaysSo) {
  const Effect effect = effect_of({puffs("puffs")});
  Simulation simulation(device, pipelines, calls(effect, 3), 1, {});
  simulation.go_to(40, at_call(1));
  const auto demand = simulation.demand();
  EXPECT_TRUE(demand[1].awake);
  EXPECT_GT(demand[1].bytes, 0u);
  for (const size_t i : {0u, 2u}) {
    EXPECT_FALSE(demand[i].awake);
    EXPECT_EQ("out of view", demand[i].why);
    EXPECT_EQ(0u, demand[i].bytes);
    EXPECT_EQ(0u, demand[i].dispatches);
    EXPECT_EQ(0u, demand[i].ticks_simulated);
    EXPECT_GT(demand[i].ticks_saved, 0u);
    EXPECT_EQ(demand[1].bytes, demand[i].bytes_saved);
  }
  EXPECT_EQ(demand[1].bytes, device.memory().owner_bytes("particles"));
  simulation.go_to(41, at_nothing());
  EXPECT_EQ(0u, simulation.cards());
  EXPECT_EQ(0u, device.memory().owner_bytes("particles"));
  EXPECT_EQ(3 * demand[1].bytes, total(simulation.demand()).bytes_saved);
}

TEST_F(DemandTest, AOneShotThatStartedOffScreenHasRunWhenOneLooks) {
  const Effect effect = effect_of({puffs("puffs")});
  Simulation simulation(device, pipelines, calls(effect, 1), 1, {}),
      seen(device, pipelines, calls(effect, 1), 1, {});
  simulation.go_to(0, at_nothing());
  simulation.go_to(50, at_call(0));
  seen.seek(50);
  EXPECT_EQ(seen.state_hash(), simulation.state_hash());
  simulation.go_to(51, at_nothing());
  simulation.go_to(300, at_call(0));
  EXPECT_EQ("finished at its tick 178", simulation.demand()[0].why);
}

TEST_F(DemandTest, WhoWakesDoesNotBringTheOthersFromTheirBirths) {
  const Effect effect = effect_of({puffs("puffs")});
  Simulation simulation(device, pipelines, calls(effect, 2), 1, {});
  simulation.go_to(60, at_call(0));
  const uint64_t before = simulation.demand()[0].ticks_simulated;
  simulation.go_to(61, kEverything);
  EXPECT_EQ(before + 1, simulation.demand()[0].ticks_simulated);
  EXPECT_EQ(46u, simulation.demand()[1].ticks_simulated) << "called at tick 15";
}

TEST_F(DemandTest, WhatPausesOffScreenGoesOnWhereItWas) {
  Effect effect = effect_of({puffs("puffs")});
  Simulation always(device, pipelines, calls(effect, 1), 1, {});
  effect.off_screen = OffScreen::kPause;
  Simulation simulation(device, pipelines, calls(effect, 1), 1, {});
  simulation.go_to(0, at_call(0));
  for (uint32_t tick = 1; tick <= 90; ++tick)
    simulation.go_to(tick, tick > 30 && tick <= 70 ? at_nothing() : at_call(0));
  always.seek(50);
  EXPECT_EQ(always.state_hash(), simulation.state_hash()) << "40 ticks did not pass";
  simulation.go_to(60, at_nothing());
  EXPECT_EQ("out of view, stopped at its tick 30", simulation.demand()[0].why);
  // Nobody looked while a jump passed over 100 ticks but the script's camera, which saw every other ten.
  simulation.watch_by({.views = [&](uint32_t tick) { return tick / 10 % 2 ? at_call(0) : at_nothing(); }});
  simulation.go_to(160, at_call(0));
  always.seek(30 + 50 + 1);
  EXPECT_EQ(always.state_hash(), simulation.state_hash());
}

TEST_F(DemandTest, AJumpPastTheScriptsLastMoveLooksAtItNoMore) {
  Effect effect = effect_of({puffs("puffs")});
  Simulation always(device, pipelines, calls(effect, 1), 1, {});
  effect.off_screen = OffScreen::kPause;
  for (const bool seen_last : {false, true}) {
    Simulation simulation(device, pipelines, calls(effect, 1), 1, {});
    uint32_t looks = 0;
    const auto views = [&](uint32_t tick) {
      ++looks;
      return (tick < 20) == seen_last ? at_nothing() : at_call(0);
    };
    simulation.watch_by({.views = views, .still_from = 20});
    simulation.go_to(0, at_call(0));
    simulation.go_to(100, at_call(0));
    EXPECT_EQ(20u, looks);
    always.seek(seen_last ? 100 - 19 : 19 + 1);
    EXPECT_EQ(always.state_hash(), simulation.state_hash()) << "seen at last: " << seen_last;
  }
}

TEST_F(DemandTest, AFrozenInstanceStandsStillAndCostsNoDispatch) {
  const Effect effect = effect_of({puffs("puffs")});
  auto frozen_calls = calls(effect, 1);
  frozen_calls[0].freezes = {{20, 50}};
  Simulation simulation(device, pipelines, frozen_calls, 1, {}),
      always(device, pipelines, calls(effect, 1), 1, {});
  simulation.go_to(30, kEverything);
  always.seek(20);
  EXPECT_EQ(always.state_hash(), simulation.state_hash());
  const uint64_t dispatches = simulation.demand()[0].dispatches;
  for (uint32_t tick = 31; tick <= 50; ++tick) EXPECT_TRUE(simulation.go_to(tick, kEverything).empty());
  EXPECT_EQ(dispatches, simulation.demand()[0].dispatches);
  EXPECT_FALSE(simulation.demand()[0].awake);
  EXPECT_EQ("frozen at its tick 20", simulation.demand()[0].why);
  simulation.go_to(60, kEverything);
  always.seek(30);
  EXPECT_EQ(always.state_hash(), simulation.state_hash());
  simulation.go_to(10, kEverything);  // back before it
  simulation.go_to(60, kEverything);
  EXPECT_EQ(always.state_hash(), simulation.state_hash());
}

TEST_F(DemandTest, AJumpOfAnHourNeitherLosesNorDoublesBirths) {
  Emitter drip = puffs("drip");
  drip.spawn.bursts = {{0, 3}, {216'010, 7}};
  drip.spawn.rate = {{0, 0.37}, {300'000, 41.0}};
  const Effect effect = effect_of({drip});
  Simulation jumped(device, pipelines, calls(effect, 1), 1, {}),
      near(device, pipelines, calls(effect, 1), 1, {});
  jumped.go_to(5, kEverything);
  jumped.go_to(216'005, kEverything);
  near.seek(215'990);
  for (uint32_t tick = 216'006; tick <= 216'030; ++tick) jumped.step();
  while (near.tick() < 216'030) near.step();
  EXPECT_EQ(near.state_hash(), jumped.state_hash());
  EXPECT_EQ(near.particles().size(), jumped.particles().size());
}

TEST_F(DemandTest, AHundredDeclaredEffectsOfWhichTwoAreCalledCostAsMuchAsTwo) {
  const auto scene_of = [&](uint32_t declared) {
    Scene scene;
    scene.camera = {CameraKey{}};
    const auto ids = library.ids(PresetKind::kEffect);
    for (uint32_t i = 0; i < declared; ++i)
      scene.instances.push_back({.name = std::to_string(i), .effect = ids[i % ids.size()], .effect_at = {}});
    scene.instances[0].effect = "dust", scene.instances[1].effect = "fireball";
    scene.instances[0].call_tick = scene.instances[1].call_tick = 0;
    return scene;
  };
  struct Cost {
    uint64_t bytes, pipelines;
    std::vector<std::string> passes;
    bool operator==(const Cost&) const = default;
  };
  const auto cost_of = [&](uint32_t declared) {
    gpu::Pipelines own(device, shaders);
    Stage stage(device, own, library, scene_of(declared));
    Cost cost{};
    for (uint32_t tick = 40; tick < 43; ++tick)
      for (const gpu::PassTime& pass : stage.go_to(tick, {160, 90})) cost.passes.push_back(pass.name);
    cost.bytes = device.memory().total_bytes();
    cost.pipelines = own.count();
    return cost;
  };
  const Cost two = cost_of(2), hundred = cost_of(100);
  EXPECT_EQ(two, hundred);
  EXPECT_GT(two.pipelines, 0u);
}

}  // namespace
}  // namespace plume
