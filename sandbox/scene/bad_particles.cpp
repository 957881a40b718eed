#include "sandbox/scene/bad_particles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plume {
namespace {

std::string moved_by(const Motion& motion, bool has_parent) {
  std::vector<std::string_view> causes;
  const auto name = [&](bool is_there, std::string_view cause) {
    if (is_there) causes.push_back(cause);
  };
  name(has_parent, "what it inherits of its parent");
  name(motion.gravity != 0.0f, "gravity");
  name(motion.buoyancy != 0.0f, "buoyancy");
  name(motion.curl.strength != 0.0f, "curl noise");
  name(motion.vortex.strength != 0.0f || motion.vortex.pull != 0.0f, "a vortex");
  name(motion.orbit != 0.0f, "orbit");
  name(!motion.attractors.empty(), "attractors");
  name(motion.field.has_value(), "a vector field");
  name(motion.collision.has_value(), "collisions");
  return causes.empty() ? "its velocity at birth" : fmt::format("{}", fmt::join(causes, ", "));
}

/// Of the effect and instance that own it.
std::string moved_by(const Stage& stage, const CardOwner& owner) {
  const auto& calls = stage.simulation().instances().calls;
  const auto& described =
      std::ranges::find(calls, owner.instance, [](const CallState& c) { return c.call.name; })->described();
  const Emitter& emitter = *std::ranges::find(described, owner.emitter, &Emitter::name);
  return moved_by(emitter.motion, emitter.parent.has_value());
}

}  // namespace

BadParticles bad_particles(const Stage& stage) {
  const shared::BadCards found = stage.bad_cards();
  if (found.count == 0) return {};
  BadParticles bad{.count = found.count, .first = owner_of(stage, found.first), .moved_by = ""};
  if (!bad.first->pane) bad.moved_by = moved_by(stage, *bad.first);
  return bad;
}

std::string to_text(const BadParticles& bad) {
  if (bad.count == 0) return "";
  return fmt::format("{} not finite, and left out; first: {}",
                     bad.count == 1 ? "1 particle is" : fmt::format("{} particles are", bad.count),
                     to_text(*bad.first));
}

std::string remedy(const BadParticles& bad) {
  if (!bad.first) return "";
  if (bad.first->pane)
    return "The numbers of panes are the scene's own: the driver miscalculates, compare another `--device`";
  return fmt::format(
      "Beyond a million kilometres counts as infinite: give `{}` in {}.toml drag, a shorter life or "
      "`[bounds]`. What can drive it there is {}; if that cannot, the driver miscalculates: compare another "
      "`--device`",
      bad.first->emitter, bad.first->effect, bad.moved_by);
}

nlohmann::json to_json(const BadParticles& bad) {
  nlohmann::json first = nullptr;
  if (bad.first && bad.first->pane)
    first = {{"pane", *bad.first->pane}};
  else if (bad.first)
    first = {{"effect", bad.first->effect},
             {"instance", bad.first->instance},
             {"emitter", bad.first->emitter},
             {"birth", bad.first->birth}};
  return {{"count", bad.count}, {"first", std::move(first)}};
}

}  // namespace plume
