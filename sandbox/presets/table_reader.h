// Reads typed values out of a TOML document. A mistake is recorded and reading goes on, so one pass finds
// them all; every message says what would be right. A key that nobody asked for is a mistake, so nothing a
// user writes is ignored. What is asked for can be noted in a list of fields, for editors; tables that are
// absent are then read as empty ones besides, so that the list has what could stand in them.
#ifndef PLUME_PRESETS_TABLE_READER_H
#define PLUME_PRESETS_TABLE_READER_H

// Header-only, because Debian's shared library was built without the two settings below.
#define TOML_HEADER_ONLY 1
// Presets nest 4 deep; the parser recurses on values and on destruction.
#define TOML_MAX_NESTED_VALUES 16
// toml++ 3.3 asserts, or with NDEBUG assumes, that a key follows "[["; on "[[#" that is an abort or undefined
// behaviour. Without the assertion it reports a syntax error.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/field.h"
#include "sandbox/presets/preset_file.h"

namespace plume {

/// One key of a table whose keys are not known in advance, its value as text.
struct Setting {
  std::string key, value;
  toml::source_position position;
};

/// A table being read. A reading function leaves `value` as it is when the key is absent or wrong, and
/// returns whether it was read. Readers of sub-tables exist only inside the callback that receives them.
class TableReader {
 public:
  /// The top table of a file.
  TableReader(const toml::table& table, std::string file, std::vector<Diagnostic>& found,
              std::vector<Field>* fields = nullptr);

  bool has(std::string_view key) const { return table_.contains(key); }
  std::vector<std::string> keys() const;
  bool is_array(std::string_view key) const;
  bool is_table(std::string_view key) const;

  bool number(std::string_view key, float& value, Limits limits, Need need = Need::kOptional);
  bool number(std::string_view key, double& value, Limits limits, Need need = Need::kOptional);
  bool integer(std::string_view key, int& value, Limits limits, Need need = Need::kOptional);
  bool integer(std::string_view key, uint32_t& value, Limits limits, Need need = Need::kOptional);
  bool toggle(std::string_view key, bool& value);
  bool text(std::string_view key, std::string& value, Need need = Need::kOptional);
  /// One non-empty text or a list of them, at least one and at most `most`.
  bool texts(std::string_view key, std::vector<std::string>& value, size_t most, Need need = Need::kOptional);
  /// Index into `names`.
  bool choice(std::string_view key, uint32_t& value, std::span<const std::string_view> names,
              Need need = Need::kOptional);
  /// `names` in the order of the enumerators, which count from 0.
  template <class Enum>
  bool choice(std::string_view key, Enum& value, std::span<const std::string_view> names,
              Need need = Need::kOptional) {
    uint32_t index = static_cast<uint32_t>(value);
    const bool read = choice(key, index, names, need);
    value = static_cast<Enum>(index);
    return read;
  }
  bool vector(std::string_view key, glm::vec2& value, Limits limits, Need need = Need::kOptional);
  bool vector(std::string_view key, glm::vec3& value, Limits limits, Need need = Need::kOptional);
  bool size(std::string_view key, glm::uvec2& value, Limits limits);
  /// One [width, height] or a list of them, at least one and at most `most`. No editor shows it.
  bool sizes(std::string_view key, std::vector<glm::uvec2>& value, size_t most, Limits limits);
  bool range(std::string_view key, Range<float>& value, Limits limits, Need need = Need::kOptional);
  bool range(std::string_view key, Range<uint32_t>& value, Limits limits, Need need = Need::kOptional);
  /// A number or [[at, value], …], where a key may go on with its slope, or those before and after it.
  bool curve(std::string_view key, Curve& value, Limits limits);
  /// [r, g, b] or [[at, [r, g, b]], …].
  bool gradient(std::string_view key, Gradient& value, Limits limits);
  /// Integers that ascend strictly.
  bool ascending(std::string_view key, std::vector<uint32_t>& value, Limits limits, size_t at_least = 0);
  /// [[first, second], …] where the first column ascends strictly.
  bool pairs(std::string_view key, const Column& first, const Column& second, size_t at_least, Pairs& value);
  /// [[first, second], …] of whole numbers in any order; no field is noted.
  bool whole_pairs(std::string_view key, const Column& first, const Column& second,
                   std::vector<glm::uvec2>& value);
  /// [[first, [x, y, z]], …] where the first column ascends strictly; the second column's name is `[x, y,
  /// z]`.
  struct Length {
    size_t at_least = 1, at_most = SIZE_MAX;
  };
  bool points(std::string_view key, const Column& first, const Column& second, Length length, Points& value);
  using Read = ReadTable;
  bool table(std::string_view key, const Read& read, Need need = Need::kOptional);
  /// [[key]] tables; a single [key] counts as one. Calls `read` for each, in order.
  void tables(std::string_view key, size_t at_most, const Read& read, Need need = Need::kOptional);
  /// Every key not asked for so far; each must be a number, a bool or a string, or of `several` a list of
  /// them, which gives a setting each.
  enum class Values { kOne, kSeveral };
  std::vector<Setting> settings(Values values = Values::kOne);

