// A sweep spans methods, values of their parameters, scenes, ticks, sizes and seeds: every combination of
// them is a job.
#ifndef PLUME_SCENE_SWEEP_H
#define PLUME_SCENE_SWEEP_H

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "sandbox/scene/scene.h"

namespace plume {

struct Replay;

/// A method with every combination of the values of its parameters.
struct MethodSpan {
  std::string id;
  std::map<std::string, std::vector<std::string>> settings;  ///< parameter -> values as text, at least one
  bool operator==(const MethodSpan&) const = default;
};

struct Sweep {
  FilePosition at;
  std::vector<std::string> scenes;  ///< ids, at least one
  FilePosition scenes_at;
  std::vector<uint32_t> ticks;      ///< ascending; empty: each scene's default
  std::vector<glm::uvec2> sizes;    ///< empty: the replay's
  std::vector<uint32_t> seeds;      ///< ascending; empty: each scene's own
  std::vector<MethodSpan> methods;  ///< at least one
  bool operator==(const Sweep&) const = default;
};

/// How many jobs a sweep spans; as a floating-point number, which does not overflow.
double jobs_of(const Sweep& sweep);

/// Replays without sweeps that draw what this one does: one for each scene, size and seed of each sweep, in
/// that order, so that the methods of one moment are drawn together. A replay without sweeps is itself.
std::vector<Replay> expand(const Replay& replay);

}  // namespace plume
#endif
