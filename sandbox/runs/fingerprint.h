// A short name for texts, to tell whether two are the same: 64 bits of FNV-1a (Fowler, Noll, Vo). Not safe
// against those who want two texts to have the same.
#ifndef PLUME_RUNS_FINGERPRINT_H
#define PLUME_RUNS_FINGERPRINT_H

#include <cstdint>
#include <string>
#include <string_view>

namespace plume {

class Fingerprint {
 public:
  /// Where one text ends and the next begins counts too.
  void add(std::string_view text);
  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  void add_byte(uint8_t byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
  uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace plume
#endif
