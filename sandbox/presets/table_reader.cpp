#include "sandbox/presets/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/parameters.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/value_path.h"

namespace plume {
namespace {

std::string shown_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return '"' + printable(text->get()) + '"';
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = node.as_floating_point()) {
    const std::string text = fmt::format("{}", number->get());
    return text.find_first_of(".en") == text.npos ? text + ".0" : text;  // 2.0 is not the integer 2
  }
  if (const auto* toggle = node.as_boolean()) return toggle->get() ? "true" : "false";
  if (const auto* array = node.as_array())
    return array->size() == 1 ? std::string("a list of 1 value")
                              : fmt::format("a list of {} values", array->size());
  return node.is_table() ? "a table" : "a date or time";
}

std::string limits_text(Limits limits) {
  return fmt::format("from {} to {}{}{}", limits.min, limits.max, limits.unit.empty() ? "" : " ",
                     limits.unit);
}

std::string number_text(Limits limits, bool whole) {
  return (whole ? "a whole number " : "a number ") + limits_text(limits);
}

std::string list_text(size_t count, Limits limits, bool whole) {
  return fmt::format("a list of {} {} {}", count, whole ? "whole numbers" : "numbers", limits_text(limits));
}

toml::source_position start_of(const toml::node& node) {
  return node.source().begin;
}

}  // namespace

/// Notes a field now and, when its reading is over, what was read: `value()`.
template <class Value>
class TableReader::Note {
 public:
  Note(TableReader& reader, std::string_view key, Value value, Field field)
      : reader_(reader), value_(std::move(value)), mistakes_(reader.mistakes()), present_(reader.has(key)) {
    if (!reader.fields_) return;
    index_ = reader.fields_->size();
    field.path = reader.path_of(key);
    field.fallback = field.value = value_();
    field.in_absent_table = reader.absent_;
    reader.fields_->push_back(std::move(field));
  }
  ~Note() {
    if (!reader_.fields_ || !present_) return;
    Field& field = (*reader_.fields_)[index_];
    field.value = value_();
    field.state = reader_.mistakes() > mistakes_ ? Field::State::kWrong : Field::State::kRead;
  }
  Note(const Note&) = delete;
  Note& operator=(const Note&) = delete;

 private:
  TableReader& reader_;
  Value value_;
  size_t mistakes_, index_ = 0;
  bool present_;
};

namespace {

/// What a reader's caller holds, as a field has it.
template <class Value>
auto as_field(const Value& value) {
  return [&value]() -> FieldValue {
    if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, uint32_t>)
      return static_cast<int64_t>(value);
    else
      return value;
  };
}

}  // namespace

TableReader::TableReader(const toml::table& table, std::string file, std::vector<Diagnostic>& found,
                         std::vector<Field>* fields)
    : table_(table), file_(std::move(file)), found_(found), fields_(fields) {}

TableReader::TableReader(const TableReader& outer, const toml::table& table, std::string name,
                         std::string path, std::vector<Diagnostic>& found)
    : table_(table),
      name_(std::move(name)),
      path_(std::move(path)),
      file_(outer.file_),
      found_(found),
      fields_(outer.fields_),
      absent_(outer.absent_) {}

std::string TableReader::path_of(std::string_view key) const {
  return path_.empty() ? written_key(key) : path_ + "." + written_key(key);
}

Field* TableReader::noted(std::string_view key) {
  if (!fields_) return nullptr;
  const auto field = std::ranges::find(*fields_, path_of(key), &Field::path);
  return field == fields_->end() ? nullptr : &*field;
}

void TableReader::offer(std::string_view key, std::vector<std::string> names, std::string_view what) {
  if (Field* field = noted(key)) field->options = std::move(names), field->names = what;
}

void TableReader::also_pairs(std::string_view key, const Column& first, const Column& second,
                             size_t at_least) {
  if (Field* field = noted(key)) field->columns = {first, second}, field->at_least = at_least;
}

void TableReader::also_number(std::string_view key, Limits limits) {
  if (Field* field = noted(key)) field->limits = limits;
}

void TableReader::rivals(std::string_view key, std::string_view other) {
  Field *first = noted(key), *second = noted(other);
  if (!first || !second) return;
  first->rivals.push_back(second->path);
  second->rivals.push_back(first->path);
}

