#include "sandbox/debugger/viewport_marks.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

namespace plume {
namespace {

constexpr ImU32 kInk = IM_COL32(255, 255, 255, 230), kGround = IM_COL32(0, 0, 0, 150);

/// `from_right`: `at` is its upper right corner, otherwise its upper left one.
void label(ImDrawList& draw, ImVec2 at, const std::string& text, bool from_right) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float margin = 0.35f * ImGui::GetFontSize();
  if (from_right) at.x -= size.x + 2 * margin;
  draw.AddRectFilled(at, {at.x + size.x + 2 * margin, at.y + size.y + margin}, kGround, margin);
  draw.AddText({at.x + margin, at.y + 0.5f * margin}, kInk, text.c_str());
}

}  // namespace

void mark_viewport(Interface& interface, Area picture) {
  Workspace& workspace = interface.workspace;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const float gap = 0.5f * ImGui::GetFontSize(), top = picture.corner.y + gap;
  const float left = picture.corner.x, right = left + picture.size.x;
  const auto name = [](const char* side, Side& of) {
    return side + std::string(of.method().method->id()) +
           (of.view.shown ? ", " + of.view.shown->what.title : "");
  };
  if (workspace.shows(workspace.a)) label(draw, {left + gap, top}, name("A: ", workspace.a), false);
  if (workspace.shows(workspace.b)) label(draw, {right - gap, top}, name("B: ", workspace.b), true);
  if (const Recorder& recorder = interface.recording.recorder(); recorder.is_recording())
    label(draw, {left + gap, top + 1.8f * ImGui::GetFontSize()},
          fmt::format("RECORDING, {} pictures (Ctrl+R: stop and save)", recorder.shots()), false);
  if (workspace.comparison() != Comparison::kSplit) return;
  const float x = std::round(left + workspace.divider * picture.size.x) + 0.5f;
  const float bottom = picture.corner.y + picture.size.y, middle = picture.corner.y + 0.5f * picture.size.y;
  draw.AddLine({x - 1, picture.corner.y}, {x - 1, bottom}, kGround, 3);
  draw.AddLine({x, picture.corner.y}, {x, bottom}, kInk);
  draw.AddTriangleFilled({x - 10, middle}, {x - 3, middle - 6}, {x - 3, middle + 6}, kInk);
  draw.AddTriangleFilled({x + 10, middle}, {x + 3, middle + 6}, {x + 3, middle - 6}, kInk);
}

}  // namespace plume
