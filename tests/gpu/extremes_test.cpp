// Whatever number a file gives for a key: it is refused by name and range, at its place, or what comes of it
// is finite.
#include <filesystem>
#include <fstream>
#include <regex>

#include "sandbox/effects/bounds.h"
#include "sandbox/presets/read_effect.h"
#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

/// A number in a file, and the key that it belongs to.
struct Number {
  std::string key;
  size_t at, length;
  uint32_t line, column;
};

std::string text_of(const std::string& name) {
  std::ifstream in(std::filesystem::path(PLUME_SOURCE_TESTS) / "extremes" / name);
  return {std::istreambuf_iterator<char>(in), {}};
}

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

struct Reading {
  std::optional<Effect> effect;
  std::vector<Diagnostic> mistakes;
};

class ExtremesTest : public MovingParticles {
 protected:
  Reading read(const std::string& text) const {
    try {
      Effect effect =
          read_effect_text(text, std::string(PLUME_SOURCE_PRESETS) + "/effects/every_key.toml");
      for (const MeshName& name : mesh_names(effect)) effect.meshes.push_back(library.mesh(name.id));
      return {std::move(effect), {}};
    } catch (const FileErrors& errors) {
      return {{}, errors.diagnostics()};
    }
  }
};

TEST_F(ExtremesTest, MeasureEverything) {
  const std::string text = text_of("every_key.toml");
  const Reading whole = read(text);
  for (const Diagnostic& d : whole.mistakes) ADD_FAILURE() << to_string(d);
  ASSERT_TRUE(whole.effect);
  int refused = 0;
  const std::regex range("from (-?[0-9.e+]+) to (-?[0-9.e+]+)");
  std::vector<std::pair<std::string, Effect>> accepted;
  for (const Number& number : numbers_of(text)) {
    std::vector<std::string> values{"nan", "inf", "-inf", "1e30", "-1e30", "1e-30", "-1", "0", "1000000", "4000000"};
    std::vector<std::string> limits;
    for (size_t i = 0; i < values.size() + limits.size(); ++i) {
      const std::string value = i < values.size() ? values[i] : limits[i - values.size()];
      const std::string what = std::to_string(number.line) + ": " + number.key + " = " + value;
      SCOPED_TRACE(what);
      Reading reading = read(with(text, number, value));
      if (reading.effect) {
        EXPECT_TRUE(i > 2) << "what is not finite is no number";
        accepted.emplace_back(what, std::move(*reading.effect));
        continue;
      }
      ++refused;
      const Diagnostic& mistake = reading.mistakes.at(0);
      EXPECT_EQ(mistake.line, number.line) << to_string(mistake);
      EXPECT_LE(mistake.column, number.column) << to_string(mistake);
      EXPECT_TRUE(mistake.message.find("expected") != std::string::npos || mistake.message.find("lower") != std::string::npos) << to_string(mistake);
      std::smatch match;
      if (limits.empty() && std::regex_search(mistake.message, match, range))
        for (int end : {1, 2}) limits.push_back(match[end]);
      if (i > 2 && std::getenv("EXTREMES_PRINT")) std::printf("%s -> %s\n", what.c_str(), to_string(mistake).c_str());
    }
  }
  std::printf("%d refused, %zu accepted\n", refused, accepted.size());
  const std::vector<Solid> solids{{.kind = SolidKind::kPlane, .position = {0, -1, 0}, .size_m = {40, 0, 40}},
                                  {.kind = SolidKind::kBox, .position = {2, 0, 0}}};
  const Path path({{0, {0, 0, 0}}, {20, {3, 1, 0}}});
  for (size_t first = 0; first < accepted.size(); first += 100) {
    std::vector<Call> calls;
    for (size_t i = first; i < std::min(first + 100, accepted.size()); ++i) {
      Placement placement{.path = &path, .wind = {1, 0, 0}, .solids = &solids};
      for (const Bounds& b : emitter_bounds(accepted[i].second, placement))
        EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(b.min), glm::vec3(3e38f))) && glm::all(glm::lessThan(glm::abs(b.max), glm::vec3(3e38f)))) << accepted[i].first;
    }
  }
}

}  // namespace
}  // namespace plume
