#include "sandbox/debugger/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

namespace plume {

bool wants_tooltip() {
  return ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
}

void tooltip(std::string_view text) {
  if (!wants_tooltip()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void text(const std::string& text) {
  ImGui::TextUnformatted(text.c_str());
}

void note(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

std::string number_format(std::string_view digits, std::string_view unit) {
  std::string format(digits);
  if (!unit.empty()) format += ' ';
  for (const char c : unit) format += c == '%' ? "%%" : std::string(1, c);  // else a placeholder
  return format;
}

std::string limits_text(double min, double max, std::string_view unit) {
  return fmt::format("{:g} .. {:g}{}{}", min, max, unit.empty() ? "" : " ", unit);
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

}  // namespace plume
