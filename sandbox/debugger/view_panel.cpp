#include "sandbox/debugger/view_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/workspace/view_words.h"

namespace plume {
namespace {

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
  int slice = int(view.slice.value_or(seen.slice));
  ImGui::SetNextItemWidth(-1);
  const uint32_t in_use = std::min(uint32_t(seen.slices.size()), seen.what.slices);
  const int last = std::max({int(in_use) - 1, slice, 0});
  if (ImGui::SliderInt("##slice", &slice, 0, last, "slice %d", ImGuiSliderFlags_AlwaysClamp)) {
    view.slice = uint32_t(slice);
    workspace.change();
  }
  name_widget("slice");
  tooltip("Physical slices in use, front to back. Ctrl+click to type.");
  note(slice_words(seen));
}

void pick_range(Workspace& workspace, SideView& view) {
  using enum SideView::Range;
  const std::optional<glm::vec2>& whole = view.shown->what.range;
  const std::array names{
      whole ? fmt::format("{:g} to {:g}, all it can be", whole->x, whole->y) : std::string("all it can be"),
      std::string("what is found"), std::string("held")};
  ImGui::SetNextItemWidth(-1);
  if (ImGui::BeginCombo("##range", names[size_t(view.range)].c_str())) {
    for (const SideView::Range range : {kWhole, kFound, kHeld}) {
      if (range == kWhole && !whole) continue;
      if (!ImGui::Selectable(names[size_t(range)].c_str(), range == view.range)) continue;
      if (range == kHeld) view.held = {view.scale.low, view.scale.high};
      view.range = range;
      workspace.change();
    }
    ImGui::EndCombo();
  }
  name_widget("range");
  tooltip(
      "Range of the colours: all that the view can be; what is found in the picture, in both where two sides "
      "show the same; or held, so that pictures can be compared.");
  if (view.range != kHeld) return;
  float ends[2]{view.held.x, view.held.y};
  ImGui::SetNextItemWidth(-1);
  const float speed = std::max(1e-6f, 0.005f * std::abs(ends[1] - ends[0]));
  if (ImGui::DragFloat2("##ends", ends, speed, 0, 0, "%.4g") && std::isfinite(ends[0]) &&
      std::isfinite(ends[1])) {
    view.held = glm::vec2(ends[0], ends[1]);
    workspace.change();
  }
  tooltip("Drag, or Ctrl+click to type.");
}

void pick_scale(Workspace& workspace, SideView& view) {
  if (!view.shown->what.classes.empty()) return;
  if (ImGui::Checkbox("log", &view.logarithmic)) workspace.change();
  name_widget("log");
  tooltip(
      "Colours by ratios instead of steps. A scale that begins at 0 begins at the least number above it.");
  ImGui::SameLine();
  pick_range(workspace, view);
}

void describe_found(const SideView& view) {
  const ValueRange& found = view.found;
  const Inspection& what = view.shown->what;
  if (found.count == 0) return note(fmt::format("nothing to see: {}", what.absent));
  if (what.classes.empty()) {
    text(fmt::format("{:.4g} to {:.4g} {}", found.least, found.most, what.unit));
    text(fmt::format("mean {:.4g}, sum {:.6g}", found.sum / double(found.count), found.sum));
  }
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

}  // namespace

void view_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  if (workspace.comparison() == Comparison::kNone) return describe_side(workspace, workspace.a);
  text("A");
  describe_side(workspace, workspace.a);
  text("B");
  describe_side(workspace, workspace.b);
}

}  // namespace plume