void TableReader::exactly_one(std::string_view key, std::string_view other) {
  rivals(key, other);
  if (has(key) != has(other)) return;
  if (Field* field = noted(other); field && !has(key)) field->required = true;
  report(other, fmt::format("{} of `{}` and `{}` given, expected exactly one of them",
                            has(key) ? "both" : "neither", key, other));
}

void TableReader::report(toml::source_position position, std::string message) {
  // Names and texts of the file are quoted in it.
  found_.push_back({file_, std::max(1u, position.line), std::max(1u, position.column),
                    printable(message, message.size())});
}

void TableReader::report(std::string_view key, std::string message) {
  report(position(key), std::move(message));
}

toml::source_position TableReader::position(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return start_of(node ? *node : static_cast<const toml::node&>(table_));
}

const toml::node* TableReader::find(std::string_view key, Need need, const std::string& expected) {
  known_.emplace_back(key);
  const toml::node* node = table_.get(key);
  if (!node && need == Need::kRequired)
    report(key, fmt::format("missing key `{}`{}, expected {}", key, name_.empty() ? "" : " in " + name_,
                            expected));
  return node;
}

void TableReader::wrong(std::string_view key, const toml::node& node, const std::string& expected) {
  report(start_of(node), fmt::format("`{}` is {}, expected {}", printable(key), shown_value(node), expected));
}

std::vector<std::string> TableReader::keys() const {
  std::vector<std::string> keys;
  for (auto&& [key, node] : table_) keys.emplace_back(key.str());
  return keys;
}

bool TableReader::is_array(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node && node->is_array();
}

bool TableReader::is_table(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node && node->is_table();
}

bool TableReader::read_number(std::string_view key, const toml::node& node, Limits limits, bool whole,
                              double& value) {
  double number = 0;
  if (const auto* integer = node.as_integer())
    number = static_cast<double>(integer->get());
  else if (const auto* real = node.as_floating_point(); real && !whole)
    number = real->get();
  else
    return wrong(key, node, number_text(limits, whole)), false;
  // Written so that NaN fails too.
  if (!(number >= limits.min && number <= limits.max))
    return wrong(key, node, number_text(limits, whole)), false;
  value = number;
  return true;
}

bool TableReader::read_numbers(std::string_view key, const toml::node& node, Limits limits, bool whole,
                               std::span<double> values) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != values.size())
    return wrong(key, node, list_text(values.size(), limits, whole)), false;
  bool read = true;
  for (size_t i = 0; i < values.size(); ++i) read &= read_number(key, (*array)[i], limits, whole, values[i]);
  return read;
}

bool TableReader::number(std::string_view key, double& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, number_text(limits, false));
  return node && read_number(key, *node, limits, false, value);
}

bool TableReader::number(std::string_view key, float& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, number_text(limits, false));
  double wide = 0;
  const bool read = node && read_number(key, *node, limits, false, wide);
  if (read) value = static_cast<float>(wide);
  return read;
}

bool TableReader::integer(std::string_view key, int& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, number_text(limits, true));
  double wide = 0;
  const bool read = node && read_number(key, *node, limits, true, wide);
  if (read) value = static_cast<int>(wide);
  return read;
}

bool TableReader::integer(std::string_view key, uint32_t& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, number_text(limits, true));
  double wide = 0;
  const bool read = node && read_number(key, *node, limits, true, wide);
  if (read) value = static_cast<uint32_t>(wide);
  return read;
}

bool TableReader::toggle(std::string_view key, bool& value) {
  const Note note(*this, key, as_field(value), {});
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const auto* toggle = node->as_boolean();
  if (!toggle) return wrong(key, *node, "true or false"), false;
  value = toggle->get();
  return true;
}

bool TableReader::text(std::string_view key, std::string& value, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired});
  const std::string expected = need == Need::kRequired ? "a non-empty text in quotes" : "a text in quotes";
  const toml::node* node = find(key, need, expected);
  if (!node) return false;
  const auto* text = node->as_string();
  if (!text || (need == Need::kRequired && text->get().empty())) return wrong(key, *node, expected), false;
  value = text->get();
  return true;
}

