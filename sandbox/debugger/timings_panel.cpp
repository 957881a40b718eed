#include "sandbox/debugger/timings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

std::string mebibytes(uint64_t bytes) {
  return fmt::format("{:9.2f}", double(bytes) / (1 << 20));
}

void describe_passes(const TimingHistory& history) {
  if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("pass");
  ImGui::TableSetupColumn("last, ms");
  ImGui::TableSetupColumn(fmt::format("median of {}###median", history.frames()).c_str());
  ImGui::TableHeadersRow();
  for (const TimingHistory::Row& row : history.rows()) {
    cell(row.name);
    cell(fmt::format("{:9.2f}", row.last_ms));
    cell(fmt::format("{:9.2f}", row.median_ms));
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
    describe_passes(side->timings);
    ImGui::PopID();
  }
  ImGui::Checkbox("measure while paused", &workspace.always_draw);
  tooltip("A paused picture is drawn once; with this, again and again, so that the median means something.");
  describe_memory(workspace.device().memory());
}

}  // namespace plume
