// What the picture costs: milliseconds of each pass, memory of each owner.
#ifndef PLUME_MEASURE_TIMINGS_PANEL_H
#define PLUME_MEASURE_TIMINGS_PANEL_H

#include "renderer/gpu/memory.h"
#include "sandbox/measure/timing_history.h"

namespace plume {

/// `always_draw`: draws the picture again though nothing changed, so that its times can be measured.
void timings_panel(const TimingHistory& history, const gpu::Memory& memory, bool& always_draw);

}  // namespace plume
#endif
