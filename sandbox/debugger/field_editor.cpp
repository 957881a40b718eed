#include "sandbox/debugger/field_editor.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>

#include "sandbox/debugger/color_editor.h"
#include "sandbox/debugger/curve_editor.h"
#include "sandbox/debugger/gradient_editor.h"
#include "sandbox/debugger/number_editor.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/presets/field_help.h"
#include "sandbox/presets/value_path.h"

namespace plume {
namespace {

using Wanted = std::optional<FieldValue>;

constexpr float kLabelWidth = 8.5f;  // in lines of text

std::string_view table_of(std::string_view path) {
  const size_t dot = path.rfind('.');
  return dot == path.npos ? "" : path.substr(0, dot);
}

std::string_view name_of(std::string_view path) {
  const size_t dot = path.rfind('.');
  return dot == path.npos ? path : path.substr(dot + 1);
}

bool is_color(std::string_view name) {
  return name == "transmission" || name == "color" || name == "emission" || name == "zenith" ||
         name == "horizon" || name == "sun_color";
}

bool is_table(const Field& field) {
  return std::holds_alternative<Group>(field.value) || std::holds_alternative<Groups>(field.value);
}

std::string number_text(double number) {
  return fmt::format("{:.4g}", number);
}

/// Of a default, where it is short.
struct ShortText {
  std::string operator()(bool v) const { return v ? "on" : "off"; }
  std::string operator()(float v) const { return number_text(double(v)); }
  std::string operator()(double v) const { return number_text(v); }
  std::string operator()(int64_t v) const { return std::to_string(v); }
  std::string operator()(const std::string& v) const { return v; }
  std::string operator()(const Range<float>& v) const { return fmt::format("{:g} .. {:g}", v.min, v.max); }
  std::string operator()(const Range<uint32_t>& v) const { return fmt::format("{} .. {}", v.min, v.max); }
  std::string operator()(const glm::vec3& v) const { return fmt::format("{:g}, {:g}, {:g}", v.x, v.y, v.z); }
  std::string operator()(const Curve& v) const {
    return v.keys.size() == 1 ? number_text(double(v.keys[0].value)) : "";
  }
  std::string operator()(const Gradient& v) const {
    return v.keys.size() == 1 ? (*this)(v.keys[0].value) : "";
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

std::string value_text(const FieldValue& value) {
  return std::visit(ShortText{}, value);
}

std::string help_of(const Field& field) {
  const FieldHelp* words = field_help(field.path);
  std::string text(words ? words->tooltip : "");
  const bool has_limits = field.limits.max > field.limits.min;
  if (has_limits) text += "\n" + limits_text(field.limits.min, field.limits.max, field.limits.unit);
  for (const Column& column : field.columns)
    text += fmt::format("\n{}: {}", column.name,
                        limits_text(column.limits.min, column.limits.max, column.limits.unit));
  if (const std::string fallback = value_text(field.fallback); !field.required && !fallback.empty())
    text += fmt::format("\ndefault: {}", fallback);
  for (const std::string& rival : field.rivals)
    text += fmt::format("\ntakes the place of {}", name_of(rival));
  if (std::holds_alternative<Curve>(field.value) || std::holds_alternative<Gradient>(field.value))
    text += "\nDrag keys; a double click adds one, a right click takes one away.";
  return text;
}

/// Of the last widget.
void help(const Field& field) {
  if (wants_tooltip()) tooltip(help_of(field));
}

/// Starts a line: the name to the left, the next item to fill the rest, with room for a button. A name that
/// is too long has a line of its own.
void label(const Field& field, std::string_view name) {
  const float column = kLabelWidth * ImGui::GetFontSize();
  const float end = ImGui::GetCursorPosX() + ImGui::CalcTextSize(name.data(), name.data() + name.size()).x;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name.data(), name.data() + name.size());
  help(field);
  if (end < column)
    ImGui::SameLine(column);
  else
    ImGui::SetCursorPosX(column);
}

float button_width() {
  return ImGui::GetFrameHeight();
}

void fill_line(int buttons = 1) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(
      std::max(ImGui::GetContentRegionAvail().x - float(buttons) * (button_width() + gap), 20.0f));
}

bool small_button(const char* name, const char* words) {
  const bool pressed = ImGui::Button(name, {button_width(), 0});
  tooltip(words);
  return pressed;
}

void next_on_line() {
  ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
}

/// At the end of the line, where there is anything to take away.
bool remove_button(const Field& field) {
  if (!field.present() || field.required) return false;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button_width());
  return small_button("x", "Takes this out of the file: then the default holds.");
}

// ---- one widget a kind -----------------------------------------------------------------------------------

bool pick(const char* id, std::string& text, std::span<const std::string> options) {
  bool changed = false;
  if (ImGui::BeginCombo(id, text.c_str())) {
    for (const std::string& option : options)
      if (ImGui::Selectable(option.c_str(), option == text) && option != text) text = option, changed = true;
    ImGui::EndCombo();
  }
  return changed;
}

struct Widget {
  const Field& field;

