// Four half floats in two words. What is beyond the largest of them becomes that, not an infinity, of which blending makes NaN: a
// radiance of 10 000 that its fade multiplies by 100, or a velocity of km a tick. What was no number before stays none, to be told.
#ifndef PLUME_SHARED_HALF_GLSL
#define PLUME_SHARED_HALF_GLSL
const float kLargestHalf = 65504.0;
uvec2 pack_half4(vec4 v) {
  const bvec4 bad = equal(floatBitsToUint(v) & 0x7F800000u, uvec4(0x7F800000u));
  v = mix(clamp(v, -kLargestHalf, kLargestHalf), v, bad);
  return uvec2(packHalf2x16(v.xy), packHalf2x16(v.zw));
}
vec4 unpack_half4(uvec2 p) { return vec4(unpackHalf2x16(p.x), unpackHalf2x16(p.y)); }
#endif
