// An indirect draw, as the device reads it: VkDrawIndirectCommand.
#ifndef PLUME_SHARED_DRAW_COMMAND_H
#define PLUME_SHARED_DRAW_COMMAND_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct DrawCommand {
  uint vertices;
  uint instances;
  uint first_vertex;
  uint first_instance;
};

// Of cards that show nothing; before it those of plume::Source.
const uint kUnseenSource = 3u;

PLUME_SHARED_END
#endif