  Wanted operator()(bool value) const {
    if (ImGui::Checkbox("##value", &value)) return value;
    return {};
  }
  Wanted operator()(float value) const { return number(value); }
  Wanted operator()(int64_t value) const { return number(value); }
  Wanted operator()(double value) const {
    const bool takes_keys = !field.columns.empty();
    fill_line(takes_keys ? 2 : 1);
    if (edit_number("##value", value, field.limits)) return value;
    help(field);
    if (!takes_keys) return {};
    next_on_line();
    const double first = field.columns[0].limits.min;
    if (small_button("~", "Keys instead of one number")) return Pairs{{first, value}, {first + 120, value}};
    return {};
  }
  Wanted operator()(std::string value) const {
    fill_line();
    if (field.options.empty()) {
      ImGui::InputText("##value", &value);
      const bool done = ImGui::IsItemDeactivatedAfterEdit();
      help(field);
      return done ? Wanted(value) : Wanted();
    }
    const bool picked = pick("##value", value, field.options);
    return picked ? Wanted(value) : Wanted();
  }
  Wanted operator()(Texts value) const {
    Wanted wanted;
    ImGui::NewLine();
    for (size_t i = 0; i < value.size(); ++i) {
      ImGui::PushID(int(i));
      fill_line();
      if (pick("##text", value[i], field.options)) wanted = value;
      next_on_line();
      if (value.size() > 1 && small_button("-", "Takes this one out of the list")) {
        Texts fewer = value;
        fewer.erase(fewer.begin() + std::ptrdiff_t(i));
        wanted = fewer;
      }
      ImGui::PopID();
    }
    if (value.size() < field.at_most && !field.options.empty() && ImGui::SmallButton("+ one more")) {
      value.push_back(field.options.front());
      wanted = value;
    }
    return wanted;
  }
  Wanted operator()(glm::vec2 value) const {
    fill_line();
    return edit_numbers("##value", {&value.x, 2}, field.limits) ? Wanted(value) : Wanted();
  }
  Wanted operator()(glm::vec3 value) const {
    fill_line();
    const bool changed = is_color(name_of(field.path)) ? edit_color("##value", value, field.limits)
                                                       : edit_numbers("##value", {&value.x, 3}, field.limits);
    return changed ? Wanted(value) : Wanted();
  }
  Wanted operator()(glm::uvec2 value) const {
    int64_t x = value.x, y = value.y;
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - 2 * button_width());
    ImGui::SetNextItemWidth(width);
    bool changed = edit_number("##x", x, field.limits);
    next_on_line();
    ImGui::SetNextItemWidth(width);
    changed |= edit_number("##y", y, field.limits);
    return changed ? Wanted(glm::uvec2(x, y)) : Wanted();
  }
  Wanted operator()(Range<float> value) const { return range(value); }
  Wanted operator()(Range<uint32_t> value) const { return range(value); }
  Wanted operator()(const Curve& value) const {
    if (value.keys.size() > 1 || value.keys[0].at != 0)
      return over_life(value, draw_curve, [&] { return edit_curve(value, field.limits); });
    fill_line(2);
    float constant = value.keys[0].value;
    if (edit_number("##value", constant, field.limits)) return Curve(constant);
    help(field);
    next_on_line();
    if (!small_button("~", "A curve over life instead of one number")) return {};
    open(true);
    return Curve({{0.0f, constant}, {1.0f, constant}});
  }
  Wanted operator()(const Gradient& value) const {
    if (value.keys.size() > 1 || value.keys[0].at != 0)
      return over_life(value, draw_gradient, [&] { return edit_gradient(value, field.limits); });
    fill_line(2);
    glm::vec3 constant = value.keys[0].value;
    if (edit_color("##value", constant, field.limits)) return Gradient(constant);
    next_on_line();
    if (!small_button("~", "Colours over life instead of one")) return {};
    open(true);
    return Gradient({{0.0f, constant}, {1.0f, constant}});
  }
  Wanted operator()(const Wholes& value) const {
    return rows(value, [&](Wholes& all, size_t row) {
      int64_t number = all[row];
      fill_line();
      if (!edit_number("##value", number, field.limits)) return false;
      all[row] = uint32_t(number);
      return true;
    });
  }
  Wanted operator()(const Pairs& value) const {
    Wanted wanted = rows(value, [&](Pairs& all, size_t row) {
      const float width = 0.5f * (ImGui::GetContentRegionAvail().x - 2 * button_width());
      bool changed = false;
      for (size_t i = 0; i < 2; ++i) {
        ImGui::PushID(int(i));
        ImGui::SetNextItemWidth(width);
        changed |= cell_of(field.columns[i], all[row][i]);
        ImGui::PopID();
        if (i == 0) next_on_line();
      }
      return changed;
    });
    const bool takes_number = field.limits.max > field.limits.min;
    if (takes_number && !value.empty() && ImGui::SmallButton("one number instead")) wanted = value[0][1];
    return wanted;
  }
  Wanted operator()(const Points& value) const {
    return rows(value, [&](Points& all, size_t row) {
      const float width = ImGui::GetContentRegionAvail().x - 2 * button_width();
      ImGui::SetNextItemWidth(0.25f * width);
      bool changed = cell_of(field.columns[0], all[row].first);
      next_on_line();
      ImGui::SetNextItemWidth(0.75f * width);
      changed |= edit_numbers("##point", {&all[row].second.x, 3}, field.columns[1].limits);
      return changed;
    });
  }
  Wanted operator()(Group) const { return {}; }
  Wanted operator()(Groups) const { return {}; }

