#include "sandbox/debugger/playback_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/panel_place.h"

namespace plume {
namespace {

void line(const std::string& text) {
  ImGui::TextUnformatted(text.c_str());
}

}  // namespace

bool playback_panel(const Scene& scene, const PlaybackFacts& facts, Playback& playback,
                    std::optional<CameraKey>& camera) {
  bool changed = false;
  const bool open = ImGui::Begin("Scene", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  place_panel(10, 10);
  if (open) {
    line(
        fmt::format("{}, {}x{} on {}", scene.name, facts.picture_size.x, facts.picture_size.y, facts.device));
    if (ImGui::Button(playback.playing() ? "pause" : "play", {60, 0})) playback.toggle();
    ImGui::SameLine();
    ImGui::SetNextItemWidth(300);
    int tick = int(playback.tick());
    if (ImGui::SliderInt("tick", &tick, 0, int(playback.last_tick()), "%d", ImGuiSliderFlags_AlwaysClamp)) {
      playback.go_to(uint32_t(tick));
      changed = true;
    }
    const std::string speed = facts.frame_ms > 0 ? fmt::format(", {:.1f} fps, {:.1f} ms a frame",
                                                               1000.0 / facts.frame_ms, facts.frame_ms)
                                                 : "";
    line((playback.playing() ? "playing" : "paused") + speed);
    if (camera) {
      ImGui::SameLine();
      if (ImGui::SmallButton("scene's camera")) {
        camera.reset();
        changed = true;
      }
    }
    ImGui::TextDisabled("space play   left, right tick   M method   drag, wheel camera   Esc quit");
  }
  ImGui::End();
  return changed;
}

}  // namespace plume
