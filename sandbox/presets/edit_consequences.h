// What a change to a preset file brings with it so that the file stays right. An artist who turns a sphere
// into a cone gets its angle and loses nothing but what a cone does not have:
// - keys that the reader asked for before the change and no longer asks for go;
// - keys that are required now and were not before come, as field_help says or with their default;
// - what cannot stand beside the key that was set goes;
// - what repeats a name that was changed follows it.
#ifndef PLUME_PRESETS_EDIT_CONSEQUENCES_H
#define PLUME_PRESETS_EDIT_CONSEQUENCES_H

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/presets/field.h"

namespace plume {

using Describe = std::function<std::vector<Field>(const std::string& text)>;

/// `text` after a change at `path` of a text with the fields `before`.
std::string with_consequences(std::string text, std::string_view path, const std::vector<Field>& before,
                              const Describe& describe);

/// Nothing when there is no such field.
const Field* find_field(const std::vector<Field>& fields, std::string_view path);

}  // namespace plume
#endif
