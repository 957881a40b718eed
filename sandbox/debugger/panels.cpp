#include "sandbox/debugger/panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "sandbox/debugger/crosshair_mark.h"
#include "sandbox/debugger/crosshair_panel.h"
#include "sandbox/debugger/effects_panel.h"
#include "sandbox/debugger/file_questions.h"
#include "sandbox/debugger/instance_marks.h"
#include "sandbox/debugger/keys.h"
#include "sandbox/debugger/method_panel.h"
#include "sandbox/debugger/record_panel.h"
#include "sandbox/debugger/scene_panel.h"
#include "sandbox/debugger/timeline.h"
#include "sandbox/debugger/timings_panel.h"
#include "sandbox/debugger/view_key.h"
#include "sandbox/debugger/view_panel.h"
#include "sandbox/debugger/viewport_marks.h"
#include "sandbox/debugger/widget_places.h"

namespace plume {
namespace {

enum class Dock { kLeft, kRight };

struct Panel {
  const char* title;
  Dock dock;
  void (*describe)(Interface&);
};

constexpr std::array kPanels{
    Panel{"Scene", Dock::kLeft, scene_panel},     Panel{"View", Dock::kLeft, view_panel},
    Panel{"Effects", Dock::kLeft, effects_panel}, Panel{"Record", Dock::kLeft, record_panel},
    Panel{"Method", Dock::kRight, method_panel},  Panel{"Cost", Dock::kRight, timings_panel},
};

// In lines of text, so that they grow with the font.
constexpr float kLeftWidth = 24, kRightWidth = 24, kTimelineHeight = 4.6f, kCrosshairHeight = 19;
constexpr float kMostWidth = 0.4f;  // of the window: however large the text is, a picture is left

constexpr ImGuiWindowFlags kDocked = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoBringToFrontOnFocus;

void describe_dock(const char* name, Dock dock, Area area, Interface& interface) {
  ImGui::SetNextWindowPos({area.corner.x, area.corner.y});
  ImGui::SetNextWindowSize({area.size.x, area.size.y});
  if (ImGui::Begin(name, nullptr, kDocked))
    for (const Panel& panel : kPanels) {
      if (panel.dock != dock) continue;
      const bool open = ImGui::CollapsingHeader(panel.title, ImGuiTreeNodeFlags_DefaultOpen);
      name_widget(panel.title);
      if (!open) continue;
      ImGui::PushID(panel.title);
      panel.describe(interface);
      ImGui::PopID();
      ImGui::Spacing();
    }
  ImGui::End();
}

/// What went wrong, over the picture until it is read.
void describe_problem(Interface& interface, Area picture) {
  std::string& problem = interface.workspace.problem;
  if (problem.empty()) return;
  ImGui::SetNextWindowPos(
      {picture.corner.x + 0.5f * picture.size.x, picture.corner.y + 0.5f * picture.size.y},
      ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowBgAlpha(1);
  bool open = true;
  if (ImGui::Begin("Something went wrong", &open,
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 36);
    ImGui::TextUnformatted(problem.c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("OK")) open = false;
    name_widget("problem = " + problem);
    ImGui::SameLine();
    if (ImGui::Button("Copy")) ImGui::SetClipboardText(problem.c_str());
  }
  ImGui::End();
  if (!open) problem.clear();
}

}  // namespace

Area describe_panels(Interface& interface) {
  const float line = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  Area picture{{0, 0}, {window.x, window.y}};
  if (interface.panels) {
    const float left = std::min(kLeftWidth * line, kMostWidth * window.x),
                right = std::min(kRightWidth * line, kMostWidth * window.x),
                timeline_height = kTimelineHeight * line;
    const float crosshair_height = interface.crosshair.placed() ? kCrosshairHeight * line : 0;
    const float bottom = timeline_height + crosshair_height;
    describe_dock("left", Dock::kLeft, {{0, 0}, {left, window.y - bottom}}, interface);
    describe_dock("right", Dock::kRight, {{window.x - right, 0}, {right, window.y - bottom}}, interface);
    if (crosshair_height > 0) {
      ImGui::SetNextWindowPos({0, window.y - bottom});
      ImGui::SetNextWindowSize({window.x, crosshair_height});
      if (ImGui::Begin("crosshair", nullptr, kDocked | ImGuiWindowFlags_NoScrollbar))
        crosshair_panel(interface);
      ImGui::End();
    }
    ImGui::SetNextWindowPos({0, window.y - timeline_height});
    ImGui::SetNextWindowSize({window.x, timeline_height});
    if (ImGui::Begin("timeline", nullptr, kDocked | ImGuiWindowFlags_NoScrollbar)) timeline(interface);
    ImGui::End();
    picture = {{left, 0}, {window.x - left - right, window.y - bottom}};
  }
  picture.size = glm::max(picture.size, glm::vec2(1));
  interface.picture = picture;
  mark_views(interface, picture);
  mark_viewport(interface, picture);
  mark_instances(interface, picture);
  mark_crosshair(interface, picture);
  ask_about_files(interface);
  ask_for_scene_name(interface);
  describe_problem(interface, picture);
  describe_keys(interface);
  const Workspace& workspace = interface.workspace;
  name_place("picture = " + (workspace.is_outdated() ? "outdated" : std::to_string(workspace.picture())),
             picture.corner, picture.size);
  const Recorder& recorder = interface.recording.recorder();
  name_place("record = " + (recorder.is_recording() ? std::to_string(recorder.shots()) : "off"), {0, 0},
             {0, 0});
  name_place(ImGui::GetIO().WantTextInput ? "window = types" : "window = listens", {0, 0},
             {window.x, window.y});
  write_widget_places();
  return picture;
}

}  // namespace plume
