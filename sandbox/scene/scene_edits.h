// What is changed of a scene while somebody works on it, without a change of its file.
#ifndef PLUME_SCENE_SCENE_EDITS_H
#define PLUME_SCENE_SCENE_EDITS_H

#include <map>
#include <set>
#include <string>

#include "sandbox/effects/effect.h"
#include "sandbox/scene/scene.h"

namespace plume {

struct SceneEdits {
  std::map<std::string, Effect> effects;  ///< instead of the library's, by the name that the scene calls them
  std::set<size_t> muted;                 ///< instances that count as not called
  std::map<size_t, uint32_t> frozen;      ///< instances, and the tick after which their time stands still
};

/// The scene as its file would say it with what is muted and frozen: the first are not called, the others
/// have a freeze until the last tick there is.
Scene as_played(Scene scene, const SceneEdits& edits);

}  // namespace plume
#endif
