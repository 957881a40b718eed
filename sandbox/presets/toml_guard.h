// Refuses the few texts that toml++ 3.3 cannot be trusted with, before it sees them. None of them is valid
// TOML that a person would write.
#ifndef PLUME_PRESETS_TOML_GUARD_H
#define PLUME_PRESETS_TOML_GUARD_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plume {

struct Refusal {
  uint32_t line, column;
  std::string message;
};

/// Nothing when the text may be parsed. Refused are, outside quotes and comments,
/// - characters beyond ASCII: toml++ runs into __builtin_unreachable() when it asks whether one is white
/// space;
/// - more than 512 dots in a line: each dot of a key nests a table, and toml++ frees tables recursively.
std::optional<Refusal> refuse_toml(std::string_view text);

/// The length of the comment or quoted text that starts at the front of `text`; 0 when there is none. A text
/// that is not closed ends with its line, or with the file when it may span lines: the parser reports it.
size_t opaque_length(std::string_view text);

}  // namespace plume
#endif
