// What a fragment of the tail blends into the sums; the others leave them alone.
#ifndef PLUME_KBUFFER_TAIL_TARGETS_GLSL
#define PLUME_KBUFFER_TAIL_TARGETS_GLSL

layout(location = 0) out vec4 tail_light;     // added. rgb: light   a: fragments
layout(location = 1) out vec4 tail_through;   // multiplied
layout(location = 2) out vec4 tail_alpha;     // added

void write_tail(vec3 light, vec3 through) {
  tail_light = vec4(light, 1.0);
  tail_through = vec4(through, 1.0);
  tail_alpha = vec4(1.0 - through, 0.0);
}

#endif
