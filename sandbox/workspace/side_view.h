// What a side shows instead of its method's picture: one of the views that can be looked at, coloured.
#ifndef PLUME_WORKSPACE_SIDE_VIEW_H
#define PLUME_WORKSPACE_SIDE_VIEW_H

#include "sandbox/measure/inspector.h"
#include "sandbox/measure/value_map.h"

namespace plume {

struct SideView : ViewChoice {
  std::optional<Inspected> shown;  ///< of the last drawing; nothing: it shows the picture
  ValueScale scale;                ///< that it is coloured by
  ValueRange found;

  /// Shows another one, on the scale that suits it.
  void choose(const Inspection& view);
  /// Draws the frame; then, if the method has this view, puts it into the targets' displayed image. Otherwise
  /// the picture stays there.
  FrameReport draw(const Subject& subject, MethodInstance& instance, Inspector& inspector);
};

}  // namespace plume
#endif
