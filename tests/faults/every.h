// How closely loops over faults look.
#ifndef PLUME_TESTS_EVERY_H
#define PLUME_TESTS_EVERY_H

#include <cstdint>
#include <cstdlib>

namespace plume {

/// The step from one of the moments at which a fault may strike to the next that is tried: `quick`, and 1
/// where PLUME_EVERY_FAULT is set (scripts/faults.sh).
inline uint64_t every(uint64_t quick) {
  return std::getenv("PLUME_EVERY_FAULT") ? 1 : quick;
}

}  // namespace plume
#endif
