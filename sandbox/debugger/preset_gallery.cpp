#include "sandbox/debugger/preset_gallery.h"

#include <fmt/format.h>

#include <algorithm>

#include "sandbox/measure/image_io.h"

namespace plume {
namespace {

constexpr int kBorder = 1;         // repeats the picture's edge, so that nothing else is filtered into it
constexpr int kAtlasWidth = 2048;  // 12 pictures; a thousand of them are 8 thousand rows

DisplayImage read_small(const std::filesystem::path& file) {
  DisplayImage picture = read_png(file);
  if (glm::uvec2(picture.width, picture.height) != kPictureSize)
    throw FileError(file,
                    fmt::format("a picture of {}, expected {}", size_text(picture.width, picture.height),
                                size_text(int(kPictureSize.x), int(kPictureSize.y))));
  return picture;
}

}  // namespace

void PresetGallery::draw(ImDrawList& draw, PresetKind kind, const std::string& name, ImVec2 from, ImVec2 to) {
  Shown& preset = shown(kind, name);
  if (preset.place < 0 && preset.no_picture.empty()) wants_texture_ = true;
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (preset.place >= 0) {
    ImFontAtlasCustomRect inner = const_cast<ImFontAtlas&>(atlas).CustomRects[preset.place];
    inner.X = static_cast<unsigned short>(inner.X + kBorder), inner.Width -= 2 * kBorder;
    inner.Y = static_cast<unsigned short>(inner.Y + kBorder), inner.Height -= 2 * kBorder;
    ImVec2 first, last;
    atlas.CalcCustomRectUV(&inner, &first, &last);
    return draw.AddImage(atlas.TexID, from, to, first, last);
  }
  draw.AddRectFilled(from, to, IM_COL32(45, 47, 52, 255));
  if (preset.no_picture.empty()) return;  // it comes with the next frame
  const char* words = "no picture";
  const ImVec2 size = ImGui::CalcTextSize(words);
  draw.PushClipRect(from, to, true);
  draw.AddText({0.5f * (from.x + to.x - size.x), 0.5f * (from.y + to.y - size.y)},
               IM_COL32(170, 170, 175, 255), words);
  draw.PopClipRect();
}

const std::string& PresetGallery::about(PresetKind kind, const std::string& name) {
  Shown& preset = shown(kind, name);
  if (preset.about) return *preset.about;
  const auto words = [](const auto& read) {
    return read.description.empty() ? read.name : read.name + "\n" + read.description;
  };
  try {
    preset.about = kind == PresetKind::kScene ? words(library_.scene(name)) : words(library_.effect(name));
  } catch (const std::exception& mistakes) {
    preset.about = mistakes.what();
  }
  return *preset.about;
}

void PresetGallery::reserve(ImFontAtlas& atlas) {
  wants_texture_ = false;
  for (auto& [key, preset] : shown_) {
    preset.place = -1;
    if (preset.picture || !preset.no_picture.empty()) continue;
    try {
      const auto file = library_.picture(key.first, key.second);
      if (file)
        preset.picture = read_small(*file);
      else
        preset.no_picture = "there is none";
    } catch (const FileError& damaged) {
      preset.no_picture = damaged.what();
      preset.about = about(key.first, key.second) + "\n" + damaged.what();
    }
  }
  for (auto& [key, preset] : shown_) {
    if (!preset.picture) continue;
    atlas.TexDesiredWidth = kAtlasWidth;
    preset.place =
        atlas.AddCustomRectRegular(preset.picture->width + 2 * kBorder, preset.picture->height + 2 * kBorder);
  }
}

void PresetGallery::paint(ImFontAtlas& atlas) const {
  unsigned char* texels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&texels, &width, &height);
  for (const auto& [key, preset] : shown_) {
    if (preset.place < 0) continue;
    const ImFontAtlasCustomRect& place = atlas.CustomRects[preset.place];
    const DisplayImage& picture = *preset.picture;
    for (int y = 0; y < place.Height; ++y)
      for (int x = 0; x < place.Width; ++x) {
        const auto& color = picture.at(std::clamp(x - kBorder, 0, picture.width - 1),
                                       std::clamp(y - kBorder, 0, picture.height - 1));
        unsigned char* texel = texels + 4 * (size_t(place.Y + y) * size_t(width) + size_t(place.X + x));
        std::copy(color.begin(), color.end(), texel);
        texel[3] = 255;
      }
  }
}

}  // namespace plume
