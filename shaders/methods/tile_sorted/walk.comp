// Tile-sorted compute: threads walk their tile's list front to back and composite in registers,
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i,
// until what is still behind cannot change a pixel by stop_below:  max(t) (brightest behind + all that shines behind) < stop_below.
// The threads of a subgroup share a block of pixels: each tests one card of the list against it, and together they shade those
// that touch it, so that no thread takes another road than its neighbours. A thread has several pixels for each card it reads.
// Fragments of tilted cards wait in the pixel's linked list, sorted; they join where their depth says.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "methods/parts/fragment_list/sort.glsl"
#include "methods/tile_sorted/tile.glsl"

layout(local_size_x = 64) in;   // for a square of kWalkSquare pixels, each way
layout(constant_id = 0) const uint kTile = 16u;     // pixels
layout(constant_id = 1) const uint kTilted = 0u;    // there are fragments of tilted cards
layout(constant_id = 2) const uint kListed = 0u;    // work groups take squares from the list of those with or without them
layout(binding = 13) uniform sampler2D opaque_color;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(scalar, binding = 15) readonly buffer Squares { WalkSquares squares; uint listed[]; };
layout(push_constant, scalar) uniform Push {
  TileGrid grid;
  float stop_below;   // radiance as exposed
};

const uint kPixels = kWalkSquare * kWalkSquare / 64u;   // a thread
const uint kBatch = 32u;   // cards tested before any is shaded; subgroups have no more threads

struct Pixel {
  vec3 light, through;
  vec2 center;
  float opaque;       // near_m / view depth
  float background;   // its brightest channel
  uint node;          // the next fragment of a tilted card
  float node_depth;
  bool done;
};

void composite(inout Pixel p, vec3 l, vec3 t) {
  p.light += l * p.through;
  p.through *= t;
}

void take_tilted_before(inout Pixel p, float depth, uint id) {
  Nodes list = Nodes(pool.address);
  while (p.node != kListEnd && (p.node_depth < depth || (p.node_depth == depth && list.nodes[p.node].id < id))) {
    composite(p, list.nodes[p.node].light, list.nodes[p.node].transmittance);
    p.node = list.nodes[p.node].next;
    if (p.node != kListEnd) p.node_depth = list.nodes[p.node].depth;
  }
}

float brightest(vec3 c) { return max(c.r, max(c.g, c.b)); }

// Every second bit of the lowest eight.
uint half_bits(uint i) { return (i & 1u) | (i >> 1u & 2u) | (i >> 2u & 4u) | (i >> 3u & 8u); }

uvec2 square() {
  if (kListed == 0u) return gl_WorkGroupID.xy;
  const uint packed = listed[kTilted * squares.number + gl_WorkGroupID.x];
  return uvec2(packed & 0xffffu, packed >> 16u);
}

// Bits of an index are those of x and y in turn: any run of threads has a block.
uvec2 pixel_of(uint p) {
  const uint i = (gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID) * kPixels + p;
  return square() * kWalkSquare + uvec2(half_bits(i), half_bits(i >> 1u));
}

void main() {
  Pixel pixels[kPixels];
  vec2 low = vec2(1e9), high = vec2(0.0);
  float farthest = 1e9;   // opaque surface, as near_m / view depth
  bool all_done = true;
  [[unroll]] for (uint p = 0u; p < kPixels; ++p) {
    const uvec2 at = pixel_of(p), clamped = min(at, view.size - 1u);
    pixels[p].light = vec3(0.0);
    pixels[p].through = vec3(1.0);
    pixels[p].center = vec2(at) + 0.5;
    pixels[p].opaque = texelFetch(opaque_depth, ivec2(clamped), 0).r;
    pixels[p].background = brightest(texelFetch(opaque_color, ivec2(clamped), 0).rgb);
    pixels[p].node = kListEnd;
    pixels[p].done = at != clamped;
    if (kTilted != 0u && !pixels[p].done && pool.count <= pool.capacity) {
      const uint ray = at.y * view.size.x + at.x;
      pixels[p].node = sort(Nodes(pool.address), heads[ray]);
      heads[ray] = pixels[p].node;
      if (pixels[p].node != kListEnd) pixels[p].node_depth = Nodes(pool.address).nodes[pixels[p].node].depth;
    }
    all_done = all_done && pixels[p].done;
    low = min(low, pixels[p].center);
    high = max(high, pixels[p].center);
    farthest = min(farthest, pixels[p].opaque);
  }
  low = subgroupMin(low), high = subgroupMax(high);
  const vec2 block = 0.5 * (low + high), half_block = 0.5 * (high - low);
  farthest = subgroupMin(farthest);

  const uvec2 tile = square() * kWalkSquare / kTile;
  const uvec2 range = list_of(tile.y * grid.tiles.x + tile.x, grid.spans);
  Entries list = Entries(totals.address);
  uint stopped = 0u;
  for (uint at = range.x; at < range.y && !subgroupAll(all_done); at += kBatch) {
    uint hits = 0u;
    bool any_in_front = false;
    for (uint first = 0u; first < kBatch; first += gl_SubgroupSize) {
      const uint mine = at + first + gl_SubgroupInvocationID;
      bool in_front = false, touching = false;
      if (mine < range.y) {
        const uint rank = list.ranks[mine];
        const vec4 place = tile_cards[rank].place;
        in_front = place.z * farthest <= view.near_m;
        touching = in_front && touches(tile_cards[rank].pixel_to_uv, place.xy, block, half_block);
      }
      any_in_front = any_in_front || in_front;
      hits |= subgroupBallot(touching).x << first;
    }
    if (!subgroupAny(any_in_front)) break;   // neither is anything after these
    while (hits != 0u) {
      const uint hit = uint(findLSB(hits));
      hits &= hits - 1u;
      const TileCard card = tile_cards[list.ranks[at + hit]];
      all_done = true;
      [[unroll]] for (uint p = 0u; p < kPixels; ++p) {
        if (kTilted != 0u && !pixels[p].done) take_tilted_before(pixels[p], card.place.z, id_of(card));
        Fragment f;
        if (fragment_of(card, pixels[p].center, pixels[p].opaque, f) && !pixels[p].done) {
          composite(pixels[p], f.color + f.emission, transmittance(f));
          if (brightest(pixels[p].through) * (card.place.w + pixels[p].background) * view.exposure < stop_below) {
            pixels[p].done = true;
            pixels[p].node = kListEnd;
            ++stopped;
          }
        }
        all_done = all_done && pixels[p].done;
      }
    }
  }
  [[unroll]] for (uint p = 0u; p < kPixels; ++p) {
    if (kTilted != 0u) take_tilted_before(pixels[p], 1.0 / 0.0, 0u);
    const uvec2 at = pixel_of(p);
    if (any(greaterThanEqual(at, view.size))) continue;
    const vec3 background = texelFetch(opaque_color, ivec2(at), 0).rgb;
    imageStore(result, ivec2(at), vec4(pixels[p].light + background * pixels[p].through, 1.0));
  }
  const uint stops = subgroupAdd(stopped);
  if (subgroupElect() && stops != 0u) atomicAdd(totals.stopped_pixels, stops);
}
