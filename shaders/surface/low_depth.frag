// The farthest depth of kDivisor x kDivisor pixels, as the depth buffer of what is drawn at low resolution.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/low_resolution.glsl"

layout(constant_id = 0) const int kDivisor = 2;
layout(binding = 8) uniform sampler2D full_depth;

void main() { gl_FragDepth = farthest_depth(full_depth, ivec2(gl_FragCoord.xy), kDivisor); }
