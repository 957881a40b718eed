// Numbers that are dragged or typed (Ctrl+click), within limits. Where these are far apart, the pace of the
// drag goes with the number.
#ifndef PLUME_DEBUGGER_NUMBER_EDITOR_H
#define PLUME_DEBUGGER_NUMBER_EDITOR_H

#include <span>

#include "sandbox/presets/field.h"

namespace plume {

// Each takes the next item's width, and returns whether the value is another now.
bool edit_number(const char* id, float& value, const Limits& limits);
bool edit_number(const char* id, double& value, const Limits& limits);
bool edit_number(const char* id, int64_t& value, const Limits& limits);
bool edit_numbers(const char* id, std::span<float> values, const Limits& limits);
bool edit_range(const char* id, Range<float>& value, const Limits& limits);
bool edit_range(const char* id, Range<uint32_t>& value, const Limits& limits);

}  // namespace plume
#endif
