#include "sandbox/debugger/curve_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sandbox/debugger/number_editor.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/workspace/key_edits.h"

namespace plume {
namespace {

constexpr ImU32 kGround = IM_COL32(14, 14, 16, 255), kGrid = IM_COL32(255, 255, 255, 28),
                kZero = IM_COL32(255, 255, 255, 80), kLine = IM_COL32(255, 205, 90, 255),
                kInk = IM_COL32(255, 255, 255, 255), kFaint = IM_COL32(255, 255, 255, 150);
constexpr float kReach = 8;          // pixels from a key that still mean it
constexpr float kHandlePixels = 34;  // from a key to the handles of its slopes
constexpr Limits kLife{0, 1, "of life"};

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
  const float s = canvas.pixel_slope(*slope), length = kHandlePixels / std::sqrt(1 + s * s);
  const float side = part == Part::kIn ? -length : length;
  const ImVec2 at = canvas.place(k.at, k.value);
  return ImVec2{at.x + side, at.y + side * s};
}

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
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
    if (const auto at = handle(curve, chosen, part, canvas); at && distance(*at, pointer) < kReach)
      return kept.take(part), false;
  for (size_t i = 0; i < curve.keys.size(); ++i)
    if (distance(canvas.place(curve.keys[i].at, curve.keys[i].value), pointer) < kReach)
      return kept.chosen() = int(i), kept.take(Part::kKey), false;
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
  for (size_t i = 0; i < curve.keys.size() && curve.keys.size() > 1; ++i)
    if (distance(canvas.place(curve.keys[i].at, curve.keys[i].value), ImGui::GetMousePos()) < kReach) {
      remove_key(curve, i);
      kept.chosen() = int(std::min(i, curve.keys.size() - 1));
      return true;
    }
  return false;
}

void draw_canvas(const Curve& curve, const Canvas& canvas, const Limits& limits, size_t chosen) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(canvas.from, canvas.to, kGround, 3);
  draw.PushClipRect(canvas.from, canvas.to, true);
  for (const double at : {0.25, 0.5, 0.75})
    draw.AddLine({canvas.place(at, 0).x, canvas.from.y}, {canvas.place(at, 0).x, canvas.to.y}, kGrid);
  const float zero = canvas.place(0, 0).y;
  draw.AddLine({canvas.from.x, zero}, {canvas.to.x, zero}, kZero);
  draw_line(draw, curve, canvas, 2);
  for (size_t i = 0; i < curve.keys.size(); ++i) {
    const ImVec2 at = canvas.place(curve.keys[i].at, curve.keys[i].value);
    const float size = i == chosen ? 5.0f : 3.5f;
    if (i == chosen)
      for (const Part part : {Part::kIn, Part::kOut})
        if (const auto end = handle(curve, i, part, canvas)) {
          draw.AddLine(at, *end, kFaint);
          draw.AddCircleFilled(*end, 4, kInk);
        }
    draw.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, i == chosen ? kInk : kLine);
  }
  const auto [least, largest] = curve.extremes();
  const float line = ImGui::GetFontSize(), margin = 4;
  const std::string unit = limits.unit.empty() ? "" : fmt::format(" {}", limits.unit);
  draw.AddText({canvas.from.x + margin, canvas.from.y + 1}, kFaint,
               fmt::format("{:.4g}{}", largest.value, unit).c_str());
  draw.AddText({canvas.from.x + margin, canvas.to.y - line - 1}, kFaint,
               fmt::format("{:.4g}", least.value).c_str());
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
  const float inset = 6;
  const Canvas canvas{{from.x + inset, from.y}, {from.x + size.x - inset, from.y + size.y}, kept.axis()};
  bool changed = drag_keys(edited, canvas, limits, kept);
  draw_canvas(edited, canvas, limits, size_t(kept.chosen()));
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
