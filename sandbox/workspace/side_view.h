// What a side shows instead of its method's picture: one of the views that can be looked at, coloured.
#ifndef PLUME_WORKSPACE_SIDE_VIEW_H
#define PLUME_WORKSPACE_SIDE_VIEW_H

#include "sandbox/measure/inspector.h"
#include "sandbox/measure/value_map.h"

namespace plume {

struct SideView {
  /// Where the colours' range comes from.
  enum class Range {
    kWhole,  ///< what the view can be, where it says so
    kFound,  ///< what is found in the picture; in both where two are shown beside each other
    kHeld    ///< `held`
  };

  std::string id;                 ///< of an Inspection; empty: the picture
  std::optional<uint32_t> slice;  ///< of the views that have slices; nothing: in the middle of those in use
  bool logarithmic = false;       ///< the scale of the colours
  Range range = Range::kFound;
  glm::vec2 held{0, 1};

  std::optional<Inspected> shown;  ///< of the last drawing; nothing: it shows the picture
  ValueScale scale;                ///< that it is coloured by
  ValueRange found;
  bool shares_scale = false;  ///< with the other side

  /// What is shown, on the scale that it is coloured by; nothing chosen: the picture.
  ViewChoice choice() const;
  /// Shows another one, on the scale that suits it.
  void choose(const Inspection& view);
  /// Draws the frame; then, if the method has this view, puts it into the targets' displayed image. Otherwise
  /// the picture stays there.
  FrameReport draw(const Subject& subject, MethodInstance& instance, Inspector& inspector);
  /// Colours two that show the same and are seen beside each other by one scale, unless that is held.
  static void share_scale(gpu::Device& device, SideView& a, const Targets& a_targets, SideView& b,
                          const Targets& b_targets);

 private:
  void color(gpu::Device& device, const Targets& targets, const ValueRange& over);
};

}  // namespace plume
#endif
