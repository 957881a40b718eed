// What must hold of every reader whatever bytes it is given: they are read, or refused in words, and nothing
// else. Each check is the body of a fuzzer (entry.cpp) and, on the corpora, a unit test
// (fuzz_corpus_test.cpp).
#ifndef PLUME_TESTS_FUZZ_CHECKS_H
#define PLUME_TESTS_FUZZ_CHECKS_H

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace plume::fuzz {

using Bytes = std::span<const uint8_t>;

/// A reader did what it must not.
struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};

inline void require(bool holds, const std::string& what) {
  if (!holds) throw Broken(what);
}

inline std::string_view text_of(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Each reads the bytes, throws Broken or what the reader should not have thrown, and returns how it ended in
/// words, without what they quote: where a library is not instrumented, that is all a fuzzer sees of it.
std::string check_effect(Bytes bytes);
std::string check_scene(Bytes bytes);
std::string check_replay(Bytes bytes);
std::string check_png(Bytes bytes);
std::string check_exr(Bytes bytes);

}  // namespace plume::fuzz
#endif
