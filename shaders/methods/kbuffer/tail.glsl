// The tail: what is farther than the nearest k, as sums that any order gives. Fragments are told apart no more, so each is given the mean
// share that gets through, for each channel:
//   tail = (sum L) (1 - prod t) / sum (1 - t),
// which is the average colour times the exact coverage (Bavoil and Myers 2008), and L itself where nothing covers: the share goes to 1.
#ifndef PLUME_KBUFFER_TAIL_GLSL
#define PLUME_KBUFFER_TAIL_GLSL

vec3 tail_share(vec3 through, vec3 alpha_sum) {
  return mix(vec3(1.0), min((1.0 - through) / max(alpha_sum, vec3(1e-6)), vec3(1.0)), greaterThan(alpha_sum, vec3(1e-6)));
}

#endif
