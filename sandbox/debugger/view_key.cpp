#include "sandbox/debugger/view_key.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sandbox/measure/magma.h"
#include "sandbox/workspace/view_words.h"

namespace plume {
namespace {

constexpr ImU32 kInk = IM_COL32(255, 255, 255, 235), kFaint = IM_COL32(255, 255, 255, 175),
                kGround = IM_COL32(0, 0, 0, 205), kBorder = IM_COL32(255, 255, 255, 60);
constexpr float kBarLines = 22, kLeastLines = 6;  // width, in lines of text
constexpr int kChartLabels = 5;

using Texel = std::array<uint8_t, 3>;

ImU32 color_of(const Texel& texel) {
  return IM_COL32(texel[0], texel[1], texel[2], 255);
}

void words(ImDrawList& draw, ImVec2 at, ImU32 ink, const std::string& text) {
  draw.AddText(at, ink, text.c_str());
}

/// A line of the key: its height and how it is drawn with its upper left corner there.
struct Line {
  float width, height;
  std::function<void(ImDrawList&, ImVec2)> draw;
};

Line text_line(std::string text, ImU32 ink) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  return {size.x, size.y + 0.25f * ImGui::GetFontSize(),
          [text = std::move(text), ink](ImDrawList& draw, ImVec2 at) { words(draw, at, ink, text); }};
}

/// A patch of a pattern and what it stands for.
Line patch_line(const std::string& name, Texel (*texel)(size_t, int, int), size_t index) {
  const float line = ImGui::GetFontSize();
  const ImVec2 size = ImGui::CalcTextSize(name.c_str());
  const auto draw_patch = [name, texel, index, line](ImDrawList& draw, ImVec2 at) {
    const int columns = int(2 * line), rows = int(line);
    for (int y = 0; y < rows; ++y)
      for (int x = 0, run = 0; x < columns; x = run) {
        const Texel color = texel(index, x, y);
        for (run = x + 1; run < columns && texel(index, run, y) == color;) ++run;
        const ImVec2 from{std::floor(at.x) + float(x), std::floor(at.y) + float(y)};
        draw.AddRectFilled(from, {from.x + float(run - x), from.y + 1}, color_of(color));
      }
    draw.AddRect(at, {at.x + float(columns), at.y + float(rows)}, kFaint);
    words(draw, {at.x + 2.4f * line, at.y}, kInk, name);
  };
  return {2.4f * line + size.x, 1.3f * line, draw_patch};
}

Texel absent(size_t, int x, int y) {
  return absent_texel(x, y);
}

/// As many numbers as there is room for, at the same shares of the bar.
void draw_numbers(ImDrawList& draw, const SideView& view, float left, float top, float width) {
  const float line = ImGui::GetFontSize();
  int parts = 4;
  for (; parts > 1; parts /= 2) {
    float sum = 0;
    for (int i = 0; i <= parts; ++i)
      sum += ImGui::CalcTextSize(bar_number(view, float(i) / float(parts)).c_str()).x + line;
    if (sum < width) break;
  }
  for (int i = 0; i <= parts; ++i) {
    const float share = float(i) / float(parts), x = left + share * width;
    const std::string number = bar_number(view, share);
    const float size = ImGui::CalcTextSize(number.c_str()).x;
    draw.AddLine({x, top}, {x, top + 0.3f * line}, kInk);
    words(draw, {std::clamp(x - 0.5f * size, left, left + width - size), top + 0.35f * line}, kInk, number);
  }
}

/// Colours and numbers; a mark where `pointed_at` is.
Line bar_line(const SideView& view, float width, float pointed_at) {
  const float line = ImGui::GetFontSize();
  return {
      width, 2.7f * line, [&view, width, pointed_at, line](ImDrawList& draw, ImVec2 at) {
        constexpr int kSteps = 48;
        const float top = at.y + 0.35f * line, bottom = top + 0.9f * line;
        for (int i = 0; i < kSteps; ++i) {
          const float a = float(i) / kSteps, b = float(i + 1) / kSteps;
          const ImU32 from = color_of(magma(a)), to = color_of(magma(b));
          draw.AddRectFilledMultiColor({at.x + a * width, top}, {at.x + b * width, bottom}, from, to, to,
                                       from);
        }
        draw.AddRect({at.x, top}, {at.x + width, bottom}, kInk);
        draw_numbers(draw, view, at.x, bottom, width);
        if (std::isnan(pointed_at)) return;
        const float x = at.x + view.scale.share_of(pointed_at) * width, half = 0.35f * line;
        draw.AddTriangleFilled({x - half, top - half}, {x + half, top - half}, {x, top + 0.3f * line}, kInk);
        draw.AddLine({x, top}, {x, bottom}, kInk);
      }};
}

/// The pixel under the pointer, where it is in the columns of the picture that are this side's.
std::optional<glm::ivec2> pixel_under_pointer(const Inspected& seen, Area part, Area whole) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const glm::vec2 pointer(mouse.x, mouse.y), inside = pointer - part.corner;
  if (ImGui::GetIO().WantCaptureMouse || glm::any(glm::lessThan(inside, glm::vec2(0))) ||
      glm::any(glm::greaterThanEqual(inside, part.size)))
    return {};
  const glm::vec2 share = (pointer - whole.corner) / whole.size;
  return glm::min(glm::ivec2(share * glm::vec2(seen.values.width, seen.values.height)),
                  glm::ivec2(seen.values.width - 1, seen.values.height - 1));
}

