// The window depth of a card's plane at the centre of the pixel. The interpolated depth of a steep card is rounded differently in a
// multisampled draw and in another, so that it would lie behind itself.
#ifndef PLUME_STOCHASTIC_PLANE_DEPTH_GLSL
#define PLUME_STOCHASTIC_PLANE_DEPTH_GLSL

layout(location = 7) flat in vec4 v_inverse_depth;   // a: the most of u + v on the card

bool on_card() {   // and not on what it was grown by
  return all(lessThanEqual(abs(v_uv_depth.xy), vec2(1.0))) && v_uv_depth.x + v_uv_depth.y <= v_inverse_depth.a;
}

float plane_depth() {
  precise const vec2 ndc = gl_FragCoord.xy / vec2(view.size) * 2.0 - 1.0;
  precise const float inverse = v_inverse_depth.x + v_inverse_depth.y * ndc.x + v_inverse_depth.z * ndc.y;
  return view.near_m * inverse;
}

#endif
