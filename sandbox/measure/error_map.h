// A FLIP map as a picture.
#ifndef PLUME_MEASURE_ERROR_MAP_H
#define PLUME_MEASURE_ERROR_MAP_H

#include "sandbox/measure/image.h"

namespace plume {

/// Errors in the magma colours, from black (0) over purple and orange to pale yellow (1). The scale is always
/// 0..1, never stretched to what occurs, so that maps of different methods can be compared by eye. Throws
/// std::invalid_argument for a value outside 0..1 or a NaN.
DisplayImage magma_image(const Raster<float>& errors);

}  // namespace plume
#endif
