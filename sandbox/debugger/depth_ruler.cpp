#include "sandbox/debugger/depth_ruler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr ImU32 kGround = IM_COL32(14, 14, 16, 255), kSlice = IM_COL32(255, 255, 255, 26),
                kOutline = IM_COL32(255, 255, 255, 130), kFill = IM_COL32(95, 160, 255, 190),
                kChosen = IM_COL32(255, 205, 90, 220), kInk = IM_COL32(255, 255, 255, 220);
constexpr float kLeastSlicePixels = 3;  // closer lines would be a grey ground

/// Depth from left to right, by its logarithm.
struct Ruler {
  float left, right, near_m, far_m;
  float x(float depth_m) const {
    const float share = std::log(depth_m / near_m) / std::log(far_m / near_m);
    return left + std::clamp(share, 0.0f, 1.0f) * (right - left);
  }
};

DepthBins::Bins binned(const EmitterDepths& emitter, const DepthBins& over, float offset_m, float near_m) {
  DepthBins::Bins bins{};
  const float scale = float(DepthBins::kBins) / std::log(over.farthest_m / over.nearest_m);
  for (const float depth : emitter.depths_m) {
    const float at = std::log(std::max(depth - offset_m, 2 * near_m) / over.nearest_m) * scale;
    ++bins[size_t(std::clamp(at, 0.0f, float(DepthBins::kBins - 1)))];
  }
  const float most = std::max(*std::ranges::max_element(bins), 1.0f);
  for (float& bin : bins) bin /= most;
  return bins;
}

void draw_slices(ImDrawList& draw, const DepthSlices& slices, const Ruler& ruler, float top, float bottom) {
  const uint32_t first = uint32_t(slices.slice(ruler.near_m)), last = uint32_t(slices.slice(ruler.far_m));
  float before = ruler.left - 2 * kLeastSlicePixels;
  for (uint32_t slice = first + 1; slice <= last; ++slice) {
    const float x = ruler.x(slices.depth_m(float(slice)));
    if (x - before < kLeastSlicePixels) continue;
    draw.AddLine({x, top}, {x, bottom}, kSlice);
    before = x;
  }
}

void draw_row(ImDrawList& draw, const EmitterDepths& emitter, const DepthBins::Row& row, const Ruler& ruler,
              float near_m, float top, float bottom, bool chosen) {
  const auto& [is, drawn] = row;
  const float width = (ruler.right - ruler.left) / DepthBins::kBins, height = bottom - top;
  for (size_t i = 0; i < DepthBins::kBins; ++i) {
    const float x = ruler.left + float(i) * width;
    if (drawn[i] > 0)
      draw.AddRectFilled({x, bottom - drawn[i] * height}, {x + width, bottom}, chosen ? kChosen : kFill);
    if (is[i] > 0 && emitter.offset_m != 0)
      draw.AddLine({x, bottom - is[i] * height}, {x + width, bottom - is[i] * height}, kOutline);
  }
  if (emitter.depths_m.empty() || emitter.offset_m == 0) return;
  const float middle = emitter.depths_m[emitter.depths_m.size() / 2], y = 0.5f * (top + bottom);
  const float from = ruler.x(middle), to = ruler.x(emitter.drawn_m(middle, near_m));
  const float point = to < from ? 5.0f : -5.0f;
  draw.AddLine({from, y}, {to, y}, kInk, 1.5f);
  draw.AddTriangleFilled({to, y}, {to + point, y - 4}, {to + point, y + 4}, kInk);
}

/// In words: from where to where, and which slices.
std::string said(const EmitterDepths& emitter, float near_m, const std::optional<DepthSlices>& slices) {
  if (!emitter.has_states) return "keeps no state: not shown";
  if (emitter.depths_m.empty()) return "nothing lives";
  const float from = emitter.drawn_m(emitter.depths_m.front(), near_m);
  const float to = emitter.drawn_m(emitter.depths_m.back(), near_m);
  std::string words = fmt::format("{:.2f} .. {:.2f} m", from, to);
  if (slices)
    words += fmt::format(", slices {} .. {} of {}", int(slices->slice(from)), int(slices->slice(to)),
                         slices->count);
  if (emitter.offset_m != 0)
    words += fmt::format(", {:.2f} m {} the camera", std::abs(emitter.offset_m),
                         emitter.offset_m > 0 ? "towards" : "away from");
  return words;
}

}  // namespace

DepthBins depth_bins(std::span<const EmitterDepths> emitters, float near_m) {
  float nearest = INFINITY, farthest = 0;
  for (const EmitterDepths& emitter : emitters) {
    if (emitter.depths_m.empty()) continue;
    for (const float depth : {emitter.depths_m.front(), emitter.depths_m.back()}) {  // ascending
      const float drawn = emitter.drawn_m(depth, near_m);
      nearest = std::min({nearest, depth, drawn}), farthest = std::max({farthest, depth, drawn});
    }
  }
  if (!(nearest <= farthest)) return {};
  DepthBins bins{.nearest_m = nearest / 1.1f, .farthest_m = farthest * 1.1f, .rows = {}};
  for (const EmitterDepths& emitter : emitters)
    bins.rows.push_back(
        {.is = binned(emitter, bins, 0, near_m), .drawn = binned(emitter, bins, emitter.offset_m, near_m)});
  return bins;
}

void depth_ruler(std::span<const EmitterDepths> emitters, const DepthBins& bins, std::optional<size_t> chosen,
                 float near_m, const std::optional<DepthSlices>& slices) {
  if (bins.rows.empty()) return note("No particle of it lives at this tick.");
  const float line = ImGui::GetFontSize();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 40.0f), row = 1.7f * line;
  const ImVec2 size{width, row * float(emitters.size()) + line};
  const Ruler ruler{from.x + 2, from.x + width - 2, bins.nearest_m, bins.farthest_m};
  ImGui::Dummy(size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float bottom = from.y + size.y - line;
  draw.AddRectFilled(from, {from.x + width, bottom}, kGround, 3);
  if (slices) draw_slices(draw, *slices, ruler, from.y, bottom);
  for (size_t i = 0; i < emitters.size(); ++i) {
    const float top = from.y + row * float(i);
    draw_row(draw, emitters[i], bins.rows[i], ruler, near_m, top + 2, top + row - 2, chosen == i);
    draw.AddText({from.x + 4, top + 1}, kInk, emitters[i].name.c_str());
    const ImVec2 corner{from.x, top}, end{from.x + width, top + row};
    if (ImGui::IsMouseHoveringRect(corner, end) && ImGui::IsWindowHovered())
      ImGui::SetTooltip("%s", said(emitters[i], near_m, slices).c_str());
  }
  draw.AddText({from.x, bottom}, kInk, fmt::format("{:.2f} m", ruler.near_m).c_str());
  const std::string last = fmt::format("{:.2f} m", ruler.far_m);
  draw.AddText({from.x + width - ImGui::CalcTextSize(last.c_str()).x, bottom}, kInk, last.c_str());
  if (chosen && *chosen < emitters.size()) note(said(emitters[*chosen], near_m, slices));
}

}  // namespace plume
