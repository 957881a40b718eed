// The small pictures and the descriptions of presets, for pickers. Nothing is read before it is asked for.
//
// ImGui's Vulkan backend of version 1.86 draws from one texture alone, that of the font, so the pictures
// stand in that: whoever makes the texture lets them in, and makes it anew when pictures were asked for that
// it does not have. A picture is seen from the next frame on.
#ifndef PLUME_DEBUGGER_PRESET_GALLERY_H
#define PLUME_DEBUGGER_PRESET_GALLERY_H

#include <imgui.h>

#include <map>
#include <optional>
#include <string>

#include "sandbox/measure/image.h"
#include "sandbox/presets/library.h"

namespace plume {

class PresetGallery {
 public:
  explicit PresetGallery(const PresetLibrary& library) : library_(library) {}

  /// Draws the picture of an effect or a scene over an area of the screen; a dark one with a few words where
  /// there is none yet, or none that can be read.
  void draw(ImDrawList& draw, PresetKind kind, const std::string& name, ImVec2 from, ImVec2 to);
  /// What the file says it is, or what is wrong with it, and with the picture.
  const std::string& about(PresetKind kind, const std::string& name);
  /// Reads both again when they are asked for.
  void forget(PresetKind kind, const std::string& name) { shown_.erase({kind, name}); }

  /// Whether pictures were asked for that are not in the texture.
  bool wants_texture() const { return wants_texture_; }
  /// Reads those, and keeps room for all in a texture that is not built yet.
  void reserve(ImFontAtlas& atlas);
  /// Writes them into it once it is built.
  void paint(ImFontAtlas& atlas) const;

 private:
  struct Shown {
    std::optional<DisplayImage> picture;
    std::string no_picture;  // why there is none; "": it was not read yet, or there is one
    int place = -1;          // in the atlas
    std::optional<std::string> about;
  };
  Shown& shown(PresetKind kind, const std::string& name) { return shown_[{kind, name}]; }

  const PresetLibrary& library_;
  std::map<std::pair<PresetKind, std::string>, Shown> shown_;
  bool wants_texture_ = false;
};

}  // namespace plume
#endif
