#include "sandbox/debugger/curve_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sandbox/debugger/number_editor.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/workspace/key_edits.h"

namespace plume {
namespace {

constexpr ImU32 kGround = IM_COL32(14, 14, 16, 255), kGrid = IM_COL32(255, 255, 255, 28),
                kZero = IM_COL32(255, 255, 255, 80), kLine = IM_COL32(255, 205, 90, 255),
                kInk = IM_COL32(255, 255, 255, 255), kFaint = IM_COL32(255, 255, 255, 150);
// In lines of text:
constexpr float kReach = 0.75f;       // from a key that still means it
constexpr float kHandleReach = 2.6f;  // from a key to the handles of its slopes
constexpr Limits kLife{0, 1, "of life"};

float reach() {
  return kReach * ImGui::GetFontSize();
}

struct Canvas {
  ImVec2 from, to;
  Axis axis;

  ImVec2 place(double at, double value) const {
    return {from.x + float(at) * (to.x - from.x),
            to.y - float((value - axis.low) / (axis.high - axis.low)) * (to.y - from.y)};
  }
  float at(float x) const { return (x - from.x) / (to.x - from.x); }
  double value(float y) const {
    return axis.low + (axis.high - axis.low) * double((to.y - y) / (to.y - from.y));
  }
  double at_grain() const { return 1.0 / double(to.x - from.x); }
  double value_grain() const { return (axis.high - axis.low) / double(to.y - from.y); }
  /// Of a value a life, on the screen.
  float pixel_slope(float slope) const {
    return -slope * float((to.y - from.y) / (axis.high - axis.low)) / (to.x - from.x);
  }
};

void draw_line(ImDrawList& draw, const Curve& curve, const Canvas& canvas, float thickness) {
  std::vector<ImVec2> line;
  for (float x = canvas.from.x; x <= canvas.to.x; x += 2) {
    ImVec2 point = canvas.place(canvas.at(x), curve.at(canvas.at(x)));
    point.y = std::clamp(point.y, canvas.from.y, canvas.to.y);
    line.push_back(point);
  }
  draw.AddPolyline(line.data(), int(line.size()), kLine, 0, thickness);
}

enum class Part : int { kNone, kKey, kIn, kOut };

/// Where the handle of a slope is; nothing where it bends nothing.
std::optional<ImVec2> handle(const Curve& curve, size_t key, Part part, const Canvas& canvas) {
  const Curve::Key& k = curve.keys[key];
  const std::optional<float>& slope = part == Part::kIn ? k.in : k.out;
  const bool bends = part == Part::kIn ? key > 0 : key + 1 < curve.keys.size();
  if (!slope || !bends) return {};
  const float s = canvas.pixel_slope(*slope),
              length = kHandleReach * ImGui::GetFontSize() / std::sqrt(1 + s * s);
  const float side = part == Part::kIn ? -length : length;
  const ImVec2 at = canvas.place(k.at, k.value);
  return ImVec2{at.x + side, at.y + side * s};
}

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The nearest key that a place still means.
std::optional<size_t> key_at(const Curve& curve, const Canvas& canvas, ImVec2 place) {
  std::optional<size_t> nearest;
  float least = reach();
  for (size_t i = 0; i < curve.keys.size(); ++i) {
    const float away = distance(canvas.place(curve.keys[i].at, curve.keys[i].value), place);
    if (away < least) nearest = i, least = away;
  }
  return nearest;
}

/// What stays from one picture to the next while a curve is worked on.
class Kept {
 public:
  int& chosen() { return *store_.GetIntRef(ImGui::GetID("chosen"), 0); }
  Part part() const { return Part(store_.GetInt(ImGui::GetID("part"))); }
  void take(Part part) { store_.SetInt(ImGui::GetID("part"), int(part)); }
  Axis axis() const {
    return {store_.GetFloat(ImGui::GetID("low")), store_.GetFloat(ImGui::GetID("high"), 1)};
  }
  void keep(Axis axis) {
    store_.SetFloat(ImGui::GetID("low"), float(axis.low));
    store_.SetFloat(ImGui::GetID("high"), float(axis.high));
  }

