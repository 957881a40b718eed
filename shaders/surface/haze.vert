// The vertex shader of draws that haze takes part in: it shows nothing, so surface/card.vert leaves it out.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"

void main() { any_card_vertex(); }
