// The sky's mean radiance as a puff in the open sees it.
#ifndef PLUME_EFFECTS_SKY_LIGHT_GLSL
#define PLUME_EFFECTS_SKY_LIGHT_GLSL
#include "shared/view.h"

vec3 sky_light(ViewData view) { return mix(view.horizon, view.zenith, 0.6); }   // more of it is above than beside

#endif
