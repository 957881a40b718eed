// Solids in the shadow of smoke and the light of fires.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "opaque/with_effects.glsl"
#include "opaque/solid.glsl"
