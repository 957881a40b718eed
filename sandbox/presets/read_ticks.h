// Reads the ticks that a replay or a sweep plays: a list, or { first, last, step }.
#ifndef PLUME_PRESETS_READ_TICKS_H
#define PLUME_PRESETS_READ_TICKS_H

#include "sandbox/presets/table_reader.h"

namespace plume {

/// More than `at_most` by { first, last, step } are an error: few bytes could ask for any amount of memory.
void read_ticks(TableReader& table, std::vector<uint32_t>& ticks, Need need, uint32_t at_most);

}  // namespace plume
#endif
