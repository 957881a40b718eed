// Classes of cards by what their draw has to do: each is drawn with a shader that does no more.
#ifndef PLUME_AVBOIT_CARD_CLASS_H
#define PLUME_AVBOIT_CARD_CLASS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kClassGeneral = 1u;    // bit: it spans slices or passes light; otherwise an opaque-where-dense card in one slice
const uint kClassBehindRgb = 2u;  // bit: RGB sources may lie in front of it
const uint kClassRgb = 4u;        // bit: it is an RGB source itself
const uint kClassUnseen = 8u;     // off the screen, dead, or drawn elsewhere
const uint kDrawnClasses = 8u;

struct ClassDraw {  // VkDrawIndirectCommand
  uint vertices;
  uint instances;
  uint first_vertex;
  uint first_instance;
};

PLUME_SHARED_END
#endif
