// The vertex shader of AVBOIT's draw: a card that faces the camera lies in one slice, found once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/sharp.glsl"

layout(location = 7) flat out vec2 v_slice_own;   // its slice; share of its optical depth that is in the volume

void main() {
  card_vertex();
  v_slice_own = vec2(slice_at(v_uv_depth.z), is_sharp(cards[v_layers_id.z], view, volume) ? 0.0 : 1.0);
}
