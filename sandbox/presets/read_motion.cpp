#include "sandbox/presets/read_motion.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/parameters.h"
#include "sandbox/presets/read_field.h"

namespace plume {
namespace {

constexpr std::string_view kFieldUses[] = {"force", "velocity"};
constexpr std::string_view kKillKinds[] = {"box", "sphere", "plane"};
constexpr std::string_view kKillSides[] = {"inside", "outside"};
constexpr std::string_view kResponses[] = {"bounce", "slide", "die", "stick"};

constexpr size_t kMaxAttractors = 8, kMaxKillVolumes = 8;
constexpr Limits kSpeed{-1000, 1000, "m/s"};
constexpr Limits kAcceleration{-1000, 1000, "m/s^2"};
constexpr Limits kPlace{-1000, 1000, "m"};
constexpr Limits kWavelength{0.01, 1000, "m"};
constexpr Limits kDrift{-100, 100, "wavelengths a second"};

void read_attractor(TableReader& table, Attractor& out) {
  const bool line = table.has("from") || table.has("to");
  const Need ends = line ? Need::kRequired : Need::kOptional;
  if (table.vector("position", out.from_m, kPlace)) {
    out.to_m = out.from_m;
    if (line)
      table.report("position",
                   "`position` beside `from` and `to`, expected one point or the two ends of a line");
  }
  const bool from = table.vector("from", out.from_m, kPlace, ends);
  const bool to = table.vector("to", out.to_m, kPlace, ends);
  if (from && to && out.from_m == out.to_m)
    table.report("to", "`to` is the same as `from`, expected another point, or `position` alone");
  table.rivals("position", "from");
  table.rivals("position", "to");
  table.number("strength", out.strength, kAcceleration, Need::kRequired);
  table.number("radius_m", out.radius_m, {0.01, 1000, "m"});
}

void read_field_use(TableReader& table, const std::filesystem::path& fields, float drag, VectorField& out) {
  const bool named = table.text("file", out.id, Need::kRequired);
  std::vector<std::string> known;
  std::error_code absent;  // a folder that is not there holds nothing
  for (const auto& entry : std::filesystem::directory_iterator(fields, absent))
    if (entry.path().extension() == ".fga") known.push_back(entry.path().stem().string());
  std::ranges::sort(known);
  table.offer("file", known, "field");
  if (named) {
    if (!std::ranges::binary_search(known, out.id)) {
      table.report("file",
                   fmt::format("unknown vector field \"{}\" in {}, {}", out.id, fields.string(),
                               known.empty() ? "expected a file ID.fga there" : suggestion(out.id, known)));
    } else {
      try {
        out.grid = std::make_shared<FieldGrid>(read_field(fields / (out.id + ".fga")));
      } catch (const FileErrors& errors) {
        table.report("file", to_string(errors.diagnostics().front()));
      }
    }
  }
  const bool chosen = table.choice("as", out.use, kFieldUses, Need::kRequired);
  if (chosen && out.use == VectorField::Use::kVelocity && drag == 0.0f)
    table.report("as", "a field of velocities without `drag`, expected `drag` above 0: it pulls to them");
  table.number("strength", out.strength, {-1000, 1000});
  table.number("scale", out.scale, {0.001, 1000, "m per unit of the file"});
  table.vector("offset_m", out.offset_m, kPlace);
}

/// Asks only for what the kind uses, so that a key without effect is reported as unknown.
void read_kill_volume(TableReader& table, KillVolume& out) {
  using enum KillVolume::Kind;
  const bool known = table.choice("kind", out.kind, kKillKinds, Need::kRequired);
  const auto is = [&](KillVolume::Kind kind) { return !known || out.kind == kind; };
  const Need need = known ? Need::kRequired : Need::kOptional;
  const Limits extent{0.001, 10'000, "m"};
  table.vector("position", out.position_m, {-10'000, 10'000, "m"});
  if (is(kBox)) table.vector("size_m", out.size_m, extent, need);
  if (is(kSphere)) table.number("radius_m", out.radius_m, extent, need);
  if (is(kPlane)) table.vector("normal", out.normal, {-1000, 1000});
  // Below this, squaring would lose the direction.
  if (is(kPlane) && glm::length(out.normal) < 1e-6f)
    table.report("normal", "`normal` is zero, expected a direction away from where particles die");
  if (!known || out.kind != kPlane) {
    uint32_t side = 0;
    if (table.choice("where", side, kKillSides)) out.outside = side == 1;
  }
}

/// Asks only for what the response uses.
void read_collision(TableReader& table, Collision& out) {
  using enum CollisionResponse;
  const bool known = table.choice("response", out.response, kResponses, Need::kRequired);
  const bool goes_on = !known || out.response == kBounce || out.response == kSlide;
  if (!known || out.response == kBounce)
    table.number("bounce", out.bounce, {0, 1}, known ? Need::kRequired : Need::kOptional);
  if (goes_on) table.number("friction", out.friction, {0, 1});
  table.number("radius_m", out.radius_m, {0, 10, "m"});
  table.number("event_speed", out.event_speed, {0, 1000, "m/s"});
}

/// What moves without a state is moved by nothing else.
void read_analytic(TableReader& motion, Motion& out) {
  if (!motion.toggle("analytic", out.analytic) || !out.analytic) return;
  for (const char* key :
       {"buoyancy", "floor_y", "curl", "vortex", "orbit", "attractor", "field", "kill", "collision"})
    if (motion.has(key))
      motion.report(key, fmt::format("`{}` beside `analytic`, which gravity, drag and wind alone can be: "
                                     "expected one of the two",
                                     key));
}

}  // namespace

void read_motion(TableReader& motion, const std::filesystem::path& fields, Motion& out) {
  motion.range("speed", out.speed, kSpeed);
  motion.vector("velocity", out.velocity, kSpeed);
  motion.number("gravity", out.gravity, {-100, 100, "g"});
  motion.number("drag", out.drag, {0, 1000, "1/s"});
  motion.number("wind", out.wind, {0, 10});
  motion.number("buoyancy", out.buoyancy, kAcceleration);
  motion.number("cooling_s", out.cooling_s, {0.001, 3600, "s"});
  motion.number("floor_y", out.floor_y, {-10'000, 10'000, "m"});
  motion.table("curl", [&](TableReader& curl) {
    curl.number("strength", out.curl.strength, {0, 1000, "m/s^2"}, Need::kRequired);
    curl.number("scale_m", out.curl.scale_m, kWavelength);
    curl.number("speed", out.curl.speed, kDrift);
    curl.integer("octaves", out.curl.octaves, {1, 3});
  });
  motion.table("vortex", [&](TableReader& vortex) {
    vortex.number("strength", out.vortex.strength, kAcceleration, Need::kRequired);
    vortex.number("radius_m", out.vortex.radius_m, {0.01, 1000, "m"});
    vortex.number("pull", out.vortex.pull, kAcceleration);
  });
  motion.number("orbit", out.orbit, {-30, 30, "revolutions a second"});
  motion.tables("attractor", kMaxAttractors,
                [&](TableReader& attractor) { read_attractor(attractor, out.attractors.emplace_back()); });
  motion.table("field",
               [&](TableReader& field) { read_field_use(field, fields, out.drag, out.field.emplace()); });
  motion.tables("kill", kMaxKillVolumes,
                [&](TableReader& kill) { read_kill_volume(kill, out.kill.emplace_back()); });
  motion.table("collision",
               [&](TableReader& collision) { read_collision(collision, out.collision.emplace()); });
  motion.table("curl_displacement", [&](TableReader& curl) {
    Displacement& d = out.curl_displacement;
    curl.number("amplitude_m", d.amplitude_m, {0, 100, "m"}, Need::kRequired);
    curl.number("scale_m", d.scale_m, kWavelength);
    curl.number("speed", d.speed, kDrift);
    curl.integer("octaves", d.octaves, {1, 3});
    curl.number("grow_s", d.grow_s, {0, 600, "s"});
  });
  read_analytic(motion, out);
}

}  // namespace plume
