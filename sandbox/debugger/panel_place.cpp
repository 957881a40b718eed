#include "sandbox/debugger/panel_place.h"

#include <imgui.h>

namespace plume {

void place_panel(float x, float y) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGuiStorage& memory = *ImGui::GetStateStorage();  // of the panel
  const ImGuiID width = ImGui::GetID("placed for width"), height = ImGui::GetID("placed for height");
  if (memory.GetFloat(width) == window.x && memory.GetFloat(height) == window.y) return;
  memory.SetFloat(width, window.x);
  memory.SetFloat(height, window.y);
  ImGui::SetWindowPos({x < 0 ? window.x + x : x, y});
}

}  // namespace plume
