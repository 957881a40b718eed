#include "sandbox/debugger/history_graph.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

// By brightness too, in the order of the stack: readable without colours.
constexpr std::array<ImU32, 5> kShades{IM_COL32(58, 82, 139, 255), IM_COL32(33, 145, 140, 255),
                                       IM_COL32(94, 201, 98, 255), IM_COL32(253, 231, 37, 255),
                                       IM_COL32(160, 160, 160, 255)};

/// 1, 2 or 5 times a power of ten, at least `ms`.
double round_up(double ms) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(ms, 1e-3))));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= ms) return step * power;
  return 10 * power;
}

std::string legend(const std::vector<TimingHistory::Groups>& frames) {
  std::string text;
  for (size_t g = 0; g < kPassGroupNames.size(); ++g) {
    std::vector<double> ms;
    for (const auto& frame : frames) ms.push_back(frame[g]);
    std::ranges::nth_element(ms, ms.begin() + long(ms.size() / 2));
    text += fmt::format("{}{} {:.1f}", g ? ", " : "", kPassGroupNames[g], ms[ms.size() / 2]);
  }
  return text;
}

}  // namespace

void history_graph(const TimingHistory& history) {
  const auto frames = history.groups();
  if (frames.empty()) return;
  double most = 0;
  for (const auto& frame : frames) most = std::max(most, std::accumulate(frame.begin(), frame.end(), 0.0));
  most = round_up(most);

  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, 5 * line};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  const float width = size.x / float(TimingHistory::kFrames);
  for (size_t i = 0; i < frames.size(); ++i) {
    const float x = corner.x + size.x - width * float(frames.size() - i);
    float bottom = corner.y + size.y;
    for (size_t g = 0; g < frames[i].size(); ++g) {
      const float top = bottom - float(frames[i][g] / most) * size.y;
      draw.AddRectFilled({x, top}, {x + std::max(width, 1.0f), bottom}, kShades[g]);
      bottom = top;
    }
  }
  draw.AddText({corner.x + 3, corner.y}, ImGui::GetColorU32(ImGuiCol_Text),
               fmt::format("{:g} ms", most).c_str());
  ImGui::InvisibleButton("history", size);
  tooltip(
      fmt::format("The last {} frames, the newest to the right; from bottom to top simulate, prepass, "
                  "draws, resolve. The frames after a change are dropped.",
                  frames.size()));
  note(fmt::format("from below, median ms: {}", legend(frames)));
}

}  // namespace plume
