// One more instance in the text of a scene, after the others, as somebody would write it: what is as it would
// be anyway is left out.
#ifndef PLUME_PRESETS_ADD_INSTANCE_H
#define PLUME_PRESETS_ADD_INSTANCE_H

#include "sandbox/presets/preset_document.h"

namespace plume {

/// One step of undo, refused like any edit. Its effect, name, call, position, seed and turn are written;
/// `instance` has nothing else.
PresetDocument::Outcome add_instance(PresetDocument& scene, const Instance& instance);

}  // namespace plume
#endif
