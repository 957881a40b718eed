// The cards that show anything, in the order of submission: which of them a thread or an instance stands for.
#ifndef PLUME_SURFACE_SEEN_CARDS_GLSL
#define PLUME_SURFACE_SEEN_CARDS_GLSL
#include "shared/card.h"
#include "shared/workload.h"

layout(scalar, binding = 2) readonly buffer Order { uint order[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

bool shows(Card card) { return card.optical_depth > 0.0 || card.emission != uvec2(0u); }
bool bends(Card card) { return (card.motion.y >> 16) != 0u; }

#endif