 private:
  ImGuiStorage& store_ = *ImGui::GetStateStorage();
};

/// Takes what is under the pointer, or makes a key there on a double click. True when it made one.
bool take(Curve& curve, const Canvas& canvas, const Limits& limits, Kept& kept) {
  const ImVec2 pointer = ImGui::GetMousePos();
  kept.take(Part::kNone);
  const size_t chosen = size_t(kept.chosen());
  for (const Part part : {Part::kIn, Part::kOut})
    if (const auto at = handle(curve, chosen, part, canvas); at && distance(*at, pointer) < reach())
      return kept.take(part), false;
  if (const auto under = key_at(curve, canvas, pointer))
    return kept.chosen() = int(*under), kept.take(Part::kKey), false;
  if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return false;
  const double value = std::clamp(canvas.value(pointer.y), limits.min, limits.max);
  const auto added =
      add_key(curve, rounded(canvas.at(pointer.x), canvas.at_grain()), rounded(value, canvas.value_grain()));
  if (!added) return false;
  kept.chosen() = int(*added);
  kept.take(Part::kKey);
  return true;
}

void drag(Curve& curve, const Canvas& canvas, const Limits& limits, Kept& kept) {
  const ImVec2 pointer = ImGui::GetMousePos();
  Curve::Key& key = curve.keys[size_t(kept.chosen())];
  if (kept.part() == Part::kKey)
    return move_key(curve, size_t(kept.chosen()), rounded(canvas.at(pointer.x), canvas.at_grain()),
                    rounded(canvas.value(pointer.y), canvas.value_grain()), limits);
  const float run = canvas.at(pointer.x) - key.at;
  const bool before = kept.part() == Part::kIn;
  if (before ? run > -1e-3f : run < 1e-3f) return;  // straight up has no slope
  const double grain = 10 * canvas.value_grain();
  const float slope = rounded((canvas.value(pointer.y) - double(key.value)) / double(run), grain);
  const bool smooth = key.in == key.out;
  if (before || smooth) key.in = slope;
  if (!before || smooth) key.out = slope;
}

bool drag_keys(Curve& curve, const Canvas& canvas, const Limits& limits, Kept& kept) {
  const bool hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left))
    return take(curve, canvas, limits, kept);
  if (ImGui::IsItemActive() && kept.part() != Part::kNone &&
      ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
    const Curve before = curve;
    drag(curve, canvas, limits, kept);
    return curve != before;
  }
  if (!hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Right)) return false;
  const auto under = key_at(curve, canvas, ImGui::GetMousePos());
  if (!under || curve.keys.size() == 1) return false;
  remove_key(curve, *under);
  kept.chosen() = int(std::min(*under, curve.keys.size() - 1));
  return true;
}

/// What the pointer is on, in numbers.
void say_place(const Curve& curve, const Canvas& canvas, const Limits& limits) {
  const ImVec2 pointer = ImGui::GetMousePos();
  const std::string unit = limits.unit.empty() ? "" : fmt::format(" {}", limits.unit);
  if (const auto under = key_at(curve, canvas, pointer)) {
    const Curve::Key& key = curve.keys[*under];
    ImGui::SetTooltip("key at %.3g of life: %.4g%s\ndrag it; a right click takes it away", double(key.at),
                      double(key.value), unit.c_str());
    return;
  }
  const float at = std::clamp(canvas.at(pointer.x), 0.0f, 1.0f);
  ImGui::SetTooltip("%.3g of life: %.4g%s\na double click makes a key", double(at), double(curve.at(at)),
                    unit.c_str());
}

/// A level with its number, above or below it where there is room.
void draw_level(ImDrawList& draw, const Canvas& canvas, double value, const std::string& number) {
  const float y = canvas.place(0, value).y, height = ImGui::GetFontSize();
  draw.AddLine({canvas.from.x, y}, {canvas.to.x, y}, kGrid);
  const float text_y = y - canvas.from.y > height + 2 ? y - height - 1 : y + 1;
  draw.AddText({canvas.from.x + 4, text_y}, kFaint, number.c_str());
}

void draw_canvas(const Curve& curve, const Canvas& canvas, const Limits& limits, size_t chosen, float inset) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = ImGui::GetFontSize();
  const ImVec2 low{canvas.from.x - inset, canvas.from.y}, high{canvas.to.x + inset, canvas.to.y};
  draw.AddRectFilled(low, high, kGround, 3);
  draw.PushClipRect(low, high, true);
  for (const double at : {0.25, 0.5, 0.75})
    draw.AddLine({canvas.place(at, 0).x, canvas.from.y}, {canvas.place(at, 0).x, canvas.to.y}, kGrid);
  const float zero = canvas.place(0, 0).y;
  draw.AddLine({canvas.from.x, zero}, {canvas.to.x, zero}, kZero);
  const auto [least, largest] = curve.extremes();
  const std::string unit = limits.unit.empty() ? "" : fmt::format(" {}", limits.unit);
  draw_level(draw, canvas, double(largest.value), fmt::format("{:.4g}{}", largest.value, unit));
  if (least.value != largest.value)
    draw_level(draw, canvas, double(least.value), fmt::format("{:.4g}", least.value));
  draw_line(draw, curve, canvas, 2);
  const auto under = ImGui::IsItemHovered() ? key_at(curve, canvas, ImGui::GetMousePos()) : std::nullopt;
  for (size_t i = 0; i < curve.keys.size(); ++i) {
    const ImVec2 at = canvas.place(curve.keys[i].at, curve.keys[i].value);
    const float size = (i == chosen || under == i ? 0.38f : 0.28f) * line;
    if (i == chosen)
      for (const Part part : {Part::kIn, Part::kOut})
        if (const auto end = handle(curve, i, part, canvas)) {
          draw.AddLine(at, *end, kFaint);
          draw.AddCircleFilled(*end, 0.32f * line, kInk);
        }
    draw.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, i == chosen ? kInk : kLine);
  }
  draw.PopClipRect();
}

