// What a camera sees: the pyramid from its eye through the edges of the picture, cut off at the near plane,
// without an end. Says of a box whether any of it may be in there.
#ifndef PLUME_EFFECTS_VIEW_VOLUME_H
#define PLUME_EFFECTS_VIEW_VOLUME_H

#include <array>

#include "sandbox/effects/bounds.h"
#include "shaders/shared/view.h"

namespace plume {

struct ViewVolume {
  /// A point is inside where dot(normal, point) >= distance for each.
  struct Plane {
    glm::vec3 normal;  // not of unit length
    float distance;
  };
  std::array<Plane, 5> planes;  // near, left, right, bottom, top
  Bounds hull;                  // infinite where it reaches without end
};

/// `widen` takes in that much of the picture's half width and height beyond its edges.
ViewVolume view_volume(const shared::ViewData& view, float widen = 1.0f);

/// False only when no point of the box is in the volume; true for some boxes outside, near its edges.
bool may_touch(const ViewVolume& volume, const Bounds& bounds);

}  // namespace plume
#endif
