#include "sandbox/debugger/timings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/accuracy_graph.h"
#include "sandbox/debugger/history_graph.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

std::string mebibytes(uint64_t bytes) {
  return fmt::format("{:9.2f}", double(bytes) / (1 << 20));
}

void describe_passes(const TimingHistory& history) {
  if (!ImGui::BeginTable("passes", 4, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn("now");
  ImGui::TableSetupColumn("median");
  ImGui::TableSetupColumn("p95, ms");
  ImGui::TableHeadersRow();
  for (const TimingHistory::Row& row : history.rows()) {
    cell(row.name);
    for (const double ms : {row.last_ms, row.median_ms, row.p95_ms}) cell(fmt::format("{:.1f}", ms));
  }
  ImGui::EndTable();
}

void describe_memory(const gpu::Memory& memory) {
  if (!ImGui::BeginTable("memory", 2, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("memory of");
  ImGui::TableSetupColumn("MiB");
  ImGui::TableHeadersRow();
  for (const auto& [owner, bytes] : memory.owners()) {
    if (bytes == 0) continue;
    cell(owner);
    cell(mebibytes(bytes));
  }
  cell("sum");
  cell(mebibytes(memory.total_bytes()));
  ImGui::EndTable();
}

}  // namespace

void timings_panel(Interface& interface) {
  Workspace& workspace = interface.workspace;
  for (Side* side : {&workspace.a, &workspace.b}) {
    if (!workspace.shows(*side)) continue;
    ImGui::PushID(side);
    text(side->method().owner);
    history_graph(side->timings);
    describe_passes(side->timings);
    if (ImGui::SmallButton("copy CSV")) ImGui::SetClipboardText(side->timings.csv().c_str());
    tooltip("A line a frame, a column a pass.");
    ImGui::SameLine();
    if (ImGui::SmallButton("copy JSON")) ImGui::SetClipboardText(side->timings.json().c_str());
    ImGui::SameLine();
    text(fmt::format("{} frames", side->timings.frames()));
    ImGui::PopID();
  }
  text(fmt::format("these panels: {:.1f} ms of a processor a frame", interface.overlay_cpu_ms));
  tooltip(
      "To describe them and to record their drawing; what the device then takes to draw them is not in it. "
      "The median of a second.");
  ImGui::Checkbox("measure while paused", &workspace.always_draw);
  tooltip("A paused picture is drawn once; with this, again and again, so that the median means something.");
  ImGui::Checkbox("compare with the reference", &workspace.compares);
  tooltip(
      "When the picture stands still, measures each method that is shown against the exact one, and gathers "
      "what they cost and how far they are off. It starts anew with another picture.");
  if (workspace.compares) accuracy_graph(workspace.accuracy(), workspace.a.method());
  describe_memory(workspace.device().memory());
}

}  // namespace plume
