#include "sandbox/debugger/widget_places.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
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
  const ImVec2 from = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
  name_place(name, {from.x, from.y}, {size.x, size.y});
}

void name_place(std::string_view name, glm::vec2 corner, glm::vec2 size) {
  if (!file_of_places()) return;
  std::string one_line(name);
  std::ranges::replace(one_line, '\n', ' ');
  const glm::vec2 end = corner + size;
  places() += fmt::format("{:.0f} {:.0f} {:.0f} {:.0f} {}\n", corner.x, corner.y, end.x, end.y, one_line);
}

void write_widget_places() {
  static uint64_t frame = 0;
  if (!file_of_places()) return;
  name_place(fmt::format("frame = {}", ++frame), {0, 0}, {0, 0});
  const std::string fresh = std::string(file_of_places()) + ".new";
  std::ofstream(fresh) << places();
  std::filesystem::rename(fresh, file_of_places());
  places().clear();
}

}  // namespace plume