bool TableReader::texts(std::string_view key, std::vector<std::string>& value, size_t most, Need need) {
  const Note note(*this, key, as_field(value),
                  {.required = need == Need::kRequired, .at_least = 1, .at_most = most});
  const std::string expected = most == 1
                                   ? "a non-empty text in quotes"
                                   : fmt::format("a non-empty text in quotes, or a list of 1 to {}", most);
  const toml::node* node = find(key, need, expected);
  if (!node) return false;
  std::vector<std::string> found;
  const auto take = [&](const toml::node& one) {
    const auto* text = one.as_string();
    if (text && !text->get().empty()) found.push_back(text->get());
    return text && !text->get().empty();
  };
  const toml::array* list = most == 1 ? nullptr : node->as_array();
  const bool read =
      list ? !list->empty() && list->size() <= most && std::all_of(list->begin(), list->end(), take)
           : take(*node);
  if (!read) return wrong(key, *node, expected), false;
  value = std::move(found);
  return true;
}

bool TableReader::choice(std::string_view key, uint32_t& value, std::span<const std::string_view> names,
                         Need need) {
  const auto name_of = [&]() -> FieldValue { return std::string(names[value]); };
  const Note note(*this, key, name_of,
                  {.required = need == Need::kRequired, .options = {names.begin(), names.end()}});
  const std::string expected = fmt::format("one of \"{}\"", fmt::join(names, "\", \""));
  const toml::node* node = find(key, need, expected);
  if (!node) return false;
  const auto* text = node->as_string();
  const auto name = text ? std::ranges::find(names, text->get()) : names.end();
  if (name == names.end()) {
    const std::string near =
        text ? nearest(text->get(), std::vector<std::string>(names.begin(), names.end())) : std::string();
    wrong(key, *node, near.empty() ? expected : fmt::format("\"{}\" ({})", near, expected));
    return false;
  }
  value = static_cast<uint32_t>(name - names.begin());
  return true;
}

bool TableReader::vector(std::string_view key, glm::vec2& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, list_text(2, limits, false));
  std::array<double, 2> v{};
  const bool read = node && read_numbers(key, *node, limits, false, v);
  if (read) value = glm::vec2(v[0], v[1]);
  return read;
}

bool TableReader::vector(std::string_view key, glm::vec3& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  const toml::node* node = find(key, need, list_text(3, limits, false));
  std::array<double, 3> v{};
  const bool read = node && read_numbers(key, *node, limits, false, v);
  if (read) value = glm::vec3(v[0], v[1], v[2]);
  return read;
}

bool TableReader::size(std::string_view key, glm::uvec2& value, Limits limits) {
  const Note note(*this, key, as_field(value), {.limits = limits});
  const toml::node* node = find(key, Need::kOptional, "");
  std::array<double, 2> v{};
  const bool read = node && read_numbers(key, *node, limits, true, v);
  if (read) value = glm::uvec2(v[0], v[1]);
  return read;
}

bool TableReader::sizes(std::string_view key, std::vector<glm::uvec2>& value, size_t most, Limits limits) {
  const std::string expected = fmt::format("[width, height], or a list of 1 to {} of them", most);
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array || array->empty() || array->size() > most) return wrong(key, *node, expected), false;
  std::vector<glm::uvec2> list;
  const auto take = [&](const toml::node& one) {
    std::array<double, 2> v{};
    const bool read = read_numbers(key, one, limits, true, v);
    if (read) list.emplace_back(v[0], v[1]);
    return read;
  };
  bool read = true;
  if (!array->front().is_array())
    read = take(*node);
  else
    for (const toml::node& item : *array) read &= take(item);
  if (read) value = std::move(list);
  return read;
}

bool TableReader::read_range(std::string_view key, Limits limits, bool whole, Need need, double& min,
                             double& max) {
  const std::string expected = number_text(limits, whole) + ", or [min, max]";
  const toml::node* node = find(key, need, expected);
  if (!node) return false;
  if (!node->is_array()) {
    if (!node->is_number()) return wrong(key, *node, expected), false;
    const bool read = read_number(key, *node, limits, whole, min);
    max = min;
    return read;
  }
  std::array<double, 2> ends{};
  if (!read_numbers(key, *node, limits, whole, ends)) return false;
  if (ends[0] > ends[1]) {
    report(start_of(*node),
           fmt::format("`{0}` is [{1}, {2}], expected [min, max] with min at most max: [{2}, {1}]", key,
                       ends[0], ends[1]));
    return false;
  }
  min = ends[0], max = ends[1];
  return true;
}

