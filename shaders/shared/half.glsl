// Four half floats in two words.
#ifndef PLUME_SHARED_HALF_GLSL
#define PLUME_SHARED_HALF_GLSL
uvec2 pack_half4(vec4 v) { return uvec2(packHalf2x16(v.xy), packHalf2x16(v.zw)); }
vec4 unpack_half4(uvec2 p) { return vec4(unpackHalf2x16(p.x), unpackHalf2x16(p.y)); }
#endif
