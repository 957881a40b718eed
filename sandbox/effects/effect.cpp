#include "sandbox/effects/effect.h"

namespace plume {

bool same_states(const std::vector<Emitter>& a, size_t i, const std::vector<Emitter>& b, size_t j) {
  const Emitter &x = a.at(i), &y = b.at(j);
  if (x.name != y.name || x.parent.has_value() != y.parent.has_value()) return false;
  if (x.parent) {
    Parent parent = *x.parent;
    parent.index = y.parent->index;  // others may have come before it
    if (parent != *y.parent || !same_states(a, x.parent->index, b, y.parent->index)) return false;
  }
  return x.spawn == y.spawn && x.shape == y.shape && x.motion == y.motion && x.look.ribbon == y.look.ribbon &&
         x.look.opaque == y.look.opaque;
}

}  // namespace plume