bool TableReader::range(std::string_view key, Range<float>& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  double min = 0, max = 0;
  const bool read = read_range(key, limits, false, need, min, max);
  if (read) value = {static_cast<float>(min), static_cast<float>(max)};
  return read;
}

bool TableReader::range(std::string_view key, Range<uint32_t>& value, Limits limits, Need need) {
  const Note note(*this, key, as_field(value), {.required = need == Need::kRequired, .limits = limits});
  double min = 0, max = 0;
  const bool read = read_range(key, limits, true, need, min, max);
  if (read) value = {static_cast<uint32_t>(min), static_cast<uint32_t>(max)};
  return read;
}

bool TableReader::ascends(const Column& column, const toml::node& node, double before, double value) {
  // Curves keep floats, ticks are whole.
  if (column.whole ? value > before : static_cast<float>(value) > static_cast<float>(before)) return true;
  wrong(column.name, node, fmt::format("more than {}, the one before it", before));
  return false;
}

TableReader::Row TableReader::read_row(std::string_view key, const toml::node& item, const Column& first,
                                       const Column& second) {
  const toml::array* row = item.as_array();
  if (!row || row->size() != 2) {
    wrong(key, item, fmt::format("[{}, {}]", first.name, second.name));
    return {};
  }
  Row read;
  read.has_first = read_number(first.name, (*row)[0], first.limits, first.whole, read.pair[0]);
  read.has_second = read_number(second.name, (*row)[1], second.limits, second.whole, read.pair[1]);
  return read;
}

bool TableReader::pairs(std::string_view key, const Column& first, const Column& second, size_t at_least,
                        std::vector<std::array<double, 2>>& value) {
  const Note note(*this, key, as_field(value), {.columns = {first, second}, .at_least = at_least});
  const std::string expected =
      fmt::format("a list of at least {} [{}, {}]", at_least, first.name, second.name);
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array || array->size() < at_least) return wrong(key, *node, expected), false;
  std::vector<std::array<double, 2>> rows;
  bool read = true;
  for (const toml::node& item : *array) {
    const Row row = read_row(key, item, first, second);
    read &= row.has_first && row.has_second;
    if (!row.has_first) continue;
    if (!rows.empty()) read &= ascends(first, (*item.as_array())[0], rows.back()[0], row.pair[0]);
    rows.push_back(row.pair);
  }
  if (read) value = std::move(rows);
  return read;
}

bool TableReader::whole_pairs(std::string_view key, const Column& first, const Column& second,
                              std::vector<glm::uvec2>& value) {
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array) return wrong(key, *node, fmt::format("a list of [{}, {}]", first.name, second.name)), false;
  std::vector<glm::uvec2> rows;
  bool read = true;
  for (const toml::node& item : *array) {
    const Row row = read_row(key, item, first, second);
    read &= row.has_first && row.has_second;
    rows.emplace_back(row.pair[0], row.pair[1]);
  }
  if (read) value = std::move(rows);
  return read;
}

bool TableReader::points(std::string_view key, const Column& first, const Column& second, Length length,
                         Points& value) {
  const Note note(*this, key, as_field(value),
                  {.columns = {first, second}, .at_least = length.at_least, .at_most = length.at_most});
  return read_points(key, first, second, length, value);
}

bool TableReader::read_points(std::string_view key, const Column& first, const Column& second, Length length,
                              Points& value) {
  const std::string row_text = fmt::format("[{}, {}]", first.name, second.name);
  const std::string expected =
      length.at_most == SIZE_MAX
          ? fmt::format("a list of at least {} {}", length.at_least, row_text)
          : fmt::format("a list of {} to {} {}", length.at_least, length.at_most, row_text);
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array || array->size() < length.at_least || array->size() > length.at_most)
    return wrong(key, *node, expected), false;
  Points rows;
  bool read = true;
  for (const toml::node& item : *array) {
    const toml::array* row = item.as_array();
    if (!row || row->size() != 2) {
      wrong(key, item, row_text);
      read = false;
      continue;
    }
    double at = 0;
    std::array<double, 3> v{};
    const bool has_first = read_number(first.name, (*row)[0], first.limits, first.whole, at);
    read &= read_numbers(key, (*row)[1], second.limits, second.whole, v) && has_first;
    if (!has_first) continue;
    if (!rows.empty()) read &= ascends(first, (*row)[0], rows.back().first, at);
    rows.emplace_back(at, glm::vec3(v[0], v[1], v[2]));
  }
  if (read) value = std::move(rows);
  return read;
}

