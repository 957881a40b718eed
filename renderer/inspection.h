// What can be looked at in a frame beyond its picture: views of one number a pixel, and the slices that a
// method cuts depth into.
#ifndef PLUME_RENDERER_INSPECTION_H
#define PLUME_RENDERER_INSPECTION_H

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace plume {

/// One view. Where a pixel has nothing of what it shows, its number is NaN.
struct Inspection {
  std::string id;                       ///< "zero_transmittance"
  std::string title;                    ///< "Zero-transmittance depth"
  std::string help;                     ///< what the number is, and what it leaves out
  std::string unit;                     ///< "m"
  std::optional<glm::vec2> range = {};  ///< of what it can be; nothing: what is found in the picture
  bool logarithmic = false;             ///< its numbers differ by ratios rather than by steps
  uint32_t slices = 0;                  ///< one of so many is shown; 0: there is none to choose
  std::string absent = "nothing";       ///< what a pixel without a number says: "no fragment"
  /// Names of the numbers 1, 2, ..., where they are classes and no amounts.
  std::vector<std::string> classes = {};
  bool over_slices = false;  ///< a chart: columns are the slices in use, front to back from the left
};

/// A slice of a method's own along the rays.
struct DepthSlice {
  float near_m, far_m;     ///< view depths
  uint32_t virtual_slice;  ///< of those adaptation chose, that which it is, or is a part of
};

}  // namespace plume
#endif
