// The absorbance of a fragment, and what is drawn at the cells' resolution.
#ifndef PLUME_ABSORBANCE_FRAGMENT_GLSL
#define PLUME_ABSORBANCE_FRAGMENT_GLSL
#include "surface/shade.glsl"
#include "methods/parts/absorbance/cells.glsl"

vec3 passed_by(Fragment f) {
  const vec3 t = f.transmission + (1.0 - f.transmission) * exp(-f.optical_depth);
  return kChannels == 3u ? t : vec3(dot(t, vec3(1.0 / 3.0)));
}
vec3 absorbance(Fragment f) { return -log(clamp(passed_by(f), vec3(kLeastTransmittance), vec3(1.0))); }

// Cells larger than a pixel have no depth buffer: their fragments are tested against the farthest opaque surface in the cell.
bool hidden() { return kDivisor > 1u && v_uv_depth.z * texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r > view.near_m; }

#endif
