#include "sandbox/debugger/gradient_editor.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sandbox/debugger/color_editor.h"
#include "sandbox/debugger/number_editor.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/workspace/key_edits.h"

namespace plume {
namespace {

constexpr ImU32 kInk = IM_COL32(255, 255, 255, 255), kShade = IM_COL32(0, 0, 0, 255),
                kPlain = IM_COL32(170, 170, 175, 255);
constexpr Limits kLife{0, 1, "of life"};

float brightest(const Gradient& gradient) {
  float most = 0;
  for (const Gradient::Key& key : gradient.keys)
    most = std::max({most, key.value.r, key.value.g, key.value.b});
  return most;
}

struct Bar {
  float left, right, top, bottom;  // of the colours; marks stand below
  float x(float at) const { return left + at * (right - left); }
  float at(float place) const { return (place - left) / (right - left); }
};

void draw_marks(const Gradient& gradient, const Bar& bar, size_t chosen, float size) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (size_t i = 0; i < gradient.keys.size(); ++i) {
    const float x = bar.x(gradient.keys[i].at), top = bar.bottom - 3, bottom = bar.bottom + size;
    const float half = 0.55f * size;
    draw.AddTriangleFilled({x, top}, {x + half, bottom}, {x - half, bottom}, i == chosen ? kInk : kPlain);
    if (i == chosen) {
      draw.AddLine({x - 1, bar.top}, {x - 1, bar.bottom}, kShade);  // told from pale colours too
      draw.AddLine({x, bar.top}, {x, bar.bottom}, kInk);
    }
    draw.AddTriangle({x, top}, {x + half, bottom}, {x - half, bottom}, kShade);
  }
}

std::optional<size_t> nearest(const Gradient& gradient, const Bar& bar, float x) {
  const float reach = 0.7f * ImGui::GetFontSize();
  std::optional<size_t> found;
  for (size_t i = 0; i < gradient.keys.size(); ++i) {
    const float away = std::abs(bar.x(gradient.keys[i].at) - x);
    if (away < reach && (!found || away < std::abs(bar.x(gradient.keys[*found].at) - x))) found = i;
  }
  return found;
}

/// Of the last item.
bool drag_keys(Gradient& gradient, const Bar& bar, int& chosen, bool& holds) {
  const float x = ImGui::GetMousePos().x;
  const double grain = 1.0 / double(bar.right - bar.left);
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const auto under = nearest(gradient, bar, x);
    holds = under.has_value();
    if (under) return chosen = int(*under), false;
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return false;
    const auto added = add_key(gradient, rounded(double(bar.at(x)), grain));
    if (!added) return false;
    chosen = int(*added);
    return holds = true;
  }
  if (ImGui::IsItemActive() && holds && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
    const Gradient before = gradient;
    move_key(gradient, size_t(chosen), rounded(double(bar.at(x)), grain));
    return gradient != before;
  }
  if (!ImGui::IsItemHovered() || !ImGui::IsMouseClicked(ImGuiMouseButton_Right)) return false;
  const auto under = nearest(gradient, bar, x);
  if (!under || gradient.keys.size() == 1) return false;
  remove_key(gradient, *under);
  chosen = int(std::min(*under, gradient.keys.size() - 1));
  return true;
}

/// What the pointer is on, in numbers.
void say_place(const Gradient& gradient, const Bar& bar) {
  const float at = std::clamp(bar.at(ImGui::GetMousePos().x), 0.0f, 1.0f);
  const bool on_key = nearest(gradient, bar, ImGui::GetMousePos().x).has_value();
  const glm::vec3 color = gradient.at(at);
  ImGui::SetTooltip("%.3g of life: %.3g, %.3g, %.3g\n%s", double(at), double(color.r), double(color.g),
                    double(color.b),
                    on_key ? "drag the mark; a right click takes it away" : "a double click makes a mark");
}

}  // namespace

std::optional<Gradient> edit_gradient(const Gradient& gradient, const Limits& limits) {
  Gradient edited = gradient;
  ImGuiStorage& kept = *ImGui::GetStateStorage();
  int chosen = std::clamp(kept.GetInt(ImGui::GetID("chosen")), 0, int(gradient.keys.size()) - 1);
  bool holds = kept.GetBool(ImGui::GetID("holds"));
  const float line = ImGui::GetFontSize(), marks = 0.8f * line, inset = 0.5f * line;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, 40.0f), 1.6f * line + marks};
  ImGui::InvisibleButton("bar", size, ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  name_widget("gradient");
  const bool pointed_at = ImGui::IsItemHovered() || ImGui::IsItemActive();
  const Bar bar{from.x + inset, from.x + size.x - inset, from.y, from.y + size.y - marks};
  bool changed = drag_keys(edited, bar, chosen, holds);
  kept.SetInt(ImGui::GetID("chosen"), chosen);
  kept.SetBool(ImGui::GetID("holds"), holds);
  draw_gradient(*ImGui::GetWindowDrawList(), edited, {bar.left, bar.top}, {bar.right, bar.bottom});
  draw_marks(edited, bar, size_t(chosen), marks);
  if (pointed_at) say_place(edited, bar);

  Gradient::Key& key = edited.keys[size_t(chosen)];
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(0.3f * width);
  float at = key.at;
  if (edit_number("##at", at, kLife)) {
    move_key(edited, size_t(chosen), at);
    changed = true;
  }
  tooltip("When: 0 is birth, 1 is death");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  changed |= edit_color("color", key.value, limits);
  if (const float most = brightest(edited); most > 1)
    note(fmt::format("brightest: {:.3g}, shown as white", most));
  if (!changed) return {};
  return edited;
}

void draw_gradient(ImDrawList& draw, const Gradient& gradient, const ImVec2& from, const ImVec2& to) {
  const float most = std::max(1.0f, brightest(gradient));
  // In steps, since the screen's mean of two colours is not that of their light.
  constexpr float kStep = 3;
  for (float x = from.x; x < to.x; x += kStep) {
    const float at = (x + 0.5f * kStep - from.x) / (to.x - from.x);
    draw.AddRectFilled({x, from.y}, {std::min(x + kStep, to.x), to.y}, shown_color(gradient.at(at), most));
  }
}

}  // namespace plume
