#include "sandbox/presets/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace plume {

std::string printable(std::string_view text, size_t longest) {
  size_t length = std::min(text.size(), longest);
  const auto continues = [&](size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  while (length < text.size() && length > 0 && continues(length)) --length;  // never cut a UTF-8 sequence
  std::string shown;
  for (const char c : text.substr(0, length)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F)
      shown += fmt::format("\\x{:02x}", byte);
    else
      shown += c;
  }
  return length < text.size() ? shown + "…" : shown;
}

}  // namespace plume
