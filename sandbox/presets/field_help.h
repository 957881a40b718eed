// What an editor says about the fields of effects and scenes, in an artist's words, and what it writes into
// one that must be there and has no default. Limits, units and defaults are the readers': see field.h.
#ifndef PLUME_PRESETS_FIELD_HELP_H
#define PLUME_PRESETS_FIELD_HELP_H

#include <span>
#include <string_view>

namespace plume {

struct FieldHelp {
  std::string_view pattern;  ///< see pattern_of()
  std::string_view tooltip;
  /// In TOML; "" where the field's default will do. Texts that name something get a number to differ.
  std::string_view initial = "";
  bool from_start = false;  ///< written when its table is made, though it is not required
};

std::span<const FieldHelp> all_field_help();
/// Of the field at a path or a pattern; nullptr where there is none.
const FieldHelp* field_help(std::string_view path);

}  // namespace plume
#endif
