// A value for any field of a preset file: of its kind, within its limits.
#ifndef PLUME_TESTS_RANDOM_VALUE_H
#define PLUME_TESTS_RANDOM_VALUE_H

#include "sandbox/presets/field.h"
#include "tests/property/dice.h"

namespace plume {

/// Of a field that is neither a table nor a list of tables. `wildness`: of 100 numbers, so many are an end of
/// the limits, and as many anything between them; the others are about as large as what the field has now,
/// or as usual for its unit.
FieldValue random_value(const Field& field, Dice& dice, uint32_t wildness);

}  // namespace plume
#endif
