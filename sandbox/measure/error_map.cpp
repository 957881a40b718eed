#include "sandbox/measure/error_map.h"

#include <stdexcept>

#include "sandbox/measure/magma.h"

namespace plume {

DisplayImage magma_image(const Raster<float>& errors) {
  DisplayImage image{errors.width, errors.height, {}};
  image.pixels.reserve(errors.pixels.size());
  for (const float error : errors.pixels) {
    if (!(error >= 0.0f && error <= 1.0f))
      throw std::invalid_argument("an error of " + std::to_string(error) +
                                  " is outside the map's scale 0..1");
    image.pixels.push_back(magma(error));
  }
  return image;
}

}  // namespace plume
