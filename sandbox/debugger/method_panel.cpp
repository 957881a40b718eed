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
  /// Buttons, of which one is pressed in.
  void modes(std::string_view name, int& value, std::span<const Mode> modes, std::string_view help) override {
    text(std::string(name));
    tooltip(help);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (int i = 0; i < int(modes.size()); ++i) {
      const auto& [mode, what] = modes[size_t(i)];
      const bool chosen = i == value;
      const std::string label = fmt::format("{}{}", chosen ? "* " : "", mode);
      const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
      if (i > 0 && ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= right)
        ImGui::SameLine();
      if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
      if (ImGui::Button(label.c_str()) && !chosen) {
        value = i;
        changed_ = true;
      }
      if (chosen) ImGui::PopStyleColor();
      name_widget(fmt::format("parameter {} {} = {}", name, mode, chosen));
      tooltip(what);
    }
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

/// Memory, and what the picture lacks. While pictures follow each other the sentences come and go, and what
/// is below keeps its place.
void give_account(Workspace& workspace, Side& side, const MethodAccount& account) {
  const auto& shortfalls = account.shortfalls(side);
  if (!shortfalls) return;
  const uint64_t bytes = workspace.device().memory().owner_bytes(side.method().owner);
  text(fmt::format("{:.1f} MiB of its own", double(bytes) / (1 << 20)));
  tooltip("Images and buffers of this method at this size. Those of all others are in the Cost panel.");
  float& height = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("height of the account"));
  const float top = ImGui::GetCursorPosY();
  for (const std::string& sentence : *shortfalls) warning(sentence, "shortfall");
  if (shortfalls->empty()) note("Nothing was dropped, merged or clamped in this picture.");
  height = std::max(workspace.playback.playing() ? height : 0.0f, ImGui::GetCursorPosY() - top);
  ImGui::SetCursorPosY(top + height);
}

void describe_side(Workspace& workspace, Side& side, const MethodAccount& account) {
  ImGui::PushID(&side);
  pick_method(workspace, side);
  ImGui::PushID(int(side.current));
  give_account(workspace, side, account);
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
  if (workspace.comparison() == Comparison::kNone)
    return describe_side(workspace, workspace.a, interface.account_a);
  text("A");
  describe_side(workspace, workspace.a, interface.account_a);
  ImGui::Separator();
  text("B");
  describe_side(workspace, workspace.b, interface.account_b);
}

}  // namespace plume
