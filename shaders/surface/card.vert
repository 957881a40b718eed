// The vertex shader of transparent draws.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"

void main() { card_vertex(); }
