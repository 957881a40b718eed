// Milliseconds of the last frames as stacked columns, one layer a group of passes.
#ifndef PLUME_DEBUGGER_HISTORY_GRAPH_H
#define PLUME_DEBUGGER_HISTORY_GRAPH_H

#include "sandbox/measure/timing_history.h"

namespace plume {

void history_graph(const TimingHistory& history);

}  // namespace plume
#endif
