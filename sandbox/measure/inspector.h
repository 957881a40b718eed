// Looking at a method in a frame: its views, and its error against the reference, as numbers on the host.
#ifndef PLUME_MEASURE_INSPECTOR_H
#define PLUME_MEASURE_INSPECTOR_H

#include "renderer/frame.h"
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

/// What is drawn: the same for the method and for the reference it is held against.
struct Subject {
  gpu::Device& device;
  gpu::Pipelines& pipelines;
  const Targets& targets;
  const Prelude& prelude;
  const Transparents& transparents;
};

/// Of the colours of a view in which such numbers were found.
ValueScale scale_of(const ViewChoice& choice, const Inspection& view, const ValueRange& found);

class Inspector {
 public:
  /// inspections_of() the method, and what the reference says of it.
  static std::vector<Inspection> inspections(const Method& method);
  static std::optional<Inspection> find(const Method& method, std::string_view id);

  /// Draws a frame and looks at it: `view` must be among the method's. A view of the error draws the
  /// reference too. Afterwards the targets hold the method's own picture.
  Inspected inspect(const Subject& subject, MethodInstance& instance, const Inspection& view, uint32_t slice);

 private:
  std::optional<MethodInstance> reference_;  // kept, so that its lists have their length
};

}  // namespace plume
#endif
