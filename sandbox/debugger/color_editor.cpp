#include "sandbox/debugger/color_editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "sandbox/debugger/number_editor.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/measure/image.h"
#include "sandbox/workspace/key_edits.h"

namespace plume {
namespace {

float brightest(glm::vec3 color) {
  return std::max({color.r, color.g, color.b});
}

ImVec4 encoded(glm::vec3 linear, float most) {
  const auto channel = [&](float value) { return srgb_from_linear(std::clamp(value / most, 0.0f, 1.0f)); };
  return {channel(linear.r), channel(linear.g), channel(linear.b), 1};
}

/// What the eye tells apart.
constexpr float kGrain = 0.001f;

}  // namespace

ImU32 shown_color(glm::vec3 linear, float most) {
  return ImGui::ColorConvertFloat4ToU32(encoded(linear, most));
}

bool edit_color(const char* id, glm::vec3& linear, const Limits& limits) {
  ImGui::PushID(id);
  const float width = ImGui::CalcItemWidth(), height = ImGui::GetFrameHeight();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float most = std::max(1.0f, brightest(linear));
  ImVec4 color = encoded(linear, most);
  if (ImGui::ColorButton("swatch", color, ImGuiColorEditFlags_NoTooltip, {height, height}))
    ImGui::OpenPopup("picker");
  name_widget(fmt::format("{} swatch", id));
  tooltip("Opens a colour picker. The numbers are linear light.");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width - height - gap);
  bool changed = edit_numbers("##numbers", {&linear.x, 3}, limits);
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0f);  // what the file does not say is dim, this is not
  if (ImGui::BeginPopup("picker")) {
    if (ImGui::ColorPicker3("##hue", &color.x, ImGuiColorEditFlags_NoSidePreview)) {
      const float largest = float(limits.max);
      const auto channel = [&](float value) {
        return std::min(rounded(linear_from_srgb(value) * most, kGrain * most), largest);
      };
      linear = {channel(color.x), channel(color.y), channel(color.z)};
      changed = true;
    }
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
  return changed;
}

}  // namespace plume
