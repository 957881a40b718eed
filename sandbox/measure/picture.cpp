#include "sandbox/measure/picture.h"

#include <glm/gtc/packing.hpp>

namespace plume {

DrawnPicture read_picture(gpu::Device& device, const Targets& targets) {
  DrawnPicture picture;
  picture.linear.width = picture.display.width = int(targets.size.x);
  picture.linear.height = picture.display.height = int(targets.size.y);
  for (const uint64_t texel : gpu::read<uint64_t>(device, targets.result))
    picture.linear.pixels.emplace_back(glm::unpackHalf4x16(texel));
  for (const auto& texel : gpu::read<std::array<uint8_t, 4>>(device, targets.display))
    picture.display.pixels.push_back({texel[0], texel[1], texel[2]});
  return picture;
}

}  // namespace plume
