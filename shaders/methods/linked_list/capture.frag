// Linked lists in a pool of fixed size: a fragment joins its pixel's list (Yang et al., "Real-Time Concurrent Linked List
// Construction on the GPU", EGSR 2010) while there is room. Later ones go into the pixel's tail, a plain average weighted by what
// they cover (Maule et al., "Hybrid Transparency", I3D 2013):
//   tail = (sum C a) / (sum a) (1 - prod t) + uncovered emission,   which lets prod t of the background through.
// Sums and products: the tail does not depend on the order of its fragments.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/parts/fragment_list/append.glsl"
#include "methods/parts/weighted/weighted.glsl"

void main() {
  const Fragment f = shade();
  if (f.coverage == 0.0 && f.emission == vec3(0.0)) discard;   // changes nothing, exactly
  const uint slot = append(FragmentNode(f.color + f.emission, f.depth, transmittance(f), f.id, kListEnd));
  if (slot < pool.capacity) discard;
  write_weighted(f, vec3(1.0), vec3(1.0), true);
}
