// What the checks of both image readers share.
#ifndef PLUME_TESTS_FUZZ_IMAGE_CHECKS_H
#define PLUME_TESTS_FUZZ_IMAGE_CHECKS_H

#include <algorithm>
#include <optional>

#include "sandbox/measure/image_io.h"
#include "tests/fuzz/checks.h"

namespace plume::fuzz {

/// The image; where it is refused as it should be, nothing, and the words in `refusal`.
template <class Read>
auto read_or_refuse(const Read& read, Bytes bytes, std::string& refusal)
    -> std::optional<decltype(read(bytes, ""))> try {
  auto image = read(bytes, "picture");
  require(image.width >= 1 && image.width <= kMaxImageSide,
          "an image is " + std::to_string(image.width) + " wide");
  require(image.height >= 1 && image.height <= kMaxImageSide,
          "an image is " + std::to_string(image.height) + " high");
  require(image.pixels.size() == static_cast<size_t>(image.width) * image.height,
          size_text(image.width, image.height) + " with " + std::to_string(image.pixels.size()) + " pixels");
  return image;
} catch (const FileError& error) {
  refusal = error.what();
  require(refusal.starts_with("picture: ") && refusal.size() > 12, "refused without reason: " + refusal);
  const auto shows = [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; };
  require(std::ranges::all_of(refusal, shows), "what it says would disturb a terminal: " + refusal);
  bool quoted = false;
  std::erase_if(refusal, [&](char c) {
    quoted ^= c == '"' || c == '`' || c == '\'';
    return quoted || (c >= '0' && c <= '9');
  });
  return {};
}

}  // namespace plume::fuzz
#endif
