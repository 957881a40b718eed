#include "sandbox/debugger/method_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <tuple>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

std::string help_of(const NumberInfo& info) {
  return fmt::format("{}\n{}", info.help, limits_text(info.min, info.max, info.unit));
}

/// One widget a parameter.
class ParameterWidgets : public ParameterVisitor {
 public:
  void number(std::string_view name, float& value, const NumberInfo& info) override {
    const bool wide = info.min > 0 && info.max / info.min >= 100;
    const auto flags = ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
    const std::string format = number_format("%.4g", info.unit);
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
    const std::string format = number_format("%d", info.unit);
    const int low = int(info.min), high = int(info.max);
    // A slider has a pixel for each value, or nearly; ImGui's takes half of all integers at most.
    const bool many = info.max - info.min > 1e5;
    changed_ |= many ? ImGui::DragInt(std::string(name).c_str(), &value, 1, low, high, format.c_str(),
                                      ImGuiSliderFlags_AlwaysClamp)
                     : ImGui::SliderInt(std::string(name).c_str(), &value, low, high, format.c_str(),
                                        ImGuiSliderFlags_AlwaysClamp);
    tooltip(help_of(info));
  }
  void toggle(std::string_view name, bool& value, std::string_view help) override {
    changed_ |= ImGui::Checkbox(std::string(name).c_str(), &value);
    name_widget(fmt::format("parameter {} = {}", name, value));
    tooltip(help);
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view help) override {
    const bool open =
        ImGui::BeginCombo(std::string(name).c_str(), std::string(options[size_t(value)]).c_str());
    if (!open) {
      name_widget(fmt::format("parameter {} = {}", name, options[size_t(value)]));
      return tooltip(help);
    }
    for (int i = 0; i < int(options.size()); ++i) {
      if (ImGui::Selectable(std::string(options[size_t(i)]).c_str(), i == value) && i != value) {
        value = i;
        changed_ = true;
      }
      name_widget(fmt::format("parameter {}: {}", name, options[size_t(i)]));
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

void pick_method(Workspace& workspace, Side& side) {
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##method", side.method().owner.c_str(), ImGuiComboFlags_HeightLargest);
  if (!open) {
    name_widget("method = " + side.method().owner);
    return tooltip(about(*side.method().method));
  }
  for (size_t i = 0; i < side.methods.size(); ++i) {
    const Method& method = *side.methods[i].method;
    const auto missing = method.missing(workspace.device());
    const auto flags = missing.empty() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    if (ImGui::Selectable(side.methods[i].owner.c_str(), i == side.current, flags))
      workspace.choose_method(side, i);
    name_widget("method: " + side.methods[i].owner + (missing.empty() ? "" : " (unavailable)"));
    tooltip(missing.empty() ? about(method) : fmt::format("unavailable: needs {}", fmt::join(missing, ", ")));
  }
  ImGui::EndCombo();
}

void describe_side(Workspace& workspace, Side& side) {
  ImGui::PushID(&side);
  pick_method(workspace, side);
  ImGui::PushID(int(side.current));
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.45f);
  ParameterWidgets widgets;
  side.method().method->visit(widgets);
  if (widgets.changed()) {
    side.timings.clear();
    workspace.change();
  }
  ImGui::PopItemWidth();
  ImGui::PopID();
  ImGui::PopID();
}

void pick_comparison(Workspace& workspace) {
  constexpr std::array<std::tuple<const char*, Comparison, const char*>, 3> kChoices{{
      {"one", Comparison::kNone, "method A alone"},
      {"split", Comparison::kSplit, "A to the left, B to the right of a divider that can be dragged (V)"},
      {"flip", Comparison::kFlip, "B in the place of A (X, and X again)"},
  }};
  for (const auto& [name, comparison, help] : kChoices) {
    if (ImGui::RadioButton(name, workspace.comparison() == comparison)) workspace.compare(comparison);
    name_widget(fmt::format("comparison {} = {}", name, workspace.comparison() == comparison));
    tooltip(help);
    ImGui::SameLine();
  }
  ImGui::NewLine();
}

}  // namespace

void method_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  pick_comparison(workspace);
  if (workspace.comparison() == Comparison::kNone) return describe_side(workspace, workspace.a);
  text("A");
  describe_side(workspace, workspace.a);
  ImGui::Separator();
  text("B");
  describe_side(workspace, workspace.b);
}

}  // namespace plume
