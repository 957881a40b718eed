// The vertex shader of AVBOIT's draw: a card that faces the camera lies in one slice, found once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"
#include "methods/avboit/depth_warp.glsl"

layout(location = 7) flat out float v_slice;

void main() {
  card_vertex();
  v_slice = slice_at(v_uv_depth.z);
}
