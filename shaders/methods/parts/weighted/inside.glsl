// How much of a fragment's light rides in the weighted fraction, of what it covers; see share.glsl.
#ifndef PLUME_WEIGHTED_INSIDE_GLSL
#define PLUME_WEIGHTED_INSIDE_GLSL

vec3 share_inside(vec3 covers) { return min(covers * 255.0, vec3(1.0)); }

#endif
