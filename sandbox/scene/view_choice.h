// Which view of a method is looked at in the place of its picture, and in which colours.
#ifndef PLUME_SCENE_VIEW_CHOICE_H
#define PLUME_SCENE_VIEW_CHOICE_H

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace plume {

struct ViewChoice {
  std::string id;                  ///< of an Inspection; empty: the picture
  uint32_t slice = 0;              ///< of the views that have slices
  bool logarithmic = false;        ///< the scale of the colours
  std::optional<glm::vec2> range;  ///< held; nothing: what the view can be, or what is found

  bool operator==(const ViewChoice&) const = default;
};

}  // namespace plume
#endif
