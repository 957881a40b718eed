// A picture made smaller to be picked by: the middle of it, in the wanted shape, averaged in linear light.
#ifndef PLUME_MEASURE_SMALL_PICTURE_H
#define PLUME_MEASURE_SMALL_PICTURE_H

#include "sandbox/measure/image.h"

namespace plume {

/// Each pixel is the mean of those that fall into it, at least of one. Throws std::invalid_argument where
/// `picture` has no pixels.
DisplayImage small_picture(const DisplayImage& picture, glm::uvec2 size);

}  // namespace plume
#endif