  /// Notes that a text is one of `names`, and what it names (see Field::names).
  void offer(std::string_view key, std::vector<std::string> names, std::string_view what);
  /// Notes that a number could be pairs as well, or pairs a number.
  void also_pairs(std::string_view key, const Column& first, const Column& second, size_t at_least);
  void also_number(std::string_view key, Limits limits);
  /// Notes that these do not stand beside each other, which the caller reports in its own words.
  void rivals(std::string_view key, std::string_view other);
  /// Reports unless one of two keys is given, and not both.
  void exactly_one(std::string_view key, std::string_view other);

  /// Records a mistake at the value of `key`, or at the table when it has no such key.
  void report(std::string_view key, std::string message);
  void report(toml::source_position position, std::string message);
  toml::source_position position(std::string_view key) const;
  size_t mistakes() const { return found_.size(); }
  const std::string& file() const { return file_; }

 private:
  friend void read_noting(std::string_view text, const std::string& file, const Read& read,
                          std::vector<Field>* fields);  // preset_file.cpp
  TableReader(const TableReader& outer, const toml::table& table, std::string name, std::string path,
              std::vector<Diagnostic>& found);
  void read_inside(const toml::table& table, std::string name, std::string path, const Read& read);
  void imagine_inside(std::string path, const Read& read);
  std::string path_of(std::string_view key) const;
  Field* noted(std::string_view key);
  template <class Value>
  class Note;
  const toml::node* find(std::string_view key, Need need, const std::string& expected);
  void wrong(std::string_view key, const toml::node& node, const std::string& expected);
  bool read_number(std::string_view key, const toml::node& node, Limits limits, bool whole, double& value);
  struct Row {
    std::array<double, 2> pair{};
    bool has_first = false, has_second = false;
  };
  Row read_row(std::string_view key, const toml::node& item, const Column& first, const Column& second);
  bool read_numbers(std::string_view key, const toml::node& node, Limits limits, bool whole,
                    std::span<double> values);
  bool ascends(const Column& column, const toml::node& node, double before, double value);
  bool read_points(std::string_view key, const Column& first, const Column& second, Length length,
                   Points& value);
  bool read_range(std::string_view key, Limits limits, bool whole, Need need, double& min, double& max);
  void reject_unknown_keys();

  const toml::table& table_;
  std::string name_;  // for messages, "" for the file itself
  std::string path_;  // "" for the file itself
  std::string file_;
  std::vector<Diagnostic>& found_;
  std::vector<Field>* fields_;
  bool absent_ = false;  // an empty table stands for one that is not there
  std::vector<std::string> known_;
};

}  // namespace plume
#endif
