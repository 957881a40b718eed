// Exact transparency, first half: every fragment of a pixel joins its linked list (Yang et al., "Real-Time Concurrent Linked
// List Construction on the GPU", EGSR 2010). Nothing is dropped: fragments beyond the capacity are counted, the pool is grown
// by the host, and the frame is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "methods/parts/fragment_list/append.glsl"

layout(constant_id = 0) const uint kExtras = 0u;   // outputs beyond the picture are wanted

void main() {
  const Fragment f = shade();
  if (f.coverage == 0.0 && f.emission == vec3(0.0)) return;   // changes nothing, exactly
  const uint slot = append(FragmentNode(f.color + f.emission, f.depth, transmittance(f), f.id, kListEnd));
  if (kExtras != 0u && slot < pool.capacity) Extras(pool.extras).extras[slot] = vec2(presence(f), 0.0);
}