bool TableReader::curve(std::string_view key, Curve& value, Limits limits) {
  const Note note(*this, key, as_field(value), {.limits = limits});
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array) {
    double constant = 0;
    if (!node->is_number())
      return wrong(key, *node, number_text(limits, false) + ", or [[at, value], …]"), false;
    const bool read = read_number(key, *node, limits, false, constant);
    if (read) value = Curve(static_cast<float>(constant));
    return read;
  }
  if (array->empty()) return wrong(key, *node, "a list of at least 1 [at, value]"), false;
  const Column at{"at", {0, 1}};
  std::vector<Curve::Key> keys;
  bool read = true;
  for (const toml::node& item : *array) {
    const toml::array* row = item.as_array();
    if (!row || row->size() < 2 || row->size() > 4) {
      wrong(key, item, "[at, value], [at, value, slope] or [at, value, slope before, slope after]");
      read = false;
      continue;
    }
    std::array<double, 4> v{};
    const bool has_at = read_number("at", (*row)[0], at.limits, false, v[0]);
    read &= read_number("value", (*row)[1], limits, false, v[1]) && has_at;
    for (size_t i = 2; i < row->size(); ++i) read &= read_number("slope", (*row)[i], kSlope, false, v[i]);
    if (!has_at) continue;
    if (!keys.empty()) read &= ascends(at, (*row)[0], keys.back().at, v[0]);
    Curve::Key& next = keys.emplace_back(Curve::Key{static_cast<float>(v[0]), static_cast<float>(v[1])});
    if (row->size() > 2)
      next.in = static_cast<float>(v[2]), next.out = static_cast<float>(v.at(row->size() - 1));
  }
  if (!read) return false;
  Curve curve(std::move(keys));
  const auto [least, largest] = curve.extremes();
  const double slack = 1e-6 * (1 + std::abs(limits.min) + std::abs(limits.max));  // of rounding
  for (const Curve::Place& place : {least, largest}) {
    if (place.value >= limits.min - slack && place.value <= limits.max + slack) continue;
    report(start_of((*array)[place.key]),
           fmt::format(
               "`{}` swings to {:.4g} at {:.4g} of the life, expected {} between keys too: flatter slopes",
               key, place.value, place.at, limits_text(limits)));
    read = false;
  }
  if (read) value = std::move(curve);
  return read;
}

bool TableReader::gradient(std::string_view key, Gradient& value, Limits limits) {
  const Note note(*this, key, as_field(value), {.limits = limits});
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array || array->empty())
    return wrong(key, *node, "[r, g, b] or [[at, [r, g, b]], …] with colours " + limits_text(limits)), false;
  std::array<double, 3> rgb{};
  if (!array->front().is_array()) {
    if (!read_numbers(key, *node, limits, false, rgb)) return false;
    value = Gradient(glm::vec3(rgb[0], rgb[1], rgb[2]));
    return true;
  }
  Points rows;
  if (!read_points(key, {"at", {0, 1}}, {"[r, g, b]", limits}, {.at_least = 1}, rows)) return false;
  value.keys.clear();
  for (const auto& [at, color] : rows) value.keys.push_back({static_cast<float>(at), color});
  return true;
}

bool TableReader::ascending(std::string_view key, std::vector<uint32_t>& value, Limits limits,
                            size_t at_least) {
  const Note note(*this, key, as_field(value), {.limits = limits, .at_least = at_least});
  const toml::node* node = find(key, Need::kOptional, "");
  if (!node) return false;
  const toml::array* array = node->as_array();
  if (!array || array->size() < at_least)
    return wrong(key, *node,
                 fmt::format("a list of at least {} whole numbers {}", at_least, limits_text(limits))),
           false;
  std::vector<uint32_t> list;
  bool read = true;
  for (const toml::node& item : *array) {
    double number = 0;
    if (!read_number(key, item, limits, true, number)) {
      read = false;
      continue;
    }
    if (!list.empty() && number <= list.back()) {
      wrong(key, item, fmt::format("more than {}, the one before it", list.back()));
      read = false;
    }
    list.push_back(static_cast<uint32_t>(number));
  }
  if (read) value = std::move(list);
  return read;
}

