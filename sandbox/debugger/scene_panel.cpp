#include "sandbox/debugger/scene_panel.h"

#include <imgui.h>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

void pick_scene(Workspace& workspace) {
  ImGui::SetNextItemWidth(-1);
  if (!ImGui::BeginCombo("##scene", workspace.scene().id.c_str(), ImGuiComboFlags_HeightLargest)) return;
  for (const std::string& id : workspace.library().ids(PresetKind::kScene)) {
    if (!ImGui::Selectable(id.c_str(), id == workspace.scene().id)) continue;
    try {
      workspace.open_scene(id);
    } catch (const std::exception& problem) {
      workspace.problem = problem.what();
    }
  }
  ImGui::EndCombo();
}

}  // namespace

void scene_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  pick_scene(workspace);
  note(workspace.scene().description);
  ImGui::BeginDisabled(!workspace.has_own_camera());
  if (ImGui::Button("scene's camera")) workspace.follow_scene_camera();
  ImGui::EndDisabled();
  tooltip("Follow the camera of the scene again (C). Drag in the picture to take it over.");
}

}  // namespace plume
