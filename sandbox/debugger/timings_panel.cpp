#include "sandbox/debugger/timings_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "sandbox/debugger/panel_place.h"

namespace plume {
namespace {

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

std::string mebibytes(uint64_t bytes) {
  return fmt::format("{:9.2f}", double(bytes) / (1 << 20));
}

}  // namespace

void timings_panel(const TimingHistory& history, const gpu::Memory& memory, bool& always_draw) {
  const bool open = ImGui::Begin("Cost", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  place_panel(-290, 10);
  if (!open) return ImGui::End();

  if (ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingFixedFit)) {
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
  ImGui::Checkbox("measure while paused", &always_draw);
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "A paused picture is drawn once; with this, again and again, so that the median means something.");

  if (ImGui::BeginTable("memory", 2, ImGuiTableFlags_SizingFixedFit)) {
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
  ImGui::End();
}

}  // namespace plume
