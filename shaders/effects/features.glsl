// What the emitters of a kernel use, known when its pipeline is made: what none of them uses costs nothing.
#ifndef PLUME_EFFECTS_FEATURES_GLSL
#define PLUME_EFFECTS_FEATURES_GLSL
layout(constant_id = 0) const uint kFeatures = 0xffffffffu;
#endif
