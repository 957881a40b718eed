// An effect whose particles fall until they are farther away than anything can be drawn.
#ifndef PLUME_TESTS_FAR_PARTICLES_H
#define PLUME_TESTS_FAR_PARTICLES_H

#include <string_view>

namespace plume {

constexpr std::string_view kFarEffect = R"(name = "Far"
[[emitter]]
name = "carrier"
  [emitter.spawn]
  bursts = [[0, 4]]
  life = 30000
  [emitter.motion]
  gravity = 100.0
  [emitter.look]
  opacity = 0.5
[[emitter]]
name = "runaway"
  [emitter.parent]
  emitter = "carrier"
  on = "death"
  inherit_velocity = 10.0
  [emitter.spawn]
  life = 36000
  [emitter.motion]
  gravity = 100.0
  [emitter.look]
  opacity = 0.5
)";

constexpr std::string_view kFarScene = R"(name = "Far"
duration_ticks = 60000
[camera]
position = [0.0, 1.0, 6.0]
target = [0.0, 1.0, 0.0]
[[instance]]
name = "it"
effect = "far"
call_tick = 0
position = [0.0, 1.0, 0.0]
)";

constexpr const char* kTooFarTick = "42000";  // by then those that were born at 30000 are a million km away

}  // namespace plume
#endif