/// At a lower corner of its part; of a chart, whose bars are there, at an upper one.
void draw_key(ImDrawList& draw, const SideView& view, Area part, float pointed_at) {
  const Inspection& what = view.shown->what;
  const float line = ImGui::GetFontSize(), margin = 0.5f * line;
  const float room = part.size.x - 4 * margin;
  std::vector<Line> lines;
  lines.push_back(text_line(view_title(what), kInk));
  if (const std::string slice = slice_words(*view.shown); !slice.empty())
    lines.push_back(text_line(slice, kFaint));
  if (what.classes.empty()) {
    lines.push_back(bar_line(view, std::min(kBarLines * line, room), pointed_at));
    lines.push_back(text_line(scale_words(view), kFaint));
  }
  for (size_t i = 0; i < what.classes.size(); ++i)
    lines.push_back(patch_line(what.classes[i], class_texel, i));
  const bool has_gaps = view.found.count < view.shown->values.pixels.size();
  if (has_gaps && !what.over_slices) lines.push_back(patch_line(what.absent, absent, 0));
  float width = 0, height = margin;
  for (const Line& one : lines) width = std::max(width, one.width), height += one.height;
  width = std::min(width, room);
  if (room < kLeastLines * line || part.size.y < 1.5f * height) return;
  const float top =
      what.over_slices ? part.corner.y + 2.5f * line : part.corner.y + part.size.y - margin - height;
  const ImVec2 from{part.corner.x + margin, top}, to{from.x + width + 2 * margin, from.y + height};
  draw.AddRectFilled(from, to, kGround, 0.5f * margin);
  draw.AddRect(from, to, kBorder, 0.5f * margin);
  draw.PushClipRect(from, to, true);
  ImVec2 at{from.x + margin, from.y + 0.5f * margin};
  for (const Line& one : lines) {
    one.draw(draw, at);
    at.y += one.height;
  }
  draw.PopClipRect();
}

/// What a few of the chart's bars are, on top of them.
void label_chart(ImDrawList& draw, const Inspected& seen, Area part, Area whole) {
  const auto used = int(seen.slices.size());
  const Raster<float>& values = seen.values;
  const float line = ImGui::GetFontSize();
  for (int i = 0; i < std::min(kChartLabels, used); ++i) {
    const int slice = used * (2 * i + 1) / (2 * std::min(kChartLabels, used));
    const int x = std::min((2 * slice + 1) * values.width / (2 * used), values.width - 1);
    int y = 0;
    while (y + 1 < values.height && std::isnan(values.at(x, y))) ++y;
    const DepthSlice& at = seen.slices[size_t(slice)];
    const std::string text =
        fmt::format("physical {}\nvirtual {}\n{:.3g} m", slice, at.virtual_slice, at.far_m);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const glm::vec2 top =
        whole.corner + (glm::vec2(x, y) + 0.5f) / glm::vec2(values.width, values.height) * whole.size;
    const float left =
        std::clamp(top.x - 0.5f * size.x, whole.corner.x + 4, whole.corner.x + whole.size.x - size.x - 4);
    if (left < part.corner.x || left + size.x > part.corner.x + part.size.x) continue;
    const float above = top.y - size.y - 0.8f * line;
    draw.AddRectFilled({left - 3, above - 2}, {left + size.x + 3, above + size.y + 2}, kGround, 3);
    words(draw, {left, above}, kInk, text);
    draw.AddLine({top.x, above + size.y + 2}, {top.x, top.y}, kInk);
  }
}

void draw_pixel_words(ImDrawList& draw, const std::string& text, Area part) {
  const ImVec2 pointer = ImGui::GetIO().MousePos, size = ImGui::CalcTextSize(text.c_str());
  const float line = ImGui::GetFontSize();
  // To the left of the pointer where there is no room to its right.
  const bool fits = pointer.x + line + size.x + 4 < part.corner.x + part.size.x;
  const ImVec2 corner{fits ? pointer.x + line : pointer.x - line - size.x, pointer.y + 0.5f * line};
  draw.AddRectFilled({corner.x - 4, corner.y - 2}, {corner.x + size.x + 4, corner.y + size.y + 2}, kGround,
                     3);
  words(draw, corner, kInk, text);
}

}  // namespace

void mark_views(Interface& interface, Area picture) {
  Workspace& workspace = interface.workspace;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const bool split = workspace.comparison() == Comparison::kSplit;
  for (Side* side : {&workspace.a, &workspace.b}) {
    if (!workspace.shows(*side) || !side->view.shown) continue;
    const bool left = side == &workspace.a;
    const float from = split && !left ? workspace.divider : 0.0f,
                to = split && left ? workspace.divider : 1.0f;
    const Area part{{picture.corner.x + from * picture.size.x, picture.corner.y},
                    {(to - from) * picture.size.x, picture.size.y}};
    const Inspected& seen = *side->view.shown;
    const auto pixel = pixel_under_pointer(seen, part, picture);
    if (seen.what.over_slices) label_chart(draw, seen, part, picture);
    draw_key(draw, side->view, part, pixel ? seen.values.at(pixel->x, pixel->y) : NAN);
    if (pixel) draw_pixel_words(draw, pixel_words(seen, pixel->x, pixel->y), part);
  }
}

}  // namespace plume
