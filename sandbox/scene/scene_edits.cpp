#include "sandbox/scene/scene_edits.h"

#include <algorithm>

namespace plume {
namespace {

/// Spans stay one after the other: those that would begin later are part of this one.
void freeze_from(std::vector<Freeze>& freezes, uint32_t tick) {
  std::erase_if(freezes, [&](const Freeze& freeze) { return freeze.from >= tick; });
  if (!freezes.empty() && freezes.back().until >= tick)
    freezes.back().until = kMaxTick;
  else if (tick < kMaxTick)
    freezes.push_back({tick, kMaxTick});
}

}  // namespace

Scene as_played(Scene scene, const SceneEdits& edits) {
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    if (edits.muted.contains(i)) scene.instances[i].call_tick.reset();
    if (const auto frozen = edits.frozen.find(i); frozen != edits.frozen.end())
      freeze_from(scene.instances[i].freezes, frozen->second);
  }
  return scene;
}

}  // namespace plume
