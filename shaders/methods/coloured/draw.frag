// Weighted blending with coloured transmission t (McGuire 2015): the background is modulated channel by channel, what is drawn is
// averaged with the coverage that the mean of t leaves,
//   image = (sum C w) (1 - prod(1 - a')) / (sum a' w) + emission + background prod(1 - a (1 - t)),   a' = a (1 - mean t).
// The modulation takes the coverage a as it is, before it is reduced to a': otherwise glass would tint by half of what it should.
// Limits: a layer's colour is not tinted by the layers in front of it, only the background is; highlights are averaged away.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/coloured/weight.glsl"
#include "methods/parts/weighted/share.glsl"

layout(location = 0) out vec4 accum;        // rgb: sum C w   a: sum a' w
layout(location = 1) out vec4 through;      // r: prod(1 - a')
layout(location = 2) out vec4 emission;     // rgb
layout(location = 3) out vec4 modulation;   // rgb: prod(1 - a (1 - t))

void main() {
  const Fragment f = shade();
  modulation = vec4(1.0 - f.coverage * (1.0 - f.transmission), 1.0);
  const float alpha = f.coverage * (1.0 - dot(f.transmission, vec3(1.0 / 3.0)));
  const Share light = gray_share(f);
  accum = vec4(light.inside, alpha) * weight(f.depth, alpha);
  through = vec4(1.0 - alpha);
  emission = vec4(light.outside, 0.0);
}
