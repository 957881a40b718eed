// AVBOIT, raster splat: a card goes as a whole into the layer of its slice, that of its centre; a second draw (kBeyond) into the next
// one. So only cards that face the camera are placed right (the talk).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_ARB_shader_viewport_layer_array : require
#include "surface/card.glsl"
#include "methods/avboit/depth_warp.glsl"

layout(constant_id = 0) const uint kLinear = 1u;
layout(constant_id = 4) const uint kBeyond = 0u;
layout(location = 7) flat out float v_share;   // of the optical depth that this layer takes

void main() {
  card_vertex();
  const float position = slice_at(dot(cards[v_layers_id.z].center - view.camera, view.forward));
  const uint slice = min(uint(position), volume.slices - 1u);
  const float beyond = kLinear == 0u || slice + 1u == volume.slices ? 0.0 : position - float(slice);
  v_share = kBeyond != 0u ? beyond : 1.0 - beyond;
  gl_Layer = int(min(slice + kBeyond, volume.slices - 1u));
  if (v_share <= 0.0) gl_Position = vec4(0.0, 0.0, -1.0, 1.0);
}
