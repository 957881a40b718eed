// What we ship must read without a word, and name only what we ship.
#include <gtest/gtest.h>

#include <set>

#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/check.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/library.h"

namespace plume {
namespace {

TEST(ShippedPresets, ReadWithoutDiagnostics) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const PresetKind kind : {PresetKind::kEffect, PresetKind::kScene, PresetKind::kReplay}) {
    EXPECT_FALSE(library.ids(kind).empty()) << "no presets of kind " << static_cast<int>(kind);
    for (const std::string& id : library.ids(kind))
      for (const Diagnostic& diagnostic : check_file(library.find(kind, id)))
        ADD_FAILURE() << to_string(diagnostic);
  }
}

/// Particles of an emitter that live at a tick since its call, however short their lives turn out.
uint64_t living_at_least(const Spawn& spawn, uint32_t tick) {
  const SpawnSchedule schedule(spawn);
  const uint32_t shortest = spawn.life_ticks.min;
  return schedule.births(tick) - (tick < shortest ? 0 : schedule.births(tick - shortest));
}

TEST(ShippedPresets, EverythingIsTwentyFourInstancesOfEveryEffectAndTwoHundredThousandParticles) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  const Scene scene = library.scene("everything");
  EXPECT_EQ(scene.instances.size(), 24u);
  uint64_t living = 0;
  std::set<std::string> effects;
  for (const Instance& instance : scene.instances) {
    effects.insert(instance.effect);
    ASSERT_TRUE(instance.call_tick && *instance.call_tick <= scene.default_tick) << instance.name;
    uint64_t of_instance = 0;
    for (const Emitter& emitter : library.effect(instance.effect).emitters)
      of_instance += living_at_least(emitter.spawn, scene.default_tick - *instance.call_tick);
    EXPECT_GT(of_instance, 0u) << instance.name;
    living += of_instance;
  }
  EXPECT_GE(living, 200'000u);
  for (const std::string& id : library.ids(PresetKind::kEffect)) EXPECT_TRUE(effects.contains(id)) << id;
}

}  // namespace
}  // namespace plume
