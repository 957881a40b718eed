// Stochastic transparency: what every sample sees before anything transparent is drawn.
#version 460
layout(binding = 4) uniform sampler2D opaque_depth;
void main() { gl_FragDepth = texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r; }
