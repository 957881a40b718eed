#include "sandbox/debugger/scene_panel.h"

#include <imgui.h>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

void pick_scene(Workspace& workspace, const std::vector<std::string>& recent) {
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##scene", workspace.scene().id.c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) return name_widget("scene = " + workspace.scene().id);
  const auto offer = [&](const std::string& name) {
    const bool chosen = ImGui::Selectable(name.c_str(), name == workspace.scene().id);
    name_widget("scene: " + name);
    if (!chosen) return;
    try {
      workspace.open_scene(name);
    } catch (const std::exception& problem) {
      workspace.problem = problem.what();
    }
  };
  ImGui::PushID("recent");
  for (const std::string& name : std::vector(recent)) offer(name);  // a copy: opening one changes the list
  ImGui::PopID();
  if (!recent.empty()) ImGui::Separator();
  for (const std::string& id : workspace.library().ids(PresetKind::kScene)) offer(id);
  ImGui::EndCombo();
}

}  // namespace

void scene_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  pick_scene(workspace, interface.settings.recent_scenes);
  note(workspace.scene().description);
  ImGui::BeginDisabled(!workspace.has_own_camera());
  if (ImGui::Button("scene's camera")) workspace.follow_scene_camera();
  ImGui::EndDisabled();
  tooltip("Follow the camera of the scene again (C). Drag in the picture to take it over.");
}

}  // namespace plume
