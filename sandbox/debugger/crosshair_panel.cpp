#include "sandbox/debugger/crosshair_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>

#include "sandbox/debugger/depth_graph.h"
#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"
#include "sandbox/measure/pixel_probe_text.h"

namespace plume {
namespace {

constexpr float kGraphShare = 0.52f;  // of the panel's width

void pick_others(Interface& interface) {
  Workspace& workspace = interface.workspace;
  std::vector<std::string> others = interface.crosshair.others();
  if (ImGui::Button("curves...")) ImGui::OpenPopup("curves");
  name_widget("curves");
  tooltip(
      "More methods beside those that are shown, with the settings they have on side A. Each is drawn once "
      "for "
      "every picture that stands still.");
  if (!ImGui::BeginPopup("curves")) return;
  bool changed = false;
  for (const MethodInstance& instance : workspace.a.methods) {
    const std::string id(instance.method->id());
    const auto chosen = std::ranges::find(others, id);
    bool wanted = chosen != others.end();
    const bool toggled = ImGui::Checkbox(id.c_str(), &wanted);
    name_widget(fmt::format("curve {} = {}", id, wanted));
    if (!toggled) continue;
    changed = true;
    if (wanted)
      others.push_back(id);
    else
      others.erase(chosen);
  }
  ImGui::EndPopup();
  if (changed) interface.crosshair.ask_of_others(workspace, std::move(others));
}

std::string state_of(Interface& interface) {
  const Crosshair& crosshair = interface.crosshair;
  const std::string stale = crosshair.stale_because(interface.workspace);
  const auto waiting = crosshair.waiting(interface.workspace);
  std::string state = stale.empty() ? "" : fmt::format("STALE: {}", stale);
  if (!waiting.empty())
    state += fmt::format("{}{} wait{} until the picture stands still", state.empty() ? "" : "; ",
                         fmt::join(waiting, ", "), waiting.size() == 1 ? "s" : "");
  return state;
}

void toolbar(Interface& interface, DepthGraph& graph) {
  Workspace& workspace = interface.workspace;
  Crosshair& crosshair = interface.crosshair;
  if (ImGui::Button("x")) {
    crosshair.remove(workspace);
    return;
  }
  tooltip("Take the crosshair away (Esc).");
  ImGui::SameLine();
  if (workspace.shown()) {
    const glm::uvec2 size = workspace.shown()->size, pixel = crosshair.pixel(size);
    text(fmt::format("pixel {}, {} of {}x{}", pixel.x, pixel.y, size.x, size.y));
    tooltip("Click in the picture, or hold P and point. Arrow keys move it by one pixel.");
  }
  ImGui::SameLine();
  ImGui::Checkbox("log depth", &graph.logarithmic);
  ImGui::SameLine();
  ImGui::Checkbox("RGB", &graph.each_channel);
  tooltip("A curve for each channel; otherwise their mean.");
  ImGui::SameLine();
  pick_others(interface);
  if (!crosshair.told()) return;
  ImGui::SameLine();
  if (ImGui::Button("copy curves")) ImGui::SetClipboardText(curves_csv(*crosshair.told()).c_str());
  tooltip("CSV, a line for each depth, to the clipboard.");
  ImGui::SameLine();
  if (ImGui::Button("copy fragments")) ImGui::SetClipboardText(fragments_csv(*crosshair.told()).c_str());
  tooltip("CSV, a line for each fragment, to the clipboard.");
  ImGui::SameLine();
  text(state_of(interface));
}

float mean(glm::vec3 t) {
  return (t.r + t.g + t.b) / 3;
}

std::string shares(glm::vec3 t, bool each_channel, bool is_signed) {
  if (!each_channel) return is_signed ? fmt::format("{:+.4f}", mean(t)) : fmt::format("{:.4f}", mean(t));
  return is_signed ? fmt::format("{:+.3f} {:+.3f} {:+.3f}", t.r, t.g, t.b)
                   : fmt::format("{:.3f} {:.3f} {:.3f}", t.r, t.g, t.b);
}

/// Its colour, to see and to read.
void swatch(const PixelFragment& f) {
  const glm::vec3 shown = glm::sqrt(glm::clamp(f.color + f.emission, 0.0f, 1.0f));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetFontSize();
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 2}, {at.x + line, at.y + line - 1},
                                            ImGui::ColorConvertFloat4ToU32({shown.r, shown.g, shown.b, 1}));
  ImGui::Dummy({line, 1});
  ImGui::SameLine(0, 4);
  text(fmt::format("{:.2f} {:.2f} {:.2f}", f.color.r, f.color.g, f.color.b));
}

