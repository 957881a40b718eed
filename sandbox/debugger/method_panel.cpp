#include "sandbox/debugger/method_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <cmath>

#include "sandbox/debugger/panel_place.h"

namespace plume {
namespace {

/// `text` with nothing in it that ImGui would take for a placeholder.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '%' ? "%%" : std::string(1, c);
  return result;
}

void tooltip(std::string_view text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 30);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

std::string help_of(const NumberInfo& info) {
  return fmt::format("{}\n{} .. {}{}{}", info.help, info.min, info.max, info.unit.empty() ? "" : " ",
                     info.unit);
}

/// One widget a parameter.
class ParameterWidgets : public ParameterVisitor {
 public:
  void number(std::string_view name, float& value, const NumberInfo& info) override {
    const bool wide = info.min > 0 && info.max / info.min >= 100;
    const auto flags = ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
    const std::string format = info.unit.empty() ? "%.4g" : "%.4g " + escaped(info.unit);
    float wanted = value;
    if (ImGui::SliderFloat(std::string(name).c_str(), &wanted, float(info.min), float(info.max),
                           format.c_str(), flags) &&
        std::isfinite(wanted)) {  // a typed "nan" passes the slider's clamp
      value = wanted;
      changed_ = true;
    }
    tooltip(help_of(info));
  }
  void integer(std::string_view name, int& value, const NumberInfo& info) override {
    const std::string format = info.unit.empty() ? "%d" : "%d " + escaped(info.unit);
    changed_ |= ImGui::SliderInt(std::string(name).c_str(), &value, int(info.min), int(info.max),
                                 format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    tooltip(help_of(info));
  }
  void toggle(std::string_view name, bool& value, std::string_view help) override {
    changed_ |= ImGui::Checkbox(std::string(name).c_str(), &value);
    tooltip(help);
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view help) override {
    const bool open =
        ImGui::BeginCombo(std::string(name).c_str(), std::string(options[size_t(value)]).c_str());
    if (!open) return tooltip(help);
    for (int i = 0; i < int(options.size()); ++i)
      if (ImGui::Selectable(std::string(options[size_t(i)]).c_str(), i == value) && i != value) {
        value = i;
        changed_ = true;
      }
    ImGui::EndCombo();
  }
  bool changed() const { return changed_; }

 private:
  bool changed_ = false;
};

std::string about(const Method& method) {
  const Traits traits = method.traits();
  return fmt::format("{}\nSource: {}\nTransmission: {}\nEmission: {}\nOutputs: {}\nLimits: {}", traits.title,
                     traits.source, traits.transmission, traits.emission, to_text(method.outputs()),
                     traits.limits);
}

bool pick_method(const gpu::Device& device, std::span<const MethodInstance> methods, size_t& current) {
  bool picked = false;
  const bool open = ImGui::BeginCombo("method", methods[current].owner.c_str());
  if (!open) {
    tooltip(about(*methods[current].method));
    return false;
  }
  for (size_t i = 0; i < methods.size(); ++i) {
    const auto missing = methods[i].method->missing(device);
    const auto flags = missing.empty() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    if (ImGui::Selectable(methods[i].owner.c_str(), i == current, flags) && i != current) {
      current = i;
      picked = true;
    }
    tooltip(missing.empty() ? about(*methods[i].method)
                            : fmt::format("unavailable: needs {}", fmt::join(missing, ", ")));
  }
  ImGui::EndCombo();
  return picked;
}

}  // namespace

bool method_panel(const gpu::Device& device, std::span<const MethodInstance> methods, size_t& current) {
  bool changed = false;
  const bool open = ImGui::Begin("Method", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  place_panel(10, 150);
  if (open) {
    ImGui::PushItemWidth(200);
    changed = pick_method(device, methods, current);
    ImGui::Separator();
    ImGui::PushID(int(current));
    ParameterWidgets widgets;
    methods[current].method->visit(widgets);
    changed |= widgets.changed();
    ImGui::PopID();
    ImGui::PopItemWidth();
  }
  ImGui::End();
  return changed;
}

}  // namespace plume
