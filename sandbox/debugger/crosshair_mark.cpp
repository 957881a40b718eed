#include "sandbox/debugger/crosshair_mark.h"

#include <imgui.h>

#include <array>

namespace plume {
namespace {

constexpr ImU32 kMagenta = IM_COL32(255, 0, 255, 255), kOutline = IM_COL32(0, 0, 0, 200);
constexpr float kArm = 2.2f, kGap = 0.35f;  // lines of text

void line(ImDrawList& draw, ImVec2 from, ImVec2 to) {
  draw.AddLine(from, to, kOutline, 4);
  draw.AddLine(from, to, kMagenta, 2);
}

}  // namespace

void mark_crosshair(const Interface& interface, Area picture) {
  const auto& shown = interface.workspace.shown();
  if (!interface.crosshair.placed() || !shown) return;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const glm::vec2 step = picture.size / glm::vec2(shown->size);  // a pixel of the picture
  const glm::vec2 low = picture.corner + glm::vec2(interface.crosshair.pixel(shown->size)) * step;
  const glm::vec2 middle = glm::floor(low + 0.5f * step) + 0.5f;
  const glm::vec2 half = glm::max(0.5f * step, glm::vec2(1.5f));  // a pixel too small to see is still marked
  const float font = ImGui::GetFontSize();
  const glm::vec2 gap = half + kGap * font, arm = half + kArm * font;
  draw.PushClipRect({picture.corner.x, picture.corner.y},
                    {picture.corner.x + picture.size.x, picture.corner.y + picture.size.y});
  for (const float way : std::array{-1.0f, 1.0f}) {
    line(draw, {middle.x + way * gap.x, middle.y}, {middle.x + way * arm.x, middle.y});
    line(draw, {middle.x, middle.y + way * gap.y}, {middle.x, middle.y + way * arm.y});
  }
  draw.AddRect({middle.x - half.x - 1, middle.y - half.y - 1}, {middle.x + half.x + 1, middle.y + half.y + 1},
               kOutline, 0, 0, 3);
  draw.AddRect({middle.x - half.x - 1, middle.y - half.y - 1}, {middle.x + half.x + 1, middle.y + half.y + 1},
               kMagenta);
  draw.PopClipRect();
}

}  // namespace plume