 private:
  template <class Number>
  Wanted number(Number value) const {
    fill_line();
    const bool changed = edit_number("##value", value, field.limits);
    help(field);
    return changed ? Wanted(value) : Wanted();
  }
  template <class Ends>
  Wanted range(Ends value) const {
    fill_line();
    const bool changed = edit_range("##value", value, field.limits);
    return changed ? Wanted(value) : Wanted();
  }
  static bool cell_of(const Column& column, double& value) {
    const Limits limits{column.limits.min, column.limits.max};  // for the unit there is no room
    int64_t whole = int64_t(value);
    const bool changed =
        column.whole ? edit_number("##value", whole, limits) : edit_number("##value", value, limits);
    if (wants_tooltip())
      tooltip(fmt::format("{}: {}", column.name, limits_text(limits.min, limits.max, column.limits.unit)));
    if (changed && column.whole) value = double(whole);
    return changed;
  }
  void open(bool is_open) const { ImGui::GetStateStorage()->SetBool(ImGui::GetID("open"), is_open); }
  /// A small picture that opens the editor below.
  template <class Value, class Draw, class Edit>
  Wanted over_life(const Value& value, const Draw& draw, const Edit& edit) const {
    const bool is_open = ImGui::GetStateStorage()->GetBool(ImGui::GetID("open"));
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width =
        ImGui::GetContentRegionAvail().x - 2 * (button_width() + ImGui::GetStyle().ItemInnerSpacing.x);
    const ImVec2 size{std::max(width, 20.0f), ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("##picture", size)) open(!is_open);
    name_widget(field.path + " over life");
    tooltip(is_open ? "Closes the editor" : "Opens the editor");
    draw(*ImGui::GetWindowDrawList(), value, from, {from.x + size.x, from.y + size.y});
    if (ImGui::IsItemHovered())
      ImGui::GetWindowDrawList()->AddRect(from, {from.x + size.x, from.y + size.y},
                                          ImGui::GetColorU32(ImGuiCol_Text), 3);
    next_on_line();
    if (ImGui::ArrowButton("##arrow", is_open ? ImGuiDir_Down : ImGuiDir_Right)) open(!is_open);
    if (!is_open) return {};
    const auto edited = edit();
    return edited ? Wanted(*edited) : Wanted();
  }
  /// A line each, then one more.
  template <class List, class EditRow>
  Wanted rows(const List& value, const EditRow& edit_row) const {
    Wanted wanted;
    ImGui::NewLine();
    for (size_t row = 0; row < value.size(); ++row) {
      ImGui::PushID(int(row));
      List all = value;
      if (edit_row(all, row)) wanted = all;
      if (value.size() > field.at_least) {
        next_on_line();
        if (small_button("-", "Takes this line out")) {
          all = value;
          all.erase(all.begin() + std::ptrdiff_t(row));
          wanted = all;
        }
      }
      ImGui::PopID();
    }
    const bool is_full = field.at_most > 0 && value.size() >= field.at_most;
    if (!is_full && ImGui::SmallButton("+ one more")) wanted = with_one_more(value);
    return wanted;
  }
  /// After the last, since these lists ascend.
  Wholes with_one_more(Wholes value) const {
    value.push_back(value.empty() ? uint32_t(field.limits.min) : value.back() + 60);
    return value;
  }
  Pairs with_one_more(Pairs value) const {
    const double step = field.columns[0].whole ? 60 : 1;
    value.push_back(value.empty()
                        ? std::array{field.columns[0].limits.min, std::max(field.columns[1].limits.min, 1.0)}
                        : std::array{value.back()[0] + step, value.back()[1]});
    return value;
  }
  Points with_one_more(Points value) const {
    value.push_back(value.empty() ? std::pair{field.columns[0].limits.min, glm::vec3(0)}
                                  : std::pair{value.back().first + 60, value.back().second});
    return value;
  }
};

