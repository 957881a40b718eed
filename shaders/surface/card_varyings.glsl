// What is the same all over a card, unpacked into the varyings of surface/card.glsl.
#ifndef PLUME_SURFACE_CARD_VARYINGS_GLSL
#define PLUME_SURFACE_CARD_VARYINGS_GLSL

void set_varyings(Card card, uint id) {
  v_sunlit = unpack_half4(card.sunlit);
  v_ambient = vec4(unpack_half4(card.ambient).rgb, card.optical_depth);
  v_emission = vec4(unpack_half4(card.emission).rgb, card.inv_feather);
  v_transmission = unpack_half4(card.transmission);
  v_light = unpack_half4(card.light).xyz;
  const uint layer_mask = (1u << kLayerBits) - 1u;
  v_layers_id = uvec3(card.layers & layer_mask, (card.layers >> kLayerBits) & layer_mask, id);
}

#endif
