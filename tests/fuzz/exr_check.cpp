#include <cstring>

#include "tests/fuzz/image_checks.h"

namespace plume::fuzz {

std::string check_exr(Bytes bytes) {
  std::string refusal;
  const auto image = read_or_refuse(read_exr_bytes, bytes, refusal);
  if (!image) return refusal;
  // Of memory that nobody wrote, two readings differ.
  const Image again = read_exr_bytes(bytes, "again");
  require(again.pixels.size() == image->pixels.size() &&
              std::memcmp(again.pixels.data(), image->pixels.data(),
                          again.pixels.size() * sizeof(glm::vec3)) == 0,
          "read twice, it is another image");
  return "read";
}

}  // namespace plume::fuzz
