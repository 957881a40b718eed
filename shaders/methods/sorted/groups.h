// Where a group of cards stands in an order that a CPU made.
#ifndef PLUME_METHODS_SORTED_GROUPS_H
#define PLUME_METHODS_SORTED_GROUPS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct OrderedGroup {
  uint first;  // card; groups ascend by it and leave none out
  uint rank;   // of the group, front to back
};

PLUME_SHARED_END
#endif
