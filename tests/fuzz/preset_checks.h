// What the checks of the preset readers share.
#ifndef PLUME_TESTS_FUZZ_PRESET_CHECKS_H
#define PLUME_TESTS_FUZZ_PRESET_CHECKS_H

#include <optional>
#include <string>
#include <vector>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/field.h"
#include "tests/fuzz/checks.h"

namespace plume::fuzz {

/// Diagnostics must be some, and each say where in the text, in one line what is wrong, and what would be
/// right.
void require_clear(const std::vector<Diagnostic>& found, std::string_view text, const std::string& file);

/// What an accepted text says: nothing wrong, and every number finite and within the limits of its key.
void require_within_limits(const std::vector<Field>& fields);

/// What is read; nothing where it is refused as it should be.
template <class Read>
auto read_or_refuse(const Read& read, std::string_view text, const std::string& file)
    -> std::optional<decltype(read(text, file))> try {
  return read(text, file);
} catch (const FileErrors& errors) {
  require_clear(errors.diagnostics(), text, file);
  return {};
}

/// What is read of a text that a writer of ours wrote.
template <class Read>
auto read_again(const Read& read, const std::string& text) try {
  return read(text, "written.toml");
} catch (const FileErrors& errors) {
  throw Broken(std::string("what was written is refused: ") + errors.what() + "\n" + text);
}

}  // namespace plume::fuzz
#endif
