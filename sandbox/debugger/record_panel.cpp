#include "sandbox/debugger/record_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr std::array kSizes{glm::uvec2(640, 360), glm::uvec2(1280, 720), glm::uvec2(1920, 1080),
                            glm::uvec2(3840, 2160)};

std::string size_name(glm::uvec2 size) {
  return fmt::format("{}x{}", size.x, size.y);
}

/// What is chosen for the next pictures of a range.
struct Choice {
  int first = 0, last = 0, step = 1, end = -1;  ///< the last tick of the scene that they were chosen for
  glm::uvec2 size = kSizes[1];
};

void progress(uint32_t done, uint32_t total, const char* what) {
  ImGui::ProgressBar(total ? float(done) / float(total) : 0.0f, {-5 * ImGui::GetFontSize(), 0},
                     fmt::format("{} {} of {}", what, done, total).c_str());
}

void record(Interface& interface) {
  Recording& recording = interface.recording;
  const Recorder& recorder = recording.recorder();
  if (ImGui::Button(recorder.is_recording() ? "stop and save" : "record"))
    recording.toggle(interface.workspace);
  tooltip(
      "Takes down every picture that is drawn, with its camera, method, parameters, view, scene, effects, "
      "and "
      "what is muted or frozen, as a replay: `plume replay` draws the same pictures again, to the bit "
      "(Ctrl+R). Of a split view, both sides as a picture each. Not taken down: the divider, the panels and "
      "the crosshair, which change no picture.");
  ImGui::SameLine();
  if (ImGui::Button("picture")) recording.save_picture(interface.workspace);
  tooltip("Saves what is seen, without the panels, as PNG (F12).");
  if (recorder.is_recording()) text(fmt::format("recording, {} pictures", recorder.shots()));
}

void choose_range(const Workspace& workspace, Choice& choice) {
  const int end = int(workspace.playback.last_tick());
  if (choice.end != end) choice.first = 0, choice.last = choice.end = end;
  ImGui::SetNextItemWidth(-4 * ImGui::GetFontSize());
  ImGui::DragIntRange2("ticks", &choice.first, &choice.last, 1, 0, end, "from %d", "to %d",
                       ImGuiSliderFlags_AlwaysClamp);
  ImGui::SetNextItemWidth(4 * ImGui::GetFontSize());
  ImGui::DragInt("step", &choice.step, 0.1f, 1, 60, "%d", ImGuiSliderFlags_AlwaysClamp);
  tooltip("Every so many ticks. A video keeps its speed.");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(7 * ImGui::GetFontSize());
  if (ImGui::BeginCombo("size", size_name(choice.size).c_str())) {
    for (const glm::uvec2 size : kSizes)
      if (ImGui::Selectable(size_name(size).c_str(), size == choice.size)) choice.size = size;
    ImGui::EndCombo();
  }
}

void pictures(Interface& interface) {
  static Choice choice;
  Recording& recording = interface.recording;
  choose_range(interface.workspace, choice);
  const bool available = interface.has_ffmpeg;
  ImGui::BeginDisabled(!available);
  ImGui::Checkbox("video", &recording.wants_video);
  ImGui::EndDisabled();
  tooltip(available ? "Made of the pictures by ffmpeg; they are kept."
                    : "There is no ffmpeg in the search path: install it to have a video. The pictures are "
                      "written without it.");
  ImGui::SameLine();
  if (ImGui::Button("write pictures"))
    recording.start_pictures(interface.workspace, {.first = uint32_t(choice.first),
                                                   .last = uint32_t(choice.last),
                                                   .step = uint32_t(choice.step),
                                                   .size = choice.size});
  tooltip("One PNG a tick, at full resolution, of what is seen without the panels.");
}

}  // namespace

void record_panel(Interface& interface) {
  Recording& recording = interface.recording;
  record(interface);
  if (recording.is_busy()) {
    if (recording.sequence())
      progress(recording.sequence()->done(), recording.sequence()->total(), "picture");
    else
      progress(recording.video()->done(), recording.video()->total(), "video, frame");
    ImGui::SameLine();
    if (ImGui::Button("stop")) recording.stop();
  } else {
    pictures(interface);
  }
  if (!recording.said.empty()) note(recording.said);
}

}  // namespace plume
