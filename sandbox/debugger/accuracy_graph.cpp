#include "sandbox/debugger/accuracy_graph.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "renderer/parameters.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr double kLeastError = 1e-5;  // what is exact stands at the edge

struct Axis {
  double low, high;  // logarithms
  float at(double value) const {
    return float((std::log10(std::max(value, kLeastError)) - low) / (high - low));
  }
  /// 1, 2 and 5 times powers of ten, or the powers alone where there are many.
  std::vector<double> ticks() const {
    std::vector<double> values;
    for (double power = std::floor(low); power <= high; ++power)
      for (const double step : {1.0, 2.0, 5.0})
        if (const double at = power + std::log10(step);
            at >= low && at <= high && (step == 1.0 || high - low < 1.5))
          values.push_back(step * std::pow(10.0, power));
    return values;
  }
};

/// Around the values, with a margin and at least a factor of four.
template <class Value>
Axis axis_of(const std::vector<AccuracyLog::Entry>& entries, Value value) {
  double low = 1e30, high = -1e30;
  for (const auto& entry : entries) {
    const double power = std::log10(std::max(value(entry), kLeastError));
    low = std::min(low, power);
    high = std::max(high, power);
  }
  const double margin = std::max(0.15 * (high - low), 0.3);
  return {low - margin, high + margin};
}

std::string about(const AccuracyLog::Entry& entry) {
  return fmt::format("{}: RMSE {:.4f}, FLIP {:.4f}, {:.1f} ms", entry.method, entry.rmse, entry.flip,
                     entry.ms);
}

void frame_axes(ImDrawList& draw, ImVec2 corner, ImVec2 size, const Axis& ms, const Axis& error) {
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  for (const double value : ms.ticks()) {
    const float x = corner.x + ms.at(value) * size.x;
    draw.AddLine({x, corner.y}, {x, corner.y + size.y}, ink);
    draw.AddText({x + 2, corner.y + size.y - ImGui::GetFontSize()}, ink,
                 fmt::format("{:g} ms", value).c_str());
  }
  for (const double value : error.ticks()) {
    const float y = corner.y + size.y - error.at(value) * size.y;
    draw.AddLine({corner.x, y}, {corner.x + size.x, y}, ink);
    draw.AddText({corner.x + 2, y}, ink, fmt::format("RMSE {:g}", value).c_str());
  }
}

/// A point with its name beside it, no higher than `lowest_label`, which it moves down.
void draw_point(ImDrawList& draw, ImVec2 at, const std::string& name, bool now, float right,
                float& lowest_label) {
  const float line = ImGui::GetFontSize();
  const ImU32 ink = ImGui::GetColorU32(now ? ImGuiCol_PlotHistogram : ImGuiCol_Text);
  if (now)
    draw.AddRectFilled({at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, ink);
  else
    draw.AddCircle(at, 4, ink);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const bool at_edge = at.x + 14 + width > right;
  const ImVec2 label{at_edge ? at.x - 14 - width : at.x + 14, std::max(at.y - 0.5f * line, lowest_label)};
  lowest_label = label.y + line;
  const float side = at_edge ? -1.0f : 1.0f;
  draw.AddLine({at.x + 4 * side, at.y}, {at.x + 12 * side, label.y + 0.5f * line}, ink);
  draw.AddText(label, ink, name.c_str());
}

}  // namespace

void accuracy_graph(const AccuracyLog& log, const MethodInstance& shown) {
  const auto& entries = log.entries();
  if (entries.empty()) return note("Pause, then choose one method after the other: each becomes a point.");
  const Axis ms = axis_of(entries, [](const auto& e) { return e.ms; });
  const Axis error = axis_of(entries, [](const auto& e) { return e.rmse; });
  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, 16 * line};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  frame_axes(draw, corner, size, ms, error);
  const nlohmann::json settings = parameter_values(*shown.method);
  std::vector<AccuracyLog::Entry> from_above = entries;
  std::ranges::sort(from_above, std::ranges::greater(), &AccuracyLog::Entry::rmse);
  std::string hovered;
  float lowest_label = corner.y;
  for (const auto& entry : from_above) {
    const ImVec2 at{corner.x + ms.at(entry.ms) * size.x, corner.y + size.y - error.at(entry.rmse) * size.y};
    const bool now = entry.method == shown.method->id() && entry.settings == settings;
    draw_point(draw, at, entry.method, now, corner.x + size.x, lowest_label);
    if (std::hypot(ImGui::GetIO().MousePos.x - at.x, ImGui::GetIO().MousePos.y - at.y) < 8)
      hovered += (hovered.empty() ? "" : "\n") + about(entry);
  }
  ImGui::InvisibleButton("accuracy", size);
  tooltip(hovered.empty() ? "To the left is fast, down is exact. The square is what is shown." : hovered);
  for (const auto& entry : entries)
    if (entry.method == shown.method->id() && entry.settings == settings) note(about(entry));
}

}  // namespace plume
