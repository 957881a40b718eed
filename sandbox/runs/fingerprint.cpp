#include "sandbox/runs/fingerprint.h"

#include <fmt/format.h>

namespace plume {

void Fingerprint::add(std::string_view text) {
  for (uint64_t length = text.size(), i = 0; i < 8; ++i) add_byte(uint8_t(length >> (8 * i)));
  for (const char c : text) add_byte(uint8_t(c));
}

std::string Fingerprint::text() const {
  return fmt::format("{:016x}", hash_);
}

}  // namespace plume
