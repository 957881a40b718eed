// What any method can make of a picture at most and at least, from all fragments that the reference captured.
#ifndef PLUME_TESTS_PICTURE_BOUNDS_H
#define PLUME_TESTS_PICTURE_BOUNDS_H

#include <optional>
#include <string>
#include <vector>

#include "renderer/methods/method.h"
#include "sandbox/measure/image.h"

namespace plume {

/// Light is not negative, nothing lets more pass than it says, and nothing hides more than it covers. So a
/// pixel has at least its background through all that is in front of it, where of a fragment's three
/// transmittances that counts which is least, as there are methods with one for all colours. At most it has
/// the same with the largest, and all light of all fragments with nothing in its way, or, of methods that
/// average, that of the brightest as if it alone covered all. Where there is no fragment it is the
/// background, to the bit.
class PictureBounds {
 public:
  /// After `resources`' reference drew what it drew over `background`.
  PictureBounds(gpu::Device& device, const Resources& resources, Image background);

  /// The first pixel that is out of bounds, and how many are; nothing: none is. Every fragment may round by
  /// as much as the method says of itself. Of methods that move the background a pixel may have that of any
  /// other. A method that fell short by its own count may have lost what light it had too much of.
  std::optional<std::string> breach(const Image& picture, const Traits& traits, bool fell_short) const;

  /// The same of pixels that are farther from the reference's than an exact method's may be, which is
  /// measured in the brightest light. What hangs on the last bits of depths, as the order of cards in one
  /// plane does, is asked only of methods that round nothing but in halves.
  std::optional<std::string> difference(const Image& exact, const Image& picture, const Traits& traits) const;

  size_t fragments() const { return fragments_; }
  size_t deepest() const;

 private:
  struct Pixel {
    size_t fragments = 0;
    double through_least = 1.0, through_most = 1.0;
    glm::dvec3 light{0.0};
    bool is_ordered = true;  ///< whatever the last bits of depths
  };
  template <class IsWrong>
  std::optional<std::string> pixels_that(const IsWrong& is_wrong, const Image& picture,
                                         const Traits& traits) const;

  std::vector<Pixel> pixels_;
  Image background_;
  glm::dvec3 darkest_, brightest_;  ///< of all backgrounds, in each channel
  size_t fragments_ = 0;
};

}  // namespace plume
#endif
