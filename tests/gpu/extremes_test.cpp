// Whatever number a file gives for a key: it is refused by name and range, at its place, or what comes of it
// is finite. The files in tests/extremes hold every key of an effect with a number, once at least.
#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "sandbox/effects/bounds.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/scene/view.h"
#include "tests/gpu/finite.h"
#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

using namespace std::literals;

/// A number in a file, and the key that it belongs to.
struct Number {
  std::string key;
  size_t at, length;
  uint32_t line, column;
};

std::vector<Number> numbers_of(const std::string& text) {
  std::vector<Number> numbers;
  const std::regex number("-?[0-9][0-9.]*"), key("^ *([a-z_0-9]+) = ");
  uint32_t line = 1;
  for (size_t start = 0; start < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', start), text.size());
    const std::string row = text.substr(start, end - start);
    std::smatch match;
    if (std::regex_search(row, match, key) && row.find('"') == row.npos) {
      const size_t values = size_t(match.length(0));
      for (auto it = std::sregex_iterator(row.begin() + long(values), row.end(), number);
           it != std::sregex_iterator(); ++it) {
        const size_t at = values + size_t(it->position());
        numbers.push_back({match[1], start + at, size_t(it->length()), line, uint32_t(at + 1)});
      }
    }
    start = end + 1;
  }
  return numbers;
}

std::string with(const std::string& text, const Number& number, const std::string& value) {
  return std::string(text).replace(number.at, number.length, value);
}

/// What a file says besides what one would.
struct Trial {
  std::string what;  // "29: drag = 1000"
  Effect effect;
};

class ExtremesTest : public MovingParticles {
 protected:
  Effect read(const std::string& text) const {
    Effect effect = read_effect_text(text, std::string(PLUME_SOURCE_PRESETS) + "/effects/extreme.toml");
    for (const MeshName& name : mesh_names(effect)) effect.meshes.push_back(library.mesh(name.id));
    return effect;
  }

  /// Puts no number, and numbers that are too large, too small, and as large and small as the reader says it
  /// takes, in the place of each number of the file. Returns what the reader takes.
  std::vector<Trial> trials(const std::string& text) const {
    std::vector<Trial> taken;
    for (const Number& number : numbers_of(text)) {
      std::vector<std::string> values{"-1e30", "1e30", "-1", "0", "nan", "inf", "-inf", "\"1\"", "[[1]]"};
      bool limits_are_known = false;
      for (size_t i = 0; i < values.size(); ++i) {
        const std::string what = fmt::format("{}: {} = {}", number.line, number.key, values[i]);
        SCOPED_TRACE(what);
        try {
          taken.push_back({what, read(with(text, number, values[i]))});
          EXPECT_TRUE(i == 2 || i == 3 || i >= 9) << "taken";
        } catch (const FileErrors& errors) {
          const Diagnostic& mistake = errors.diagnostics().front();
          if (i < 9) {  // within its limits a number may contradict others, at their place
            EXPECT_EQ(mistake.line, number.line) << to_string(mistake);
          }
          EXPECT_NE(mistake.message.find("expected"), std::string::npos) << to_string(mistake);
          std::smatch match;
          if (limits_are_known || !std::regex_search(mistake.message, match, limits)) continue;
          limits_are_known = true;
          for (const int end : {1, 2}) values.push_back(match[end]);
        }
      }
      EXPECT_TRUE(limits_are_known) << number.line << ": " << number.key << " has no limits";
    }
    return taken;
  }

  /// Its particles are many, and no more extreme than a few of them would be.
  static bool is_large(const Effect& effect) {
    for (uint32_t i = 0; i < effect.emitters.size(); ++i) {
      const Lineage lineage = lineage_of(effect.emitters, i);
      if (SpawnSchedule(lineage.spawn, {.per_root = lineage.per_root, .life = lineage.life}).capacity() > 400)
        return true;
    }
    return false;
  }

