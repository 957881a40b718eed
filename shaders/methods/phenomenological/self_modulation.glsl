// Self-modulation: what is drawn takes half of the hue of B, so that layers are seen through one another.
#ifndef PLUME_PHENOMENOLOGICAL_SELF_MODULATION_GLSL
#define PLUME_PHENOMENOLOGICAL_SELF_MODULATION_GLSL

float brightest(vec3 v) { return max(v.r, max(v.g, v.b)); }

vec3 self_modulation(vec3 b) { return 0.5 + max(b, vec3(1e-3)) / (2.0 * max(brightest(b), 1e-3)); }

#endif
