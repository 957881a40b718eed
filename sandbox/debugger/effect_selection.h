// Which effect is worked on in the window, and what of it.
#ifndef PLUME_DEBUGGER_EFFECT_SELECTION_H
#define PLUME_DEBUGGER_EFFECT_SELECTION_H

#include <optional>
#include <string>

#include "sandbox/debugger/depth_ruler.h"

namespace plume {

/// Kept from one picture to the next: to read them waits for the device.
struct SeenDepths {
  uint64_t picture = 0;  ///< see Workspace::picture()
  std::string instance;
  double at_s = -1e9;  ///< when they were read: a playing scene would wait at every picture
  std::vector<EmitterDepths> emitters;
  DepthBins bins;
  SlicedDepth slices;
};

/// An instance that the pointer has hold of.
struct HeldInstance {
  glm::vec3 place;
  glm::vec2 off;  ///< of its mark from the pointer, screen coordinates
};

struct EffectSelection {
  std::string name;                  ///< as the scene calls it; empty: none
  std::optional<size_t> emitter;     ///< nothing: the effect as a whole
  std::string instance;              ///< of the scene, that was clicked; indices change as others come and go
  bool only_set = false;             ///< hides fields that the file does not say
  std::string refused;               ///< why the last edit was not made
  std::string placing;               ///< effect that the next click in the picture drops there
  std::optional<HeldInstance> held;  ///< the selected one is being moved
  SeenDepths depths;
};

}  // namespace plume
#endif