/// Which fragment the pointer is on, if any.
std::optional<size_t> fragment_table(const PixelProbe& probe, size_t chosen, bool each_channel) {
  std::optional<size_t> pointed_at;
  const MethodAtPixel* method = chosen < probe.methods.size() ? &probe.methods[chosen] : nullptr;
  if (method && method->weights.empty()) method = nullptr;
  constexpr auto kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit |
                          ImGuiTableFlags_ScrollX | ImGuiTableFlags_BordersInnerV;
  if (!ImGui::BeginTable("fragments", method ? 7 : 5, kFlags)) return pointed_at;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* name : {"depth, m", "alpha", "seen, exact"}) ImGui::TableSetupColumn(name);
  if (method) {
    ImGui::TableSetupColumn((method->name + "###weight").c_str());
    ImGui::TableSetupColumn("difference");
  }
  for (const char* name : {"colour", "whose"}) ImGui::TableSetupColumn(name);
  ImGui::TableHeadersRow();
  ImGuiListClipper rows;
  rows.Begin(int(probe.fragments.size()));
  while (rows.Step())
    for (int row = rows.DisplayStart; row < rows.DisplayEnd; ++row) {
      const PixelFragment& f = probe.fragments[size_t(row)];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::Selectable(fmt::format("{:.4f}##{}", f.depth_m, row).c_str(), false,
                        ImGuiSelectableFlags_SpanAllColumns);
      if (ImGui::IsItemHovered()) pointed_at = size_t(row);
      tooltip(
          fmt::format("{}\ncard {}, part {}\ncolour {:.4g} {:.4g} {:.4g}\nemission {:.4g} {:.4g} {:.4g}\n"
                      "lets pass {:.4g} {:.4g} {:.4g}",
                      to_text(f.owner), f.card, f.owner.part, f.color.r, f.color.g, f.color.b, f.emission.r,
                      f.emission.g, f.emission.b, f.transmittance.r, f.transmittance.g, f.transmittance.b));
      cell(fmt::format("{:.4f}", f.alpha));
      cell(shares(f.weight, each_channel, false));
      if (method) {
        const glm::vec3 told = method->weights[size_t(row)];
        cell(shares(told, each_channel, false));
        cell(shares(told - f.weight, each_channel, true));
      }
      ImGui::TableNextColumn();
      swatch(f);
      cell(f.owner.pane ? to_text(f.owner)
                        : fmt::format("{} / {} #{}", f.owner.instance, f.owner.emitter, f.owner.birth));
    }
  ImGui::EndTable();
  return pointed_at;
}

/// Of which method the table tells the weights.
void pick_weights(const PixelProbe& probe, size_t& chosen) {
  if (chosen >= probe.methods.size()) chosen = 0;
  ImGui::AlignTextToFramePadding();
  text(fmt::format("{} fragments; weights of", probe.fragments.size()));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetFontSize() * 13);
  const std::string name = probe.methods.empty() ? "" : probe.methods[chosen].name;
  const bool open = ImGui::BeginCombo("##weights", name.c_str());
  if (!open)
    return tooltip(
        "What the method's draw weighs each fragment by: how much of its light reaches the pixel. Of "
        "weighted "
        "blends, which know no transmittance, it may exceed 1.");
  for (size_t i = 0; i < probe.methods.size(); ++i)
    if (ImGui::Selectable(probe.methods[i].name.c_str(), i == chosen)) chosen = i;
  ImGui::EndCombo();
}

std::string told_of(const PixelProbe& probe) {
  return fmt::format("{} fragments at {},{} of {}x{}", probe.fragments.size(), probe.pixel.x, probe.pixel.y,
                     probe.size.x, probe.size.y);
}

}  // namespace

void crosshair_panel(Interface& interface) {
  CrosshairView& view = interface.crosshair_view;
  toolbar(interface, view.graph);
  if (!interface.crosshair.told()) return;
  const PixelProbe& probe = *interface.crosshair.told();
  const ImVec2 room = ImGui::GetContentRegionAvail(), corner = ImGui::GetCursorScreenPos();
  const float graph_width = kGraphShare * room.x;
  draw_depth_graph(probe, view.graph, {{corner.x, corner.y}, {graph_width, room.y}});
  name_place("graph = " + (state_of(interface).empty() ? told_of(probe) : "waits"), {corner.x, corner.y},
             {graph_width, room.y});
  ImGui::SetCursorScreenPos({corner.x + graph_width, corner.y});
  ImGui::BeginChild("table", {0, 0});
  pick_weights(probe, view.weights_of);
  view.graph.fragment = fragment_table(probe, view.weights_of, view.graph.each_channel);
  ImGui::EndChild();
}

}  // namespace plume
