// Values over a particle's normalised life (0 at birth, 1 at death): curves, which artists may bend by the
// slopes at their keys, and colour gradients, linear between keys. All are constant outside their keys.
//
// A segment of a curve with a slope at either end is the cubic Hermite polynomial of its ends' values and
// slopes; the end without a slope takes that of the chord. Otherwise it is linear.
#ifndef PLUME_EFFECTS_CURVE_H
#define PLUME_EFFECTS_CURVE_H

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace plume {

class Curve {
 public:
  struct Key {
    float at;  ///< normalised life, 0..1; ascends strictly
    float value;
    std::optional<float> in = {}, out = {};  ///< slopes before and after it, value per life
    bool operator==(const Key&) const = default;
  };
  std::vector<Key> keys;

  Curve(float constant) : keys{{0.0f, constant}} {}
  Curve(std::vector<Key> k) : keys(std::move(k)) {}

  bool operator==(const Curve&) const = default;

  float at(float life) const;
  /// A value and where it is taken.
  struct Place {
    double value, at;
    size_t key;  // the last at or before
  };
  /// The least and the largest value, overshoot between keys included.
  struct Extremes {
    Place least, largest;
  };
  Extremes extremes() const;

  /// The most by which linear interpolation between `samples` even samples is off, from above: a kink of the
  /// slope by d is off by at most d h / 4, and a bend by at most h^2 / 8 of the second derivative, h being
  /// the distance of samples.
  double sampling_error(uint32_t samples) const;
};

/// Linear between keys.
struct Gradient {
  struct Key {
    float at;  ///< normalised life, 0..1; ascends strictly
    glm::vec3 value;
    bool operator==(const Key&) const = default;
  };
  std::vector<Key> keys;

  Gradient(glm::vec3 constant) : keys{{0.0f, constant}} {}
  Gradient(std::vector<Key> k) : keys(std::move(k)) {}

  bool operator==(const Gradient&) const = default;

  glm::vec3 at(float life) const;
};

}  // namespace plume
#endif
