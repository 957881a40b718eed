// The nodes' keys as 64-bit numbers.
#ifndef PLUME_KBUFFER_ORDERED_KEYS_GLSL
#define PLUME_KBUFFER_ORDERED_KEYS_GLSL
#include "methods/parts/pixel_nodes/nodes.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 8) buffer OrderedKeys { uint64_t at[]; };

const uint64_t kNoOrderedKey = 0xfffffffffffffffful;

uint64_t ordered_key(Fragment f) { return uint64_t(floatBitsToUint(f.depth)) << 32 | uint64_t(f.id); }

#endif
