#include "sandbox/presets/read_parent.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "renderer/parameters.h"
#include "sandbox/effects/lineage.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/read_effect.h"
#include "shaders/shared/particle.h"

namespace plume {
namespace {

constexpr std::string_view kEvents[] = {"birth", "life", "death", "collision"};
constexpr Limits kChildren{1, 10'000, "particles"};
constexpr Limits kAge{0, kMaxLife, "ticks"};

uint32_t generation_of(const std::vector<Emitter>& emitters, const Emitter& emitter) {
  return emitter.parent ? 1 + generation_of(emitters, emitters[emitter.parent->index]) : 0;
}

}  // namespace

std::optional<Parent> read_parent(TableReader& table, const std::vector<Emitter>& earlier) {
  Parent out;
  const bool named = table.text("emitter", out.emitter, Need::kRequired);
  std::vector<std::string> names;
  for (const Emitter& emitter : earlier) names.push_back(emitter.name);
  table.offer("emitter", names, "emitter.name");
  const bool known = table.choice("on", out.event, kEvents, Need::kRequired);
  const auto on = [&](BirthEvent event) { return !known || out.event == event; };
  if (!known || out.event != BirthEvent::kLife) table.integer("count", out.count, kChildren);
  if (on(BirthEvent::kCollision))
    table.integer("collisions", out.collisions,
                  {1, double(shared::kMostCollisions / shared::kOneCollision), "collisions"});
  if (on(BirthEvent::kLife)) {
    table.integer("every_ticks", out.every_ticks, {1, kAge.max, kAge.unit});
    table.integer("first_tick", out.first_tick, kAge);
  }
  table.number("inherit_velocity", out.inherit_velocity, {-10, 10});
  if (!named) return {};

  const auto parent = std::ranges::find(earlier, out.emitter, &Emitter::name);
  if (parent == earlier.end()) {
    table.report("emitter", names.empty()
                                ? fmt::format("there is no emitter before this one, expected \"{}\" "
                                              "to stand earlier in the file",
                                              out.emitter)
                                : fmt::format("no emitter \"{}\" before this one, {}", out.emitter,
                                              suggestion(out.emitter, names)));
    return {};
  }
  out.index = uint32_t(parent - earlier.begin());
  if (generation_of(earlier, *parent) >= kMostGenerations) {
    table.report("emitter",
                 fmt::format("\"{}\" is itself a child of a child, expected at most {} generations "
                             "below an emitter with a rate",
                             out.emitter, kMostGenerations));
    return {};
  }
  if (out.event == BirthEvent::kCollision && !parent->motion.collision) {
    table.report("on", fmt::format("\"{}\" does not collide, expected it to have [emitter.motion.collision]",
                                   out.emitter));
    return {};
  }
  if (out.event == BirthEvent::kLife && out.children(parent->spawn.life_ticks.max) == 0) {
    table.report("first_tick",
                 fmt::format("`first_tick` is {}, expected less than the longest life of \"{}\", {}",
                             out.first_tick, out.emitter, parent->spawn.life_ticks.max));
    return {};
  }
  return known ? std::optional(out) : std::nullopt;
}

void read_spawn_of_child(TableReader& spawn, const std::vector<Emitter>& earlier, Emitter& child) {
  if (!spawn.range("life", child.spawn.life_ticks, {1, kMaxLife, "ticks"}, Need::kRequired)) return;
  std::vector<Emitter> emitters = earlier;
  emitters.push_back(child);
  const Lineage lineage = lineage_of(emitters, uint32_t(earlier.size()));
  try {
    const SpawnSchedule schedule(lineage.spawn, {.per_root = lineage.per_root, .life = lineage.life});
    if (schedule.capacity() > kMaxAlive)
      spawn.report("life",
                   fmt::format("there are {} children at once, expected at most {}: lower `life`, what "
                               "the parents bear or how many they are",
                               schedule.capacity(), kMaxAlive));
  } catch (const std::overflow_error& error) {
    spawn.report("life", error.what());
  }
}

}  // namespace plume
