// Which effect is worked on in the window, and what of it.
#ifndef PLUME_DEBUGGER_EFFECT_SELECTION_H
#define PLUME_DEBUGGER_EFFECT_SELECTION_H

#include <optional>
#include <string>

#include "sandbox/workspace/emitter_depths.h"

namespace plume {

/// Kept from one picture to the next: to read them waits for the device.
struct SeenDepths {
  uint64_t picture = 0;  ///< see Workspace::picture()
  size_t instance = 0;
  std::vector<EmitterDepths> emitters;
};

struct EffectSelection {
  std::string name;               ///< as the scene calls it; empty: none
  std::optional<size_t> emitter;  ///< nothing: the effect as a whole
  size_t instance = 0;            ///< of the scene, that was clicked
  bool only_set = false;          ///< hides fields that the file does not say
  std::string refused;            ///< why the last edit was not made
  std::string conflict;           ///< effect that was not saved because its file is another by now
  std::string placing;            ///< effect that the next click in the picture drops there
  SeenDepths depths;
  bool closing = false;  ///< the window would close, but something is not saved
};

}  // namespace plume
#endif