void TableReader::read_inside(const toml::table& table, std::string name, std::string path,
                              const Read& read) {
  TableReader inner(*this, table, std::move(name), std::move(path), found_);
  read(inner);
  inner.reject_unknown_keys();
}

void TableReader::imagine_inside(std::string path, const Read& read) {
  const toml::table empty;
  std::vector<Diagnostic> unheard;
  TableReader inner(*this, empty, "", std::move(path), unheard);
  inner.absent_ = true;
  read(inner);
}

bool TableReader::table(std::string_view key, const Read& read, Need need) {
  const auto group = [] { return FieldValue(Group()); };
  const Note note(*this, key, group, {.required = need == Need::kRequired});
  const toml::node* node = find(key, need, fmt::format("a table [{}]", key));
  if (!node && fields_) imagine_inside(path_of(key), read);
  if (!node) return false;
  const toml::table* table = node->as_table();
  if (!table) return wrong(key, *node, fmt::format("a table [{}]", key)), false;
  read_inside(*table, fmt::format("[{}]", key), path_of(key), read);
  return true;
}

void TableReader::tables(std::string_view key, size_t at_most, const Read& read, Need need) {
  size_t count = 0;
  const auto groups = [&] { return FieldValue(Groups{count}); };
  const size_t at_least = need == Need::kRequired ? 1 : 0;
  const Note note(*this, key, groups, {.required = at_least > 0, .at_least = at_least, .at_most = at_most});
  const auto path_of_one = [&] { return fmt::format("{}[{}]", path_of(key), count); };
  const std::string expected =
      fmt::format("{} {} tables [[{}]]", at_least > 0 ? "1 to" : "at most", at_most, key);
  const toml::node* node = find(key, need, expected);
  if (!node) return;
  if (const toml::table* single = node->as_table()) {
    read_inside(*single, fmt::format("[{}]", key), path_of_one(), read);
    count = 1;
    return;
  }
  const toml::array* array = node->as_array();
  if (!array || array->size() > at_most || array->size() < at_least) {
    wrong(key, *node, expected);
    return;
  }
  for (const toml::node& item : *array) {
    const toml::table* table = item.as_table();
    if (table)
      read_inside(*table, fmt::format("[[{}]]", key), path_of_one(), read);
    else
      wrong(key, item, fmt::format("a table [[{}]]", key));
    ++count;
  }
}

std::vector<Setting> TableReader::settings(Values values) {
  std::vector<Setting> settings;
  const auto take = [&](std::string_view key, const toml::node& node, const char* expected) {
    const bool finite = !node.is_floating_point() || std::isfinite(node.as_floating_point()->get());
    if (!finite || !(node.is_number() || node.is_boolean() || node.is_string()))
      return wrong(printable(key), node, expected);
    std::string text = node.is_string() ? node.as_string()->get() : shown_value(node);
    settings.push_back({std::string(key), std::move(text), start_of(node)});
  };
  constexpr const char* kOne = "a finite number, true or false, or a text";
  for (auto&& [key, node] : table_) {
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    known_.emplace_back(key.str());
    const toml::array* list = values == Values::kSeveral ? node.as_array() : nullptr;
    if (!list)
      take(key.str(), node,
           values == Values::kSeveral ? "a finite number, true or false, a text, or a list of at least 1"
                                      : kOne);
    else if (list->empty())
      wrong(printable(key.str()), node, "a list of at least 1 value");
    else
      for (const toml::node& item : *list) take(key.str(), item, kOne);
  }
  return settings;
}

void TableReader::reject_unknown_keys() {
  for (auto&& [key, node] : table_) {
    if (std::ranges::find(known_, key.str()) != known_.end()) continue;
    report(key.source().begin,
           fmt::format("unknown key `{}`{}, {}", printable(key.str()), name_.empty() ? "" : " in " + name_,
                       suggestion(key.str(), known_)));
  }
}

}  // namespace plume