  /// As many of the numbers as can be together are as large, or as small, as the reader takes them.
  Effect all_at_once(std::string text, bool largest) const {
    auto numbers = numbers_of(text);
    std::ranges::reverse(numbers);  // so that the places of those to come stay
    for (const Number& number : numbers) try {
        read(with(text, number, largest ? "1e30" : "-1e30"));
      } catch (const FileErrors& errors) {
        std::smatch match;
        const std::string message = errors.diagnostics().front().message;
        if (!std::regex_search(message, match, limits)) continue;
        const std::string changed = with(text, number, match[largest ? 2 : 1]);
        try {
          if (!is_large(read(changed))) text = changed;
        } catch (const FileErrors&) {
          // It would contradict others.
        }
      }
    return read(text);
  }

  /// Born on the way, among solids, in a wind.
  bool is_finite_at(std::span<const Trial> trials, uint32_t tick) {
    std::vector<Call> calls;
    for (const Trial& trial : trials)
      calls.push_back({.name = trial.what,
                       .effect = &trial.effect,
                       .tick = 0,
                       .position = {0.5f, 0.25f, -1.0f},
                       .path = path,
                       .yaw_deg = 30,
                       .seed = 1,
                       .layers = {}});
    Simulation simulation(device, pipelines, std::move(calls), 1, {1, 0, 0.5f}, solids);
    simulation.seek(tick);
    const gpu::Buffer view = gpu::Buffer(
        device, {.owner = "test", .label = "view", .bytes = sizeof(shared::ViewData), .host_visible = true});
    view.mapped<shared::ViewData>()[0] = make_view(Scene{}, CameraKey{}, {16, 16}, tick);
    const uint64_t bytes = (simulation.cards() + 1) * sizeof(shared::Card);
    const gpu::Buffer buffer(device, {.owner = "test", .label = "cards", .bytes = bytes});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, buffer, 0); });
    frame.finish();
    auto cards = gpu::read<shared::Card>(device, buffer);
    cards.resize(simulation.cards());
    return std::ranges::all_of(cards, [](const shared::Card& c) { return is_finite(c); }) &&
           std::ranges::all_of(simulation.particles(),
                               [](const shared::Particle& p) { return is_finite(p); });
  }

  const std::regex limits{"from ([-0-9.e+]+) to ([-0-9.e+]+)"};
  const Path path{{{0, {0, 0, 0}}, {20, {3, 1, 0}}}};
  const std::vector<Solid> solids{{.kind = SolidKind::kPlane, .position = {0, -1, 0}, .size_m = {40, 0, 40}},
                                  {.kind = SolidKind::kBox, .position = {2, 0, 0}}};
};

class EveryNumberOf : public ExtremesTest, public testing::WithParamInterface<const char*> {};

TEST_P(EveryNumberOf, IsRefusedByNameAndPlaceOrFinite) {
  const std::string text =
      load_text(std::filesystem::path(PLUME_SOURCE_TESTS) / "extremes" / fmt::format("{}.toml", GetParam()));
  std::vector<Trial> all = trials(text);
  for (const char* end : {"largest", "smallest"}) all.push_back({end, all_at_once(text, end == "largest"sv)});
  for (const Trial& trial : all)
    for (const Bounds& bounds : emitter_bounds(
             trial.effect, {.position = {}, .path = &path, .wind = {1, 0, 0.5f}, .solids = &solids}))
      EXPECT_TRUE(is_finite(bounds.min) && is_finite(bounds.max)) << trial.what;
  std::erase_if(all, [](const Trial& trial) { return is_large(trial.effect); });
  EXPECT_GT(all.size(), 10u);
  for (const uint32_t tick : {1u, 15u}) {
    if (is_finite_at(all, tick)) continue;
    for (const Trial& trial : all)
      EXPECT_TRUE(is_finite_at({&trial, 1}, tick)) << trial.what << ", tick " << tick;
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryNumberOf,
                         testing::Values("smoke", "haze", "cone", "ring", "shards", "children"),
                         [](const auto& file) { return std::string(file.param); });

}  // namespace
}  // namespace plume
