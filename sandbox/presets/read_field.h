// Reads presets/fields/*.fga, the text format of Maya Fluids' vector grids that game engines import: numbers
// between commas; 3 counts of cells, the low corner, the high corner, then a vector for every cell, x
// fastest, then y.
#ifndef PLUME_PRESETS_READ_FIELD_H
#define PLUME_PRESETS_READ_FIELD_H

#include <filesystem>
#include <string>
#include <string_view>

#include "sandbox/effects/field_grid.h"

namespace plume {

constexpr uint32_t kMaxFieldCells = 32;  ///< along each side

/// Throws FileErrors with the first thing that is wrong: numbers have no names to go on from.
FieldGrid read_field(const std::filesystem::path& path);
/// The same from text; `file` names it in messages.
FieldGrid read_field_text(std::string_view text, const std::string& file);

}  // namespace plume
#endif
