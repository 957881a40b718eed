#include "sandbox/debugger/timeline.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

void pick_speed(Playback& playback) {
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5);
  if (ImGui::BeginCombo("speed", fmt::format("{:g}x", playback.speed).c_str())) {
    for (const double speed : kSpeeds)
      if (ImGui::Selectable(fmt::format("{:g}x", speed).c_str(), speed == playback.speed))
        playback.speed = speed;
    ImGui::EndCombo();
  }
  tooltip("Times real time. Every tick is drawn: a slow device plays slower, not coarser.");
}

void transport(Workspace& workspace) {
  Playback& playback = workspace.playback;
  const float line = ImGui::GetFontSize();
  const uint32_t before = playback.tick();
  if (ImGui::Button(playback.playing() ? "pause" : "play", {4 * line, 0})) playback.toggle();
  name_widget(playback.playing() ? "play = playing" : "play = paused");
  tooltip("Space");
  ImGui::SameLine();
  if (ImGui::Button("<")) playback.step_back();
  tooltip("one tick back (Comma)");
  ImGui::SameLine();
  if (ImGui::Button(">")) playback.step_forward();
  tooltip("one tick on (Period)");
  ImGui::SameLine();
  ImGui::Checkbox("loop", &playback.loops);
  ImGui::SameLine();
  pick_speed(playback);
  ImGui::SameLine();
  int tick = int(playback.tick());
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const std::string format = fmt::format("tick %d of {}, {:.2f} s", playback.last_tick(), tick / 60.0);
  if (ImGui::SliderInt("##tick", &tick, 0, int(playback.last_tick()), format.c_str(),
                       ImGuiSliderFlags_AlwaysClamp))
    playback.go_to(uint32_t(tick));
  name_widget(fmt::format("tick = {}", playback.tick()));
  tooltip(
      "Any tick is reached exactly, by the closed form of births and a seek: drag, or Ctrl+click to type.");
  if (playback.tick() != before) workspace.change();
}

void quality(Interface& interface) {
  Workspace& workspace = interface.workspace;
  ResolutionControl& control = workspace.resolution;
  if (ImGui::Checkbox("hold", &control.adapts)) workspace.change();
  name_widget(fmt::format("hold = {}", control.adapts));
  tooltip("Draws coarser while things move, as far as this rate needs (R).");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 7);
  float rate = float(control.frames_per_second);
  if (ImGui::SliderFloat("##rate", &rate, 2, 60, "%.0f fps", ImGuiSliderFlags_AlwaysClamp))
    control.frames_per_second = double(rate);
  ImGui::SameLine();
  ImGui::BeginDisabled(control.adapts);
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
  const auto percent = [](double scale) { return fmt::format("{:g} %", 100 * scale); };
  if (!ImGui::BeginCombo("resolution", percent(control.scale()).c_str())) {
    name_widget("resolution = " + percent(control.scale()));
  } else {
    for (size_t step = 0; step < ResolutionControl::kScales.size(); ++step) {
      const std::string name = percent(ResolutionControl::kScales[step]);
      if (ImGui::Selectable(name.c_str(), step == control.step())) {
        control.set_step(step);
        workspace.change();
      }
      name_widget("resolution: " + name);
    }
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  tooltip("Of the window's pixels, each way. To choose it, stop holding a rate.");
  ImGui::SameLine();
  const std::optional<Targets>& targets =
      workspace.shows(workspace.a) ? workspace.a.targets : workspace.b.targets;
  const glm::uvec2 size = targets ? targets->size : glm::uvec2(0);
  const std::string state =
      fmt::format("{}x{}, {:.0f} ms a picture ({:.1f} a second) on {}", size.x, size.y, workspace.frame_ms(),
                  workspace.frame_ms() > 0 ? 1000 / workspace.frame_ms() : 0, workspace.device().info().name);
  const float keys_at = ImGui::GetWindowWidth() - 6 * ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetWindowPos();
  ImGui::PushClipRect(
      corner, {corner.x + keys_at - ImGui::GetStyle().ItemSpacing.x, corner.y + ImGui::GetWindowHeight()},
      true);  // large text may need more room than there is
  text(state);
  tooltip(state);
  ImGui::PopClipRect();
  ImGui::SameLine(keys_at);
  if (ImGui::SmallButton("keys (F1)")) interface.help = !interface.help;
}

}  // namespace

void timeline(Interface& interface) {
  transport(interface.workspace);
  quality(interface);
}

}  // namespace plume