/// Straight, with one slope, or with another slope behind the key than before it.
bool edit_slopes(Curve& curve, size_t index) {
  Curve::Key& key = curve.keys[index];
  constexpr const char* kKinds[] = {"straight", "smooth", "corner"};
  int kind = !key.in && !key.out ? 0 : key.in == key.out ? 1 : 2;
  bool changed = false;
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  const float part = (width - 2 * gap) / 3;
  ImGui::SetNextItemWidth(part);
  if (ImGui::Combo("##slopes", &kind, kKinds, 3)) {
    const auto chord = [&](size_t a, size_t b) {
      return (curve.keys[b].value - curve.keys[a].value) / (curve.keys[b].at - curve.keys[a].at);
    };
    const bool first = index == 0, last = index + 1 == curve.keys.size();
    const float mean = first && last ? 0 : chord(first ? index : index - 1, last ? index : index + 1);
    if (kind == 0) key.in.reset(), key.out.reset();
    if (kind == 1) key.in = key.out = rounded(mean, 0.01);
    if (kind == 2) {
      key.in = rounded(first ? mean : chord(index - 1, index), 0.01);
      key.out = rounded(last ? mean : chord(index, index + 1), 0.01);
      if (key.in == key.out) *key.out += 0.01f;
    }
    changed = true;
  }
  tooltip(
      "How the curve passes this key: straight lines, one slope, or another slope on each side. Handles "
      "on the curve can be dragged.");
  if (kind == 0 || !key.in || !key.out) return changed;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(part);
  float in = *key.in, out = *key.out;
  if (edit_number("##in", in, kSlope)) {
    key.in = in;
    if (kind == 1) key.out = in;
    changed = true;
  }
  tooltip("Slope before the key, value per life");
  if (kind != 2) return changed;
  ImGui::SameLine();
  ImGui::SetNextItemWidth(part);
  if (edit_number("##out", out, kSlope)) key.out = out, changed = true;
  tooltip("Slope after the key, value per life");
  return changed;
}

bool edit_chosen(Curve& curve, size_t index, const Limits& limits) {
  Curve::Key key = curve.keys[index];
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(0.5f * (width - gap));
  bool changed = edit_number("##at", key.at, kLife);
  tooltip("When: 0 is birth, 1 is death");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(0.5f * (width - gap));
  changed |= edit_number("##value", key.value, limits);
  tooltip(limits_text(limits.min, limits.max, limits.unit));
  if (changed) move_key(curve, index, key.at, key.value, limits);
  return edit_slopes(curve, index) || changed;
}

}  // namespace

std::optional<Curve> edit_curve(const Curve& curve, const Limits& limits) {
  Curve edited = curve;
  Kept kept;
  kept.chosen() = std::clamp(kept.chosen(), 0, int(curve.keys.size()) - 1);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 40.0f), 7 * ImGui::GetFontSize()};
  ImGui::InvisibleButton("canvas", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  // The axis stands still under a drag.
  if (!ImGui::IsItemActive() || ImGui::IsItemActivated()) kept.keep(axis_of(curve));
  name_widget("curve");
  const float inset = 0.5f * ImGui::GetFontSize();
  const Canvas canvas{{from.x + inset, from.y}, {from.x + size.x - inset, from.y + size.y}, kept.axis()};
  bool changed = drag_keys(edited, canvas, limits, kept);
  draw_canvas(edited, canvas, limits, size_t(kept.chosen()), inset);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) say_place(edited, canvas, limits);
  changed |= edit_chosen(edited, size_t(kept.chosen()), limits);
  if (!changed) return {};
  return edited;
}

void draw_curve(ImDrawList& draw, const Curve& curve, const ImVec2& from, const ImVec2& to) {
  draw.AddRectFilled(from, to, kGround, 3);
  draw.PushClipRect(from, to, true);
  draw_line(draw, curve, {{from.x + 2, from.y + 2}, {to.x - 2, to.y - 2}, axis_of(curve)}, 1.5f);
  draw.PopClipRect();
}

}  // namespace plume
