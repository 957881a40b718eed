// Looking at a method in a frame: its views, and its error against the reference, as numbers on the host.
#ifndef PLUME_MEASURE_INSPECTOR_H
#define PLUME_MEASURE_INSPECTOR_H

#include <map>

#include "sandbox/measure/ground_truth.h"
#include "sandbox/measure/image.h"
#include "sandbox/measure/value_map.h"
#include "sandbox/scene/view_choice.h"

namespace plume {

/// A look at one frame.
struct Inspected {
  Inspection what;
  uint32_t slice = 0;
  Raster<float> values;            ///< NaN where there is nothing
  std::vector<DepthSlice> slices;  ///< of the method, if it has any
  FrameReport report;
};

/// Of the colours of a view in which such numbers were found.
ValueScale scale_of(const ViewChoice& choice, const Inspection& view, const ValueRange& found);

/// Its numbers as a picture, on a scale where they are no classes.
DisplayImage image_of(const Inspected& seen, const ValueScale& scale);

class Inspector {
 public:
  /// Whether a view shows how far the method is from the reference.
  static bool needs_reference(std::string_view id);
  /// inspections_of() the method, and what the reference says of it.
  static std::vector<Inspection> inspections(const Method& method);
  static std::optional<Inspection> find(const Method& method, std::string_view id);

  /// Draws a frame and looks at it: `view` must be among the method's. A view of the error draws the
  /// reference too, unless it is known. Afterwards the targets hold the method's own picture.
  Inspected inspect(const Subject& subject, MethodInstance& instance, const Inspection& view, uint32_t slice);

  /// The reference's picture; what changes it must be told: GroundTruth::forget().
  GroundTruth truth;
  /// No view of the error is shown any more: forgets all of them, and the reference.
  void release();

 private:
  /// An error map, by the owner of what it is of: for as long as neither picture changes, it is the same.
  struct ErrorMap {
    std::string view;
    DrawnPicture picture;
    Raster<float> values;
  };
  std::map<std::string, ErrorMap> errors_;
};

}  // namespace plume
#endif
