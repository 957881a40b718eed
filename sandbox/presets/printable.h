// Text that came from outside, made fit for messages.
#ifndef PLUME_PRESETS_PRINTABLE_H
#define PLUME_PRESETS_PRINTABLE_H

#include <string>
#include <string_view>

namespace plume {

/// Safe to show on one line, cut off behind `longest` bytes.
std::string printable(std::string_view text, size_t longest = 60);

}  // namespace plume
#endif
