// Picks a scene or an effect by its picture and its name.
#ifndef PLUME_DEBUGGER_PRESET_PICKER_H
#define PLUME_DEBUGGER_PRESET_PICKER_H

#include <optional>
#include <span>
#include <string>

#include "sandbox/debugger/preset_gallery.h"

namespace plume {

struct PickedFrom {
  PresetKind kind;                           ///< effects or scenes
  std::string current = {};                  ///< is framed
  std::span<const std::string> recent = {};  ///< stand first
};

/// The list that opens once ImGui::OpenPopup(`id`) was called, to the right of the last widget. What is
/// picked in this frame.
std::optional<std::string> pick_preset(const char* id, const PickedFrom& from, const PresetLibrary& library,
                                       PresetGallery& gallery);

}  // namespace plume
#endif
