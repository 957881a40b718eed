// What the methods draw that weigh each fragment by a guess or a measure w of its transmittance, and blend in any order:
//   image = (sum C a w) (1 - T) / (sum a w) + emission + background T,   T = prod (1 - a),
// with one w for all channels, or (kEachChannel) everything for each channel on its own: a = 1 - t.
#ifndef PLUME_WEIGHTED_GLSL
#define PLUME_WEIGHTED_GLSL
#include "methods/parts/weighted/share.glsl"

layout(location = 0) out vec4 accum;      // rgb: sum C a w   a: sum a w, of the mean channel
layout(location = 1) out vec4 through;    // prod t, of the mean channel in r, or of each
layout(location = 2) out vec4 emission;   // rgb
layout(location = 3) out vec4 norm;       // rgb: sum a w, for each channel; without kEachChannel there is no such target

// What is summed outside the fraction is weighted by `outside`.
void write_weighted(Fragment f, vec3 weight, vec3 outside, bool each_channel) {
  const vec3 alpha = each_channel ? 1.0 - transmittance(f) : vec3(gray_coverage(f));
  const vec3 blocks = each_channel ? 1.0 - f.transmission : vec3(1.0 - dot(f.transmission, vec3(1.0 / 3.0)));
  const Share light = share_of(f, alpha, blocks);
  accum = vec4(light.inside * weight, alpha.g * weight.g);
  through = vec4(1.0 - alpha, 1.0);
  emission = vec4(light.outside * outside, 0.0);
  norm = vec4(alpha * weight, 0.0);
}

#endif
