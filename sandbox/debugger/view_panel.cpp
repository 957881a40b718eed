#include "sandbox/debugger/view_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/measure/magma.h"

namespace plume {
namespace {

constexpr ImU32 kInk = IM_COL32(255, 255, 255, 230), kGround = IM_COL32(0, 0, 0, 190);

void pick_view(Workspace& workspace, Side& side) {
  SideView& view = side.view;
  const auto chosen = Inspector::find(*side.method().method, view.id);
  const bool missing = !view.id.empty() && !chosen;
  const std::string name = chosen ? chosen->title : missing ? view.id + " (not here)" : "Picture";
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##view", name.c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) {
    name_widget("view = " + (chosen ? view.id : "picture"));
    tooltip(chosen    ? chosen->help
            : missing ? side.method().owner + " as it is set has no such view: its picture is shown."
                      : "What the method draws.");
    return;
  }
  if (ImGui::Selectable("Picture", view.id.empty())) {
    view.id.clear();
    workspace.change();
  }
  name_widget("view: picture");
  for (const Inspection& one : Inspector::inspections(*side.method().method)) {
    if (ImGui::Selectable(one.title.c_str(), one.id == view.id)) {
      view.choose(one);
      workspace.change();
    }
    name_widget("view: " + one.id);
    tooltip(one.help);
  }
  ImGui::EndCombo();
}

/// Which slice, and where along the rays it lies.
void pick_slice(Workspace& workspace, SideView& view) {
  const Inspected& seen = *view.shown;
  if (seen.what.slices == 0) return;
  int slice = int(view.slice);
  ImGui::SetNextItemWidth(-1);
  const std::string format = fmt::format("slice %d, {} in use", seen.slices.size());
  if (ImGui::SliderInt("##slice", &slice, 0, int(seen.what.slices) - 1, format.c_str(),
                       ImGuiSliderFlags_AlwaysClamp)) {
    view.slice = uint32_t(slice);
    workspace.change();
  }
  tooltip("Physical slices, front to back. Ctrl+click to type.");
  if (seen.slice >= seen.slices.size()) return note("not in use: nothing is there");
  const DepthSlice& at = seen.slices[seen.slice];
  text(fmt::format("{:.4g} m to {:.4g} m, virtual slice {}", at.near_m, at.far_m, at.virtual_slice));
}

void pick_scale(Workspace& workspace, SideView& view) {
  if (ImGui::Checkbox("log", &view.logarithmic)) workspace.change();
  tooltip(
      "Colours by ratios instead of steps. A scale that begins at 0 begins at the least number above it.");
  ImGui::SameLine();
  bool held = view.range.has_value();
  if (ImGui::Checkbox("hold range", &held)) {
    view.range = held ? std::optional(glm::vec2(view.scale.low, view.scale.high)) : std::nullopt;
    workspace.change();
  }
  tooltip(
      "Keeps the range of the colours, so that pictures can be compared; drag or Ctrl+click to change it.");
  if (!view.range) return;
  float ends[2]{view.range->x, view.range->y};
  ImGui::SetNextItemWidth(-1);
  const float speed = std::max(1e-6f, 0.005f * std::abs(ends[1] - ends[0]));
  if (ImGui::DragFloat2("##range", ends, speed, 0, 0, "%.4g") && std::isfinite(ends[0]) &&
      std::isfinite(ends[1])) {
    view.range = glm::vec2(ends[0], ends[1]);
    workspace.change();
  }
}

void describe_found(const SideView& view) {
  const ValueRange& found = view.found;
  const std::string& unit = view.shown->what.unit;
  if (found.count == 0) return note("nothing to see here");
  text(fmt::format("{:.4g} to {:.4g} {}", found.least, found.most, unit));
  text(fmt::format("mean {:.4g}, sum {:.6g}", found.sum / double(found.count), found.sum));
  text(fmt::format("in {} of {} pixels", found.count, view.shown->values.pixels.size()));
}

void describe_side(Workspace& workspace, Side& side) {
  ImGui::PushID(&side);
  pick_view(workspace, side);
  if (side.view.shown && !side.view.id.empty()) {
    pick_slice(workspace, side.view);
    pick_scale(workspace, side.view);
    describe_found(side.view);
  }
  ImGui::PopID();
}

ImU32 color_of(float share) {
  const auto [r, g, b] = magma(share);
  return IM_COL32(r, g, b, 255);
}

/// A colour bar with its numbers, at the lower edge of `area`.
void draw_legend(ImDrawList& draw, const SideView& view, Area area) {
  constexpr int kSteps = 48, kNumbers = 5;
  const float line = ImGui::GetFontSize(), margin = 0.5f * line;
  const Inspection& what = view.shown->what;
  const std::string title = fmt::format("{} [{}]{}", what.title, what.unit,
                                        what.slices > 0 ? fmt::format(", slice {}", view.shown->slice) : "");
  const float wanted = std::max(22 * line, ImGui::CalcTextSize(title.c_str()).x);
  const float width = std::min(wanted, area.size.x - 4 * margin), height = 4.1f * line;
  if (width < 8 * line || area.size.y < 2 * height) return;
  const ImVec2 from{area.corner.x + margin, area.corner.y + area.size.y - margin - height};
  draw.AddRectFilled(from, {from.x + width + 2 * margin, from.y + height}, kGround, 0.5f * margin);
  draw.AddText({from.x + margin, from.y + 0.25f * line}, kInk, title.c_str());
  const float left = from.x + margin, top = from.y + 1.5f * line, bottom = top + 0.9f * line;
  for (int i = 0; i < kSteps; ++i) {
    const float a = float(i) / kSteps, b = float(i + 1) / kSteps;
    draw.AddRectFilledMultiColor({left + a * width, top}, {left + b * width, bottom}, color_of(a),
                                 color_of(b), color_of(b), color_of(a));
  }
  draw.AddRect({left, top}, {left + width, bottom}, kInk);
  for (int i = 0; i < kNumbers; ++i) {
    const float share = float(i) / (kNumbers - 1);
    const std::string number = fmt::format("{:.3g}", view.scale.value_at(share));
    const float size = ImGui::CalcTextSize(number.c_str()).x, x = left + share * width;
    draw.AddLine({x, bottom}, {x, bottom + 0.3f * line}, kInk);
    draw.AddText({std::clamp(x - 0.5f * size, left, left + width - size), bottom + 0.35f * line}, kInk,
                 number.c_str());
  }
}

/// The number of the pixel that the pointer is at, beside it.
void draw_number(ImDrawList& draw, const Inspected& seen, float first_x, Area whole) {
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  const glm::vec2 at = (glm::vec2(pointer.x, pointer.y) - whole.corner) / whole.size;
  if (ImGui::GetIO().WantCaptureMouse || at.x < first_x || at.x >= 1 || at.y < 0 || at.y >= 1) return;
  const int x = int(at.x * float(seen.values.width)), y = int(at.y * float(seen.values.height));
  const float value = seen.values.at(x, y);
  const std::string number = std::isnan(value) ? "nothing" : fmt::format("{:.5g} {}", value, seen.what.unit);
  const ImVec2 size = ImGui::CalcTextSize(number.c_str());
  const float line = ImGui::GetFontSize();
  const ImVec2 corner{pointer.x + line, pointer.y + 0.5f * line};
  draw.AddRectFilled({corner.x - 4, corner.y - 2}, {corner.x + size.x + 4, corner.y + size.y + 2}, kGround,
                     3);
  draw.AddText(corner, kInk, number.c_str());
}

}  // namespace

void view_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  if (workspace.comparison() == Comparison::kNone) return describe_side(workspace, workspace.a);
  text("A");
  describe_side(workspace, workspace.a);
  text("B");
  describe_side(workspace, workspace.b);
}

void mark_views(Interface& interface, Area picture) {
  Workspace& workspace = interface.workspace;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const bool split = workspace.comparison() == Comparison::kSplit;
  const float pointer = (ImGui::GetIO().MousePos.x - picture.corner.x) / picture.size.x;
  for (Side* side : {&workspace.a, &workspace.b}) {
    if (!workspace.shows(*side) || !side->view.shown) continue;
    const bool left = side == &workspace.a;
    const float from = split && !left ? workspace.divider : 0.0f,
                to = split && left ? workspace.divider : 1.0f;
    draw_legend(draw, side->view,
                {{picture.corner.x + from * picture.size.x, picture.corner.y},
                 {(to - from) * picture.size.x, picture.size.y}});
    if (pointer < to) draw_number(draw, *side->view.shown, from, picture);
  }
}

}  // namespace plume