/// Colours that are dark otherwise.
struct Dimmed {
  explicit Dimmed(bool dims) : is_dim(dims) {
    if (dims) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.55f * ImGui::GetStyle().Alpha);
  }
  ~Dimmed() {
    if (is_dim) ImGui::PopStyleVar();
  }
  Dimmed(const Dimmed&) = delete;
  const bool is_dim;
};

void edit_value(const FieldList& list, const Field& field) {
  const Dimmed dimmed(!field.present());
  const bool wrong = field.state == Field::State::kWrong;
  label(field, wrong ? fmt::format("! {}", name_of(field.path)) : std::string(name_of(field.path)));
  // The button comes first, so that it stands on the first line of what takes several.
  const ImVec2 place = ImGui::GetCursorPos();
  if (remove_button(field)) list.edits.push_back({FieldEdit::Kind::kRemove, field.path});
  ImGui::SetCursorPos(place);
  const Wanted wanted = std::visit(Widget{field}, field.value);
  name_widget(field.path);
  if (wanted) list.edits.push_back({FieldEdit::Kind::kSet, field.path, *wanted});
}

/// A table that is there: a line that opens, and all that is in it.
void edit_present_table(const FieldList& list, const Field& field, const std::string& path,
                        std::string_view title, bool removable) {
  const float end = ImGui::GetContentRegionMax().x - button_width();
  const bool is_section = name_of(path) == path || table_of(table_of(path)).empty();
  const bool is_open = ImGui::TreeNodeEx(path.c_str(),
                                         (is_section ? ImGuiTreeNodeFlags_DefaultOpen : 0) |
                                             ImGuiTreeNodeFlags_AllowItemOverlap |
                                             ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_Framed,
                                         "%.*s", int(title.size()), title.data());
  name_widget(path);
  help(field);
  if (removable) {
    ImGui::SameLine(end);
    if (small_button("x", "Takes this table and all that is in it out of the file."))
      list.edits.push_back({FieldEdit::Kind::kRemove, path});
  }
  if (!is_open) return;
  edit_table(list, path);
  ImGui::TreePop();
}

void add_button(const FieldList& list, const Field& field, const std::string& what) {
  const Dimmed dimmed(true);
  if (ImGui::SmallButton(what.c_str())) list.edits.push_back({FieldEdit::Kind::kAdd, field.path});
  help(field);
}

/// "emitter 2: sparks", where it has a name.
std::string item_title(const FieldList& list, const Field& field, const std::string& path, size_t index) {
  const auto named = std::ranges::find(list.fields, path + ".name", &Field::path);
  const std::string title = fmt::format("{} {}", name_of(field.path), index + 1);
  if (named == list.fields.end()) return title;
  return fmt::format("{}: {}", title, value_text(named->value));
}

}  // namespace

void edit_field(const FieldList& list, const Field& field) {
  if (field.in_absent_table || (list.only_set && !field.present())) return;
  ImGui::PushID(field.path.c_str());
  const std::string name(name_of(field.path));
  if (std::holds_alternative<Group>(field.value)) {
    if (field.present())
      edit_present_table(list, field, field.path, name, !field.required);
    else
      add_button(list, field, "+ " + name);
  } else if (const Groups* groups = std::get_if<Groups>(&field.value)) {
    for (size_t i = 0; i < groups->count; ++i) {
      const std::string path = fmt::format("{}[{}]", field.path, i);
      edit_present_table(list, field, path, item_title(list, field, path, i), true);
    }
    if (groups->count < field.at_most || field.at_most == 0) add_button(list, field, "+ " + name);
  } else {
    edit_value(list, field);
  }
  ImGui::PopID();
}

void edit_table(const FieldList& list, std::string_view path) {
  // Values first: tables would part them.
  for (const bool tables : {false, true})
    for (const Field& field : list.fields)
      if (is_table(field) == tables && table_of(field.path) == path) edit_field(list, field);
}

std::string made(PresetDocument& document, std::span<const FieldEdit> edits, std::string refused_before) {
  if (edits.empty()) return refused_before;
  std::string refused;
  for (const auto& [kind, path, value] : edits) {
    // All that one does to a field while holding the mouse is one step of undo.
    const PresetDocument::Outcome outcome = kind == FieldEdit::Kind::kSet
                                                ? document.set(path, value, PresetDocument::Gesture::kGoesOn)
                                            : kind == FieldEdit::Kind::kAdd ? document.add(path)
                                                                            : document.remove(path);
    if (outcome.made) continue;
    for (const Diagnostic& mistake : outcome.diagnostics)
      refused += (refused.empty() ? "" : "\n") + mistake.message;
  }
  return refused;
}

}  // namespace plume
