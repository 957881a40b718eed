// Finding the group of a card.
#ifndef PLUME_METHODS_SORTED_GROUPS_GLSL
#define PLUME_METHODS_SORTED_GROUPS_GLSL
#include "methods/sorted/groups.h"

layout(scalar, binding = 8) readonly buffer Groups { OrderedGroup groups[]; };

OrderedGroup group_of(uint card, uint count) {
  uint low = 0u, high = count;   // the last group whose first card is not behind `card`
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (groups[middle].first <= card) low = middle;
    else high = middle;
  }
  return groups[low];
}

#endif
