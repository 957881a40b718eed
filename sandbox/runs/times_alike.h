// Which methods' own times a run does not tell apart, for people who read its table.
#ifndef PLUME_RUNS_TIMES_ALIKE_H
#define PLUME_RUNS_TIMES_ALIKE_H

#include "sandbox/runs/results.h"

namespace plume {

/// The id, and those settings that are not its defaults.
std::string name_of(const FrameResult& frame);

/// A line for each moment in which there are such: neighbours by median whose intervals meet, with a ~
/// between them. "" when there are none.
std::string times_alike(const Results& results);

}  // namespace plume
#endif
