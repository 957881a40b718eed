// Tile-sorted compute: a thread a pixel walks its tile's list front to back and composites in registers,
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i,
// until what is still behind cannot change the pixel by stop_below:  max(t) (brightest behind + all that shines behind) < stop_below.
// The threads of a subgroup share a few neighbouring pixels: each tests one card of the list against all of these, and together
// they shade those that touch, so that no thread takes another road than its neighbours.
// Fragments of tilted cards wait in the pixel's linked list, sorted; they join where their depth says.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_arithmetic : require
#include "methods/fragment_list/sort.glsl"
#include "methods/tile_sorted/tile.glsl"

layout(local_size_x = 64) in;
layout(constant_id = 0) const uint kTile = 16u;     // pixels
layout(constant_id = 1) const uint kTilted = 0u;    // there are fragments of tilted cards
layout(binding = 13) uniform sampler2D opaque_color;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(push_constant, scalar) uniform Push {
  TileGrid grid;
  float stop_below;   // radiance as exposed
};

vec3 light = vec3(0.0), through = vec3(1.0);

void composite(vec3 l, vec3 t) {
  light += l * through;
  through *= t;
}

// Fragments of tilted cards, front to back.
uint node = kListEnd;
float node_depth;

void take_tilted_before(float depth, uint id) {
  Nodes list = Nodes(pool.address);
  while (node != kListEnd && (node_depth < depth || (node_depth == depth && list.nodes[node].id < id))) {
    composite(list.nodes[node].light, list.nodes[node].transmittance);
    node = list.nodes[node].next;
    if (node != kListEnd) node_depth = list.nodes[node].depth;
  }
}

float brightest(vec3 c) { return max(c.r, max(c.g, c.b)); }

void main() {
  // Bits of the thread's index are those of x and y in turn, x first: any run of threads is a block.
  const uint i = gl_SubgroupID * gl_SubgroupSize + gl_SubgroupInvocationID;
  const uvec2 within = uvec2((i & 1u) | (i >> 1u & 2u) | (i >> 2u & 4u), (i >> 1u & 1u) | (i >> 2u & 2u) | (i >> 3u & 4u));
  const uvec2 pixel = gl_WorkGroupID.xy * 8u + within;
  const bool inside = all(lessThan(pixel, view.size));
  const vec2 center = vec2(pixel) + 0.5;
  const float opaque = texelFetch(opaque_depth, ivec2(min(pixel, view.size - 1u)), 0).r;
  const vec3 background = texelFetch(opaque_color, ivec2(min(pixel, view.size - 1u)), 0).rgb;

  const vec2 low = subgroupMin(center), high = subgroupMax(center);
  const vec2 block = 0.5 * (low + high), half_block = 0.5 * (high - low);
  const float farthest = subgroupMin(opaque);   // as near_m / view depth
  bool done = !inside;
  if (kTilted != 0u && inside && pool.count <= pool.capacity) {
    node = sort(Nodes(pool.address), heads[pixel.y * view.size.x + pixel.x]);
    heads[pixel.y * view.size.x + pixel.x] = node;
    if (node != kListEnd) node_depth = Nodes(pool.address).nodes[node].depth;
  }

  const uvec2 tile = gl_WorkGroupID.xy * 8u / kTile;
  const uvec2 range = list_of(tile.y * grid.tiles.x + tile.x, grid.spans);
  bool stopped = false;
  for (uint at = range.x; at < range.y && !subgroupAll(done); at += gl_SubgroupSize) {
    const uint mine = at + gl_SubgroupInvocationID;
    bool in_front = false, touching = false;
    if (mine < range.y) {
      const uint rank = Entries(totals.address).ranks[mine];
      in_front = tile_cards[rank].depth * farthest <= view.near_m;
      touching = in_front && touches(tile_cards[rank].pixel_to_uv, tile_cards[rank].center, block, half_block);
    }
    if (!subgroupAny(in_front)) break;   // neither is anything after these
    uvec2 hits = subgroupBallot(touching).xy;
    while (hits != uvec2(0u)) {
      const uint hit = hits.x != 0u ? uint(findLSB(hits.x)) : 32u + uint(findLSB(hits.y));
      if (hits.x != 0u) hits.x &= hits.x - 1u;
      else hits.y &= hits.y - 1u;
      const TileCard card = tile_cards[Entries(totals.address).ranks[at + hit]];
      if (kTilted != 0u && !done) take_tilted_before(card.depth, card.id);
      Fragment f;
      if (fragment_of(card, center, opaque, f) && !done) {
        composite(f.color + f.emission, transmittance(f));
        stopped = brightest(through) * (card.most_behind + brightest(background)) * view.exposure < stop_below;
        done = done || stopped;
      }
    }
  }
  if (kTilted != 0u && !stopped) take_tilted_before(1.0 / 0.0, 0u);

  const uint stops = subgroupAdd(stopped ? 1u : 0u);
  if (subgroupElect() && stops != 0u) atomicAdd(totals.stopped_pixels, stops);
  if (inside) imageStore(result, ivec2(pixel), vec4(light + background * through, 1.0));
}
