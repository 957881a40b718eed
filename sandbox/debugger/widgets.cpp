#include "sandbox/debugger/widgets.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/widget_places.h"

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

void warning(const std::string& words, const char* name) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Indent(0.6f * ImGui::GetFontSize());
  ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 190, 120, 255));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  name_widget(fmt::format("{} = {}", name, words));
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Unindent(0.6f * ImGui::GetFontSize());
  ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + 3, ImGui::GetItemRectMax().y},
                                            IM_COL32(255, 150, 60, 255));
}

bool begin_question(const char* title) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  return ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
}

bool pressed_escape() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
}

bool pressed_enter() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
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
