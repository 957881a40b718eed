// Opaque particles where no effect takes or gives light.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "opaque/without_effects.glsl"
#include "opaque/debris.glsl"
