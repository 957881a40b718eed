#include "sandbox/debugger/widget_places.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace plume {
namespace {

const char* file_of_places() {
  static const char* const file = std::getenv("PLUME_WIDGET_PLACES");
  return file;
}

/// ImGui's widgets are described to a context of the whole program; so are their names.
std::string& places() {
  static std::string places;
  return places;
}

}  // namespace

void name_widget(std::string_view name) {
  if (!file_of_places() || !ImGui::IsItemVisible()) return;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  places() += fmt::format("{:.0f} {:.0f} {:.0f} {:.0f} {}\n", from.x, from.y, to.x, to.y, name);
}

void write_widget_places() {
  static std::string written;
  if (!file_of_places()) return;
  if (places() != written) {
    const std::string fresh = std::string(file_of_places()) + ".new";
    std::ofstream(fresh) << places();
    std::filesystem::rename(fresh, file_of_places());
    written = places();
  }
  places().clear();
}

}  // namespace plume
