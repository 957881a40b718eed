#include "sandbox/presets/read_field.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/printable.h"

namespace plume {
namespace {

/// Numbers between commas and white space, with the place of each.
class NumberReader {
 public:
  NumberReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// `what()` names the number in messages.
  template <class What>
  double next(const What& what, Limits limits, bool whole = false) {
    skip_separators();
    const auto expected = [&] {
      return fmt::format("{}: a {}number from {} to {}", what(), whole ? "whole " : "", limits.min,
                         limits.max);
    };
    const size_t end = std::min(text_.find_first_of(", \t\r\n", at_), text_.size());
    if (at_ == end) fail("the file ends here", expected());
    const std::string_view word = text_.substr(at_, end - at_);
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    // Written so that NaN fails too.
    const bool fits = value >= limits.min && value <= limits.max && (!whole || value == std::floor(value));
    if (error != std::errc() || stop != word.data() + word.size() || !fits)
      fail(fmt::format("\"{}\" is no such number", printable(word, 20)), expected());
    at_ = end;
    return value;
  }

  template <class What>
  glm::vec3 next_vector(const What& what, Limits limits) {
    const double x = next(what, limits), y = next(what, limits), z = next(what, limits);
    return {x, y, z};
  }

  void expect_end() {
    skip_separators();
    if (at_ < text_.size()) fail("there are more numbers than the size says", "the end of the file");
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    uint32_t line = 1, column = 1;
    for (const char c : text_.substr(0, at_))
      if (c == '\n')
        ++line, column = 1;
      else
        ++column;
    throw FileErrors({{file_, line, column, fmt::format("{}, expected {}", found, expected)}});
  }

 private:
  void skip_separators() { at_ = std::min(text_.find_first_not_of(", \t\r\n", at_), text_.size()); }

  std::string_view text_;
  const std::string& file_;
  size_t at_ = 0;
};

}  // namespace

FieldGrid read_field_text(std::string_view text, const std::string& file) {
  NumberReader numbers(text, file);
  FieldGrid grid;
  for (int axis = 0; axis < 3; ++axis)
    grid.size[axis] = uint32_t(numbers.next([] { return "cells along a side"; }, {1, kMaxFieldCells}, true));
  const Limits corner{-10'000, 10'000};
  grid.low = numbers.next_vector([] { return "low corner of the bounds"; }, corner);
  for (int axis = 0; axis < 3; ++axis)
    grid.high[axis] =
        float(numbers.next([] { return "high corner of the bounds, 0.001 or more above the low one"; },
                           {double(grid.low[axis]) + 0.001, corner.max}));
  grid.cells.resize(size_t(grid.size.x) * grid.size.y * grid.size.z);
  for (size_t i = 0; i < grid.cells.size(); ++i)
    grid.cells[i] = numbers.next_vector(
        [&] { return fmt::format("vector {} of {}", i + 1, grid.cells.size()); }, {-10'000, 10'000});
  numbers.expect_end();
  return grid;
}

FieldGrid read_field(const std::filesystem::path& path) {
  return read_field_text(load_text(path), path.string());
}

}  // namespace plume
