// What accuracy costs in time: every method shown on this picture so far, by its error and its milliseconds.
#ifndef PLUME_DEBUGGER_ACCURACY_GRAPH_H
#define PLUME_DEBUGGER_ACCURACY_GRAPH_H

#include "sandbox/workspace/accuracy_log.h"

namespace plume {

/// `shown` is pointed out.
void accuracy_graph(const AccuracyLog& log, const MethodInstance& shown);

}  // namespace plume
#endif
