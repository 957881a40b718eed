// Piecewise-linear curves and gradients over a particle's normalised life (0 at birth, 1 at death).
#ifndef PLUME_EFFECTS_CURVE_H
#define PLUME_EFFECTS_CURVE_H

#include <glm/glm.hpp>
#include <vector>

namespace plume {

/// A value over normalised life: linear between keys, constant outside them. Keys ascend strictly in `at`.
template <class Value>
struct Track {
  struct Key {
    float at;  ///< normalised life, 0..1
    Value value;
  };
  std::vector<Key> keys;

  Track(Value constant) : keys{{0.0f, constant}} {}
  Track(std::vector<Key> k) : keys(std::move(k)) {}

  Value at(float life) const {
    if (life <= keys.front().at) return keys.front().value;
    for (size_t i = 1; i < keys.size(); ++i)
      if (life <= keys[i].at) {
        const float f = (life - keys[i - 1].at) / (keys[i].at - keys[i - 1].at);
        return keys[i - 1].value * (1.0f - f) + keys[i].value * f;
      }
    return keys.back().value;
  }
};

using Curve = Track<float>;
using Gradient = Track<glm::vec3>;

}  // namespace plume
#endif
