// AVBOIT, splat: optical depth of each fragment into the extinction volume, shared linearly between slices Z and Z + 1.
// Four slices are 8-bit fields of one word, ordered along the ray, so that a carry only touches what lies behind. atomicAdd
// returns the old word: the add that passes 255 knows it and keeps the first overflowing slice; behind it T = 0.
// Limits: the quantum is ln 255 / 255 = 0.0217; shares below half of it round to nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/avboit/curve.glsl"

layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 9) buffer Extinction { uint extinction[]; };
layout(scalar, binding = 10) buffer Overflow { uint overflow[]; };

uint quantise(float tau) { return uint(clamp(tau / kLog255, 0.0, 1.0) * 255.0 + 0.5); }

void note_overflow(uint ray, uint slice, uint old_word, uint added) {
  const uint field = (old_word >> (8u * (slice & 3u))) & 255u;
  if (field + added > 255u) atomicMin(overflow[ray], slice);
}

void main() {
  const float here = texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r;
  const float depth = v_uv_depth.z;
  if (depth * here > view.near_m) return;   // behind the farthest opaque surface of the cell
  const float through = 1.0 - coverage_of(density(puff_texel())) * (1.0 - dot(v_transmission.rgb, vec3(1.0 / 3.0)));
  const float tau = -log(max(through, kLeastTransmittance));
  const float position = slice_of(volume, depth);
  const uint slice = uint(position);
  const float share = position - float(slice);
  const uint near = quantise(tau * (1.0 - share)), far = quantise(tau * share);

  const uvec2 cell = uvec2(gl_FragCoord.xy);
  const uint ray = cell.y * volume.cells.x + cell.x;
  const uint words = volume.slices / 4u;
  const uint word = ray * words + slice / 4u;
  const uint lane = slice & 3u;
  if (lane < 3u) {   // both slices lie in one word
    const uint added = near << (8u * lane) | far << (8u * (lane + 1u));
    if (added == 0u) return;
    const uint old_word = atomicAdd(extinction[word], added);
    note_overflow(ray, slice, old_word, near);
    note_overflow(ray, slice + 1u, old_word, far);
  } else {
    if (near != 0u) note_overflow(ray, slice, atomicAdd(extinction[word], near << 24u), near);
    if (far != 0u && slice + 1u < volume.slices)
      note_overflow(ray, slice + 1u, atomicAdd(extinction[word + 1u], far), far);
  }
}
