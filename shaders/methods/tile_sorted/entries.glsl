// The tiles' lists: ranks of cards, front to back.
#ifndef PLUME_METHODS_TILE_SORTED_ENTRIES_GLSL
#define PLUME_METHODS_TILE_SORTED_ENTRIES_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/tile_sorted/tile_sorted.h"

layout(scalar, binding = 11) buffer Totals { TileTotals totals; };
layout(scalar, binding = 12) readonly buffer Counts { uint counts[]; };   // summed: where each span begins
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Entries { uint ranks[]; };

#endif
