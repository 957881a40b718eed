// Depth peeling: a pixel's current and next layer. Layers are ordered by (depth, card), since cards that face the camera often tie
// in depth: a peel that compared depths alone would lose all but one of them. As one integer, so that one atomic finds the next:
//   key = bits of the view depth << 32 | card
#ifndef PLUME_PEEL_LAYERS_GLSL
#define PLUME_PEEL_LAYERS_GLSL
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require

const uint64_t kNearest = 0ul, kFarthest = 0xfffffffffffffffful;   // no fragment has these keys

struct Layer {
  uint64_t now;    // being blended
  uint64_t next;   // the extreme of those between the two ends
};

uint64_t key_of(float depth, uint id) { return uint64_t(floatBitsToUint(depth)) << 32 | uint64_t(id); }
float depth_of(uint64_t key) { return uintBitsToFloat(uint(key >> 32)); }

#endif
