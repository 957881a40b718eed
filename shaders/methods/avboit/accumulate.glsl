// AVBOIT, draw: what a fragment adds to the sums of its pixel, weighted by the transmittance T(z) in front of it.
//   light:   rgb sum (C a + E) T     a: prod(1 - a) of what does not tint
//   norm:    sum a T                 what the fraction in resolve divides by; a sum for each channel behind RGB sources
//   known_light, known_norm:  the part of light and norm that is not in doubt (kDoubt), or else, of exact cards only, the share that T
//            lets through, since what the layers say is sure. Where one channel is enough, known_light.a is known_norm
//   through: rgb prod t, a: prod(mean t), of what tints
// Chromaticity skew (kSkew): optical depth of each channel counts as far as the fragment is seen, mix(gray, rgb, T(z)), so that
// glass in thick smoke does not tint what lies before it.
#ifndef PLUME_AVBOIT_ACCUMULATE_GLSL
#define PLUME_AVBOIT_ACCUMULATE_GLSL
#include "surface/shade.glsl"
#include "methods/avboit/colour.h"
#include "methods/avboit/transmittance.glsl"

layout(constant_id = 3) const uint kTints = 0u;       // what it passes goes into `through`, a channel each: 1 where that has a colour, 2 always
layout(constant_id = 4) const uint kGeneral = 0u;     // it spans slices or passes light where it covers
layout(constant_id = 5) const uint kColour = kFullRgb;

layout(constant_id = 11) const uint kDoubt = 1u;         // told by the volume, fragment by fragment
layout(constant_id = 7) const uint kExact = 0u;          // its optical depth is in the layers, not in the volume
layout(constant_id = 6) const uint kBehindLayers = 0u;

layout(constant_id = 9) const uint kScale = 1u;          // pixels of the picture a fragment, each way
layout(constant_id = 10) const uint kEachChannel = 0u;   // weights are summed for each channel

layout(location = 7) flat in float v_slice;

struct Share {
  vec4 light;
  vec3 norm;
  vec4 through;
  vec3 known_light, known_norm;
};

Share share_of_fragment() {
  const Fragment f = shade();
  const float gray = 1.0 - gray_coverage(f);
  const vec3 passed = kTints != 0u && kColour != kMono ? transmittance(f) : vec3(gray);
  const vec3 weighed = kColour == kFullRgb ? passed : vec3(gray);
  const vec3 own = kGeneral != 0u ? -log(max(weighed, vec3(kLeastTransmittance))) : vec3(min(f.optical_depth, -log(kLeastTransmittance)));   // as the splat takes it
  const vec2 pixel = gl_FragCoord.xy * float(kScale);
  const Reading reading = transmittance_at(pixel, kGeneral != 0u ? slice_at(f.depth) : v_slice, kExact != 0u ? vec3(0.0) : own);
  vec3 t = reading.transmittance;
  float known = kDoubt != 0u ? 1.0 - reading.doubt : kExact != 0u ? dot(t, vec3(1.0 / 3.0)) : 0.0;
  if (kBehindLayers != 0u) {
    bool estimated;
    const vec3 layers_t = layers_in_front(min(uvec2(pixel), view.size - 1u), f.depth, f.id, kExact != 0u ? tail_depth(pack_layer(transmittance(f))) : vec3(0.0), estimated);
    if (estimated && gray < 1.0) known = 0.0;   // a bare light is no part of the tail
    t *= kColour == kFullRgb ? layers_t : vec3(dot(layers_t, vec3(1.0 / 3.0)));
  }
  vec3 seen = f.color + f.emission;
  vec3 tint = passed;
  if (kColour == kSkew || kColour == kFirstEvent) tint = exp(mix(log(max(vec3(gray), kLeastTransmittance)), log(max(passed, kLeastTransmittance)), t));
  if (kColour == kFirstEvent && kTints != 0u) seen *= luma(tint) / max(tint, vec3(1.0 / 256.0));
  const vec3 share = (1.0 - weighed) * t;
  // Gray goes into `light`, so that the colour of what is left behind dense smoke keeps its digits.
  const bool tints = kTints == 2u || (kTints == 1u && passed != passed.rrr);
  return Share(vec4(seen * t * (1.0 - known), tints ? 1.0 : gray), share * (1.0 - known), tints ? vec4(tint, gray) : vec4(1.0), seen * t * known, share * known);
}

#endif
