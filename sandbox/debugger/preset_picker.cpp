#include "sandbox/debugger/preset_picker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "sandbox/debugger/widget_places.h"
#include "sandbox/debugger/widgets.h"

namespace plume {
namespace {

constexpr float kPictureLines =
    12.3f;  // width of a picture in lines of text: a pixel is a pixel at the usual size
constexpr int kMostColumns = 5;
constexpr float kMostOfWindow = 0.85f;

/// What is typed to find a preset. There is one list open at a time.
std::array<char, 64>& typed() {
  static std::array<char, 64> words{};
  return words;
}

bool matches(const std::string& name) {
  const auto same = [](char a, char b) { return std::tolower(a) == std::tolower(b); };
  const std::string_view wanted(typed().data());
  return std::search(name.begin(), name.end(), wanted.begin(), wanted.end(), same) != name.end();
}

/// A path by the name of its file.
std::string short_name(const std::string& name) {
  return name.find('/') == name.npos ? name : std::filesystem::path(name).stem().string();
}

bool cell(PresetKind kind, const std::string& name, bool is_current, PresetGallery& gallery, ImVec2 size) {
  const float line = ImGui::GetTextLineHeight(), gap = 0.2f * line;
  const bool picked = ImGui::InvisibleButton(name.c_str(), {size.x, size.y + line + 2 * gap});
  name_widget(fmt::format("{}: {}", kind == PresetKind::kScene ? "scene" : "effect", short_name(name)));
  if (!ImGui::IsItemVisible()) return picked;
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 from = ImGui::GetItemRectMin(), to{from.x + size.x, from.y + size.y};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  gallery.draw(draw, kind, name, from, to);
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  if (is_current) draw.AddRect({from.x - 2, from.y - 2}, {to.x + 2, to.y + 2}, ink, 0, 0, 2);
  if (hovered) draw.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_ButtonActive), 0, 0, 2);
  draw.PushClipRect(from, {to.x, to.y + 2 * gap + line}, true);
  draw.AddText({from.x, to.y + gap}, ink, short_name(name).c_str());
  draw.PopClipRect();
  if (wants_tooltip())
    tooltip(name == short_name(name) ? gallery.about(kind, name) : name + "\n" + gallery.about(kind, name));
  return picked;
}

}  // namespace

std::optional<std::string> pick_preset(const char* id, const PickedFrom& from, const PresetLibrary& library,
                                       PresetGallery& gallery) {
  if (!ImGui::IsPopupOpen(id)) return {};
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const ImGuiStyle& style = ImGui::GetStyle();
  const float em = ImGui::GetFontSize(), width = kPictureLines * em;
  const ImVec2 picture{width, width * float(kPictureSize.y) / float(kPictureSize.x)};
  const float step = width + style.ItemSpacing.x;
  const float extra = 2 * style.WindowPadding.x + style.ScrollbarSize;
  const int columns = std::clamp(int((kMostOfWindow * window.x - extra) / step), 1, kMostColumns);
  const std::vector<std::string> all = library.ids(from.kind);
  const size_t many = all.size() + (from.recent.size() > 1 ? from.recent.size() + size_t(columns) : 0);
  const float rows = float((many + size_t(columns) - 1) / size_t(columns));
  const float height = rows * (picture.y + 2.2f * em + style.ItemSpacing.y) + 6 * em;
  const ImVec2 anchor{ImGui::GetItemRectMax().x + style.ItemSpacing.x, ImGui::GetItemRectMin().y};
  ImGui::SetNextWindowPos(anchor, ImGuiCond_Appearing);
  ImGui::SetNextWindowSize({float(columns) * step + extra, std::min(height, kMostOfWindow * window.y)});
  if (!ImGui::BeginPopup(id)) return {};

  std::optional<std::string> picked;
  if (ImGui::IsWindowAppearing()) {
    typed().fill(0);
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##find", "type a part of the name; Enter takes the first", typed().data(),
                               typed().size(), ImGuiInputTextFlags_EnterReturnsTrue);
  std::optional<std::string> first;
  const auto offer = [&](const char* title, std::span<const std::string> names) {
    int shown = 0;
    for (const std::string& name : names) {
      if (!matches(name)) continue;
      if (shown == 0) note(title);
      if (shown++ % columns != 0) ImGui::SameLine();
      if (!first) first = name;
      if (cell(from.kind, name, name == from.current, gallery, picture)) picked = name;
    }
  };
  ImGui::BeginChild("pictures");
  ImGui::PushID("recent");
  if (from.recent.size() > 1) offer("recent", from.recent);
  ImGui::PopID();
  offer(from.kind == PresetKind::kScene ? "all scenes" : "all effects", all);
  if (!first) note("nothing is called so");
  ImGui::EndChild();
  if (entered && first) picked = first;
  if (picked || pressed_escape()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return picked;
}

}  // namespace plume
