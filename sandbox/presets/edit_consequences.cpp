#include "sandbox/presets/edit_consequences.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "sandbox/presets/field_help.h"
#include "sandbox/presets/field_toml.h"
#include "sandbox/presets/toml_edit.h"
#include "sandbox/presets/toml_layout.h"
#include "sandbox/presets/value_path.h"

namespace plume {
namespace {

constexpr int kMostRounds = 16;  // tables bring tables; presets nest 4 deep

bool is_at_or_in(std::string_view path, std::string_view outer) {
  return path.starts_with(outer) &&
         (path.size() == outer.size() || path[outer.size()] == '.' || path[outer.size()] == '[');
}

bool is_group(const Field& field) {
  return std::holds_alternative<Group>(field.value) || std::holds_alternative<Groups>(field.value);
}

/// The default, within the limits.
FieldValue nearest_allowed(const Field& field) {
  const auto fit = [&](auto number) {
    using Number = decltype(number);
    return static_cast<Number>(std::clamp(double(number), field.limits.min, field.limits.max));
  };
  FieldValue value = field.fallback;
  if (auto* number = std::get_if<float>(&value)) *number = fit(*number);
  if (auto* number = std::get_if<double>(&value)) *number = fit(*number);
  if (auto* number = std::get_if<int64_t>(&value)) *number = fit(*number);
  const std::vector<std::string>& options = field.options;
  if (auto* text = std::get_if<std::string>(&value); text && !options.empty())
    if (std::ranges::find(options, *text) == options.end()) *text = options[0];
  if (auto* texts = std::get_if<Texts>(&value); texts && !options.empty()) *texts = {options[0]};
  return value;
}

/// `name`, or with the first number from 2 that no field of the same kind has.
std::string unused(std::string_view name, const Field& field, const std::vector<Field>& fields) {
  const std::string pattern = pattern_of(field.path);
  const auto is_used = [&](const std::string& candidate) {
    return std::ranges::any_of(fields, [&](const Field& other) {
      const auto* text = std::get_if<std::string>(&other.value);
      return text && other.present() && *text == candidate && pattern_of(other.path) == pattern;
    });
  };
  std::string candidate(name);
  for (int number = 2; is_used(candidate); ++number) candidate = fmt::format("{} {}", name, number);
  return candidate;
}

TomlValue initial_value(const Field& field, const std::vector<Field>& fields) {
  const FieldHelp* help = field_help(field.path);
  const bool names_itself = std::holds_alternative<std::string>(field.value) && field.options.empty();
  if (names_itself) return {unused(help && !help->initial.empty() ? help->initial : "new", field, fields)};
  if (help && !help->initial.empty()) return {TomlValue::Verbatim{std::string(help->initial)}};
  return to_toml_value(field, nearest_allowed(field));
}

std::string with_initial(std::string text, const Field& field, const std::vector<Field>& fields) {
  std::vector<Step> path = parse_path(field.path);
  if (std::holds_alternative<Groups>(field.value)) path.back().index = 0;
  if (is_group(field)) return with_table(text, path);
  return with_value(text, path, initial_value(field, fields));
}

bool has_rival(const Field& field, const std::vector<Field>& fields) {
  return std::ranges::any_of(field.rivals, [&](const std::string& path) {
    const Field* rival = find_field(fields, path);
    return rival && rival->present();
  });
}

/// One round; nothing when there is nothing left to do.
std::optional<std::string> next(const std::string& text, std::string_view path,
                                const std::vector<Field>& before, const std::vector<Field>& now) {
  if (const Field* set = find_field(now, path); set && set->present())
    for (const std::string& rival : set->rivals)
      if (const Field* field = find_field(now, rival); field && field->present())
        return without(text, parse_path(rival));

  const TomlLayout layout(text);
  for (const Field& field : before) {
    if (!field.present() || is_at_or_in(path, field.path) || find_field(now, field.path)) continue;
    const std::vector<Step> steps = parse_path(field.path);
    if (layout.find(steps)) return without(text, steps);
  }
  for (const Field& field : now) {
    if (field.present() || field.in_absent_table) continue;
    const Field* was = find_field(before, field.path);
    const bool asked_before = was && !was->in_absent_table;
    const FieldHelp* help = field_help(field.path);
    const bool wanted = field.required ? !(asked_before && was->required && !was->present())
                                       : help && help->from_start && !asked_before && !has_rival(field, now);
    // What was removed on purpose stays away unless it must be there, which then is the mistake to show.
    if (wanted && field.path != path) return with_initial(text, field, now);
  }
  return {};
}

/// Renames what repeats the name at `path`.
std::string with_names_followed(std::string text, std::string_view path, const std::vector<Field>& before,
                                const std::vector<Field>& now) {
  const Field *was = find_field(before, path), *is = find_field(now, path);
  if (!was || !is || !was->present() || !is->present()) return text;
  const auto *old_name = std::get_if<std::string>(&was->value), *name = std::get_if<std::string>(&is->value);
  if (!old_name || !name || *old_name == *name) return text;
  const std::string pattern = pattern_of(path);
  for (const Field& field : now)
    if (field.names == pattern && field.present() && field.value.index() == is->value.index() &&
        std::get<std::string>(field.value) == *old_name)
      text = with_value(text, parse_path(field.path), {*name});
  return text;
}

}  // namespace

const Field* find_field(const std::vector<Field>& fields, std::string_view path) {
  const auto field = std::ranges::find(fields, path, &Field::path);
  return field == fields.end() ? nullptr : &*field;
}

std::string with_consequences(std::string text, std::string_view path, const std::vector<Field>& before,
                              const Describe& describe) {
  text = with_names_followed(std::move(text), path, before, describe(text));
  for (int round = 0; round < kMostRounds; ++round) {
    std::optional<std::string> better = next(text, path, before, describe(text));
    if (!better) break;
    text = *std::move(better);
  }
  return text;
}

}  // namespace plume
