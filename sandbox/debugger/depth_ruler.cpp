#include "sandbox/debugger/depth_ruler.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr ImU32 kGround = IM_COL32(14, 14, 16, 255), kBorder = IM_COL32(255, 255, 255, 34),
                kOutline = IM_COL32(255, 255, 255, 150), kFill = IM_COL32(95, 160, 255, 190),
                kChosen = IM_COL32(255, 205, 90, 220), kInk = IM_COL32(255, 255, 255, 220),
                kBox = IM_COL32(120, 130, 140, 255), kTick = IM_COL32(150, 155, 165, 255);
constexpr float kLeastSlicePixels = 3;  // closer lines would be a grey ground
constexpr float kCaption = 4.6f;        // lines of text: the column of names
constexpr float kRow = 2.4f, kStrip = 0.9f;

/// Depth from left to right, by its logarithm.
struct Ruler {
  float left, right, near_m, far_m;
  float x(float depth_m) const {
    const float share = std::log(depth_m / near_m) / std::log(far_m / near_m);
    return left + std::clamp(share, 0.0f, 1.0f) * (right - left);
  }
  float depth_m(float at) const { return near_m * std::pow(far_m / near_m, (at - left) / (right - left)); }
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

struct Strip {
  float top, bottom;
};

/// Boxes; lines through what stands above, so that one sees which particles share one.
void draw_physical(ImDrawList& draw, const SlicedDepth& slices, const Ruler& ruler, float top, Strip strip) {
  float before = ruler.left - 2 * kLeastSlicePixels;
  for (const DepthSlice& slice : slices.physical) {
    if (slice.far_m <= ruler.near_m || slice.near_m >= ruler.far_m) continue;
    const float from = ruler.x(slice.near_m), to = ruler.x(slice.far_m);
    draw.AddRectFilled({from, strip.top}, {std::max(to, from + 1), strip.bottom}, kBox);
    if (from - before < kLeastSlicePixels) continue;
    draw.AddLine({from, strip.top}, {from, strip.bottom}, kGround);
    draw.AddLine({from, top}, {from, strip.top}, kBorder);
    before = from;
  }
}

/// Ticks: of every one, or of every second, fourth, ... that leaves room between them. Returns which.
uint32_t draw_virtual(ImDrawList& draw, const DepthCurve& curve, const Ruler& ruler, Strip strip) {
  const float first = curve.slice(ruler.near_m), last = curve.slice(ruler.far_m);
  uint32_t each = 1;
  while ((last - first) / float(each) * kLeastSlicePixels > ruler.right - ruler.left) each *= 2;
  for (uint32_t slice = (uint32_t(first) / each + 1) * each; float(slice) <= last; slice += each) {
    const float x = ruler.x(curve.depth_m(float(slice)));
    draw.AddLine({x, strip.top}, {x, strip.bottom}, kTick);
  }
  return each;
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

/// "31 .. 44 of 57"; which slices are met between two depths.
std::string met(const SlicedDepth& slices, float from, float to) {
  std::optional<size_t> first, last;
  for (size_t i = 0; i < slices.physical.size(); ++i) {
    if (slices.physical[i].far_m <= from || slices.physical[i].near_m > to) continue;
    if (!first) first = i;
    last = i;
  }
  if (!first) return fmt::format("none of {}", slices.physical.size());
  return fmt::format("{} .. {} of {}", *first, *last, slices.physical.size());
}

/// In words: from where to where, and which slices.
std::string said(const EmitterDepths& emitter, float near_m, const SlicedDepth& slices) {
  if (!emitter.has_states) return "keeps no state: not shown";
  if (emitter.depths_m.empty()) return "nothing lives";
  const float from = emitter.drawn_m(emitter.depths_m.front(), near_m);
  const float to = emitter.drawn_m(emitter.depths_m.back(), near_m);
  std::string words = fmt::format("{:.2f} .. {:.2f} m", from, to);
  if (emitter.offset_m != 0)
    words += fmt::format(", {:.2f} m {} the camera", std::abs(emitter.offset_m),
                         emitter.offset_m > 0 ? "towards" : "away from");
  if (!slices.physical.empty()) words += "\nphysical slices " + met(slices, from, to);
  if (slices.curve)
    words += fmt::format("\nvirtual slices {} .. {} of {}", int(slices.curve->slice(from)),
                         int(slices.curve->slice(to)), slices.curve->count);
  return words;
}

/// What is at a depth.
std::string said_at(float depth_m, const SlicedDepth& slices) {
  std::string words = fmt::format("{:.2f} m", depth_m);
  if (!slices.physical.empty()) {
    const auto physical = slices.physical_at(depth_m);
    words += physical ? fmt::format("\nphysical slice {} of {}, {:.3g} to {:.3g} m", *physical,
                                    slices.physical.size(), slices.physical[*physical].near_m,
                                    slices.physical[*physical].far_m)
                      : std::string("\nno physical slice: empty space");
  }
  if (slices.curve)
    words += fmt::format("\nvirtual slice {} of {}", int(slices.curve->slice(depth_m)), slices.curve->count);
  return words;
}

void say_when_hovered(ImVec2 from, ImVec2 to, const std::string& words) {
  if (ImGui::IsMouseHoveringRect(from, to) && ImGui::IsWindowHovered())
    ImGui::SetTooltip("%s", words.c_str());
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
                 float near_m, const SlicedDepth& slices) {
  if (bins.rows.empty()) return note("No particle of it lives at this tick.");
  const float line = ImGui::GetFontSize();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = std::max(ImGui::GetContentRegionAvail().x, 12 * line), row = kRow * line;
  const int strips = int(!slices.physical.empty()) + int(slices.curve.has_value());
  const float rows_end = from.y + row * float(emitters.size());
  const float strips_end = rows_end + float(strips) * (kStrip * line + 2);
  ImGui::Dummy({width, strips_end + 1.1f * line - from.y});
  const Ruler ruler{from.x + (strips > 0 ? kCaption * line : 2), from.x + width - 2, bins.nearest_m,
                    bins.farthest_m};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({ruler.left - 2, from.y}, {from.x + width, strips_end}, kGround, 3);

  Strip strip{rows_end + 1, rows_end + 1 + kStrip * line};
  if (!slices.physical.empty()) {
    draw_physical(draw, slices, ruler, from.y, strip);
    draw.AddText({from.x, strip.top - 1}, kInk, "physical");
    strip = {strip.bottom + 2, strip.bottom + 2 + kStrip * line};
  }
  uint32_t each = 1;
  if (slices.curve) {
    each = draw_virtual(draw, *slices.curve, ruler, strip);
    draw.AddText({from.x, strip.top - 1}, kInk, "virtual");
  }
  const float pointer = ImGui::GetMousePos().x;
  if (strips > 0 && pointer >= ruler.left)
    say_when_hovered({ruler.left, rows_end}, {ruler.right, strips_end},
                     said_at(ruler.depth_m(pointer), slices) +
                         (each > 1 ? fmt::format("\na tick for every {} virtual slices", each) : ""));
  for (size_t i = 0; i < emitters.size(); ++i) {
    const float top = from.y + row * float(i);
    draw_row(draw, emitters[i], bins.rows[i], ruler, near_m, top + line, top + row - 2, chosen == i);
    draw.AddText({ruler.left + 2, top}, kInk, emitters[i].name.c_str());
    say_when_hovered({from.x, top}, {from.x + width, top + row}, said(emitters[i], near_m, slices));
  }
  draw.AddText({ruler.left, strips_end}, kInk, fmt::format("{:.2f} m", ruler.near_m).c_str());
  const std::string last = fmt::format("{:.2f} m", ruler.far_m);
  draw.AddText({from.x + width - ImGui::CalcTextSize(last.c_str()).x, strips_end}, kInk, last.c_str());
  if (chosen && *chosen < emitters.size()) note(said(emitters[*chosen], near_m, slices));
}

}  // namespace plume
