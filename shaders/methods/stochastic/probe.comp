// The probe of stochastic transparency: the share of samples that nothing covered in front of a depth.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/stochastic/visible.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) { return vec3(visible_at(ivec2(pixel), view.near_m / depth)); }
