// How many items a list made on the device has, and the indirect dispatches over them.
#ifndef PLUME_SHARED_WORKLOAD_H
#define PLUME_SHARED_WORKLOAD_H

#include "shared/types.h"
#include "sort/radix.h"

PLUME_SHARED_BEGIN

const uint kItemGroup = 256u;  // threads of a work group, one an item

// As the device reads it: VkDispatchIndirectCommand.
struct DispatchCommand {
  uint x;
  uint y;
  uint z;
};

struct Workload {
  uint count;
  DispatchCommand groups;  // of kItemGroup
  DispatchCommand tiles;   // of the radix sort
};

#ifdef __cplusplus
inline
#endif
    Workload
    workload_of(uint count) {
  return Workload(count, DispatchCommand((count + kItemGroup - 1u) / kItemGroup, 1u, 1u),
                  DispatchCommand((count + kRadixTile - 1u) / kRadixTile, 1u, 1u));
}

PLUME_SHARED_END
#endif
