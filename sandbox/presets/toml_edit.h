// Changes one value in the text of a TOML file and leaves every other byte as it is: comments, blank lines,
// order, how other numbers are written. Of a list, items that stay the same keep their text too.
//
// A new key goes after the last of its table, a new table after the last of the table it is in, indented as
// their neighbours. What is removed takes its own comment along: the one behind a value, those right above
// and inside a table.
//
// All take valid TOML and throw std::invalid_argument when the path cannot be there.
#ifndef PLUME_PRESETS_TOML_EDIT_H
#define PLUME_PRESETS_TOML_EDIT_H

#include <string>
#include <string_view>

#include "sandbox/presets/toml_text.h"
#include "sandbox/presets/value_path.h"

namespace plume {

/// Tables on the way are made where they are absent.
std::string with_value(std::string_view text, const std::vector<Step>& path, const TomlValue& value);
/// With a table, or with one more in a list of tables where the path ends with its length: emitter[3].
std::string with_table(std::string_view text, const std::vector<Step>& path);
/// Without a key, a table, a list of tables or an item of a list.
std::string without(std::string_view text, const std::vector<Step>& path);

}  // namespace plume
#endif
