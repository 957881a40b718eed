// What a transparent fragment is, for every method alike: they share this, and what they do with it is the method.
// It needs the varyings v_... of a card and opaque_here() declared: surface/shade.glsl takes them from the rasteriser,
// surface/shade_at.glsl is told them in a compute shader.
//
// A texel of the puff textures holds (optical depth / kTextureDepth, normal u, normal v, openness); see effects/puff_encode.comp.
// Coverage is 1 - exp(-tau); a fragment lets 1 - coverage * (1 - transmission) of the light behind it pass, per channel.
#ifndef PLUME_SURFACE_SHADING_GLSL
#define PLUME_SURFACE_SHADING_GLSL

#include "effects/puff.h"
#include "surface/texture_depth.h"
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 3) uniform sampler2DArray puffs;
layout(binding = 4) uniform sampler2D opaque_depth;   // reversed depth of the opaque image, at this pass's resolution

struct Fragment {
  vec3 color;          // premultiplied by coverage
  vec3 emission;       // radiance added whatever the coverage
  float coverage;      // alpha, 0..1
  float optical_depth; // -ln(1 - alpha)
  vec3 transmission;   // share of light passed where covered
  float depth;         // view depth, m
  uint id;             // card index: breaks ties of depth
};

vec4 puff_texel(vec2 aside) {
  const vec2 uv = (v_uv_depth.xy + aside) * 0.5 + 0.5;
  const vec4 a = textureLod(puffs, vec3(uv, float(v_layers_id.x)), 0.0);
  const vec4 b = textureLod(puffs, vec3(uv, float(v_layers_id.y)), 0.0);
  return mix(a, b, v_sunlit.a);
}

vec4 puff_texel() { return puff_texel(vec2(0.0)); }

// 1 far in front of the opaque surface, 0 on it.
float feather() {
  const float gap = view.near_m / max(opaque_here(), 1e-9) - v_uv_depth.z;
  return v_emission.a > 0.0 ? clamp(gap * v_emission.a, 0.0, 1.0) : 1.0;
}

// Share of the card's optical depth here, relative to its mean.
float density(vec4 texel) { return texel.r * kTextureDepth * feather(); }

float coverage_of(float density_here) { return 1.0 - exp(-v_ambient.a * density_here); }

// Coverage for methods that know one transmittance only: what it leaves is the mean of the three channels'.
float gray_coverage(Fragment f) { return f.coverage * (1.0 - dot(f.transmission, vec3(1.0 / 3.0))); }

vec3 transmittance(Fragment f) { return 1.0 - f.coverage * (1.0 - f.transmission); }

const float kHottest = 1.8;
const float kForwardLobe = 0.4;   // mean cosine of what is scattered once

// Henyey and Greenstein's phase function, relative to that across the light; light from before is as light from the side.
float forward_gain(float cosine) {
  const float g = kForwardLobe, all = 1.0 + g * g, x = all / (all - 2.0 * g * max(cosine, 0.0));
  return x * sqrt(x);
}

Fragment shade_texel(vec4 texel, float density_here) {
  const vec2 slope = texel.gb * 2.0 - 1.0;
  const vec3 normal = vec3(slope, sqrt(max(1.0 - dot(slope, slope), 0.0)));
  const float wrap = clamp(dot(normal, v_light) * 0.5 + 0.5, 0.0, 1.0);
  // Where the puff is thin, light comes from all around: no side is dark, so no puff has an outline. It goes on mostly forwards: against
  // the light an edge shines.
  const float sun = mix(0.45 * forward_gain(-v_light.z), wrap * wrap, 1.0 - exp(-2.0 * density_here));
  Fragment f;
  f.optical_depth = v_ambient.a * density_here;
  f.coverage = 1.0 - exp(-f.optical_depth);
  f.color = f.coverage * (v_sunlit.rgb * sun + v_ambient.rgb * texel.a);
  // Thick parts and creases are hotter: green and blue rise faster than red. At the mean depth and openness it is the colour as written;
  // kHottest cubed times the brightest radiance a preset may ask for (10 000) still fits a half float.
  const float openness = v_layers_id.x < kDiscLayer ? texel.a : kMeanOpenness;
  const float hot = (1.0 + 3.0 * (kMeanOpenness - openness)) * 2.0 * density_here / (1.0 + density_here);
  const float heat = kHottest * hot / (hot + kHottest - 1.0);
  f.emission = v_emission.rgb * heat * vec3(1.0, heat, heat * heat);
  f.transmission = v_transmission.rgb;
  f.depth = v_uv_depth.z;
  f.id = v_layers_id.z;
  return f;
}

#endif
