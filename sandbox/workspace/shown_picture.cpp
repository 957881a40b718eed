#include "sandbox/workspace/shown_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sandbox/measure/picture.h"

namespace plume {

DisplayImage shown_picture(Workspace& workspace) {
  const auto drawn = [&](const Side& side) {
    if (!side.targets) throw std::runtime_error("nothing was drawn yet, so there is no picture to save");
    return read_picture(workspace.device(), *side.targets).display;
  };
  if (workspace.comparison() != Comparison::kSplit)
    return drawn(workspace.shows(workspace.a) ? workspace.a : workspace.b);
  DisplayImage left = drawn(workspace.a);
  const DisplayImage right = drawn(workspace.b);
  const auto border = std::ptrdiff_t(std::lround(workspace.divider * float(left.width)));
  for (std::ptrdiff_t row = 0; row < left.height; ++row) {
    const auto from = right.pixels.begin() + row * left.width;
    std::copy(from + border, from + left.width, left.pixels.begin() + row * left.width + border);
  }
  return left;
}

}  // namespace plume
