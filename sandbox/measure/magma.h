// The magma colours: equal steps look equally far apart, and brightness alone tells the order.
#ifndef PLUME_MEASURE_MAGMA_H
#define PLUME_MEASURE_MAGMA_H

#include <array>
#include <cstdint>

namespace plume {

/// sRGB, from black (0) over purple and orange to pale yellow (1). `share` must be in 0..1.
std::array<uint8_t, 3> magma(float share);

}  // namespace plume
#endif
