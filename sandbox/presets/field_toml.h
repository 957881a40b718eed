// The value of a field as a file says it.
#ifndef PLUME_PRESETS_FIELD_TOML_H
#define PLUME_PRESETS_FIELD_TOML_H

#include "sandbox/presets/field.h"
#include "sandbox/presets/toml_text.h"

namespace plume {

/// Where there is a short form (a number for a range of equal ends or a curve that is constant, a colour for
/// a gradient that is, a text for a list of one), that is taken, unless the value that is there nests lists
/// as the long one does (see Place::nesting()). Throws std::invalid_argument for a value of another type than
/// the field's, and for tables.
TomlValue to_toml_value(const Field& field, const FieldValue& value, size_t nesting = 0);

}  // namespace plume
#endif
