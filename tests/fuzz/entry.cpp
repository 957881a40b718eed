// libFuzzer's entry, of the check named PLUME_FUZZ_CHECK. What a check throws ends the fuzzer, which keeps
// the bytes and says how to run them again.
#include <functional>

#include "tests/fuzz/checks.h"

namespace {

// libpng and OpenEXR are not instrumented: each new end of a reading counts as new code.
__attribute__((section("__libfuzzer_extra_counters"))) uint8_t ends[1 << 12];

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string end = plume::fuzz::PLUME_FUZZ_CHECK({data, size});
  ends[std::hash<std::string>()(end) % sizeof ends] = 1;
  return 0;
}
