// The two images of a drawn frame on the host: linear for numbers, displayed for eyes.
#ifndef PLUME_MEASURE_PICTURE_H
#define PLUME_MEASURE_PICTURE_H

#include "renderer/frame.h"
#include "sandbox/measure/image.h"

namespace plume {

struct DrawnPicture {
  Image linear;          ///< HDR, from the final 16-bit image
  DisplayImage display;  ///< tone-mapped, sRGB
};

/// Copies the current result and display image; waits for the device.
DrawnPicture read_picture(gpu::Device& device, const Targets& targets);

}  // namespace plume
#endif
