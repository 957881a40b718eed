#include "sandbox/effects/effect.h"

#include <algorithm>

namespace plume {

bool same_states(const std::vector<Emitter>& a, const std::vector<Emitter>& b) {
  return std::ranges::equal(a, b, [](const Emitter& x, const Emitter& y) {
    return x.parent == y.parent && x.spawn == y.spawn && x.shape == y.shape && x.motion == y.motion &&
           x.look.ribbon == y.look.ribbon && x.look.opaque == y.look.opaque;
  });
}

}  // namespace plume
