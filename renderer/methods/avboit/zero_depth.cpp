#include "renderer/methods/avboit/plan.h"
#include "shaders/methods/avboit/zero_tile.h"

namespace plume::avboit {
namespace {

glm::uvec2 tiles_of(glm::uvec2 size) {
  return (size + shared::kZeroTilePixels - 1u) / shared::kZeroTilePixels;
}

}  // namespace

void add_zero_depth_needs(Needs& needs, const Plan& plan) {
  if (plan.settings.zero_depth == ZeroDepth::kOff) return;
  const glm::uvec2 tiles = tiles_of(plan.size);
  const uint64_t count = uint64_t(tiles.x) * tiles.y;
  needs.images.push_back(
      {.name = "visible_depth",
       .format = vk::Format::eD32Sfloat,
       .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled});
  needs.buffers.push_back({.name = "zero_draw", .bytes = sizeof(shared::DrawCommand), .clear = {}});
  needs.buffers.push_back({.name = "zero_tiles", .bytes = count * sizeof(shared::ZeroTile), .clear = {}});
  needs.buffers.push_back({.name = "zero_depths", .bytes = count * 4, .clear = {}});
}

const gpu::Image& visible_depth(const Picture& picture, const Plan& plan) {
  return plan.settings.zero_depth == ZeroDepth::kOff ? picture.opaque_depth
                                                     : picture.resources.image("visible_depth");
}

void record_zero_depth(const Picture& picture, const Plan& plan) {
  if (plan.settings.zero_depth == ZeroDepth::kOff) return;
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const glm::uvec2 tiles = tiles_of(plan.size);
  picture.frame.pass("zero_tiles", [&](gpu::Pass& pass) {
    pass.update(*buffer("zero_draw"),
                shared::DrawCommand{.vertices = 4, .instances = 0, .first_vertex = 0, .first_instance = 0});
    pass.copy(picture.opaque_depth, visible_depth(picture, plan));
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/avboit/zero_depth.comp"),
                  {{"View", picture.transparents.view},
                   {"VolumeBlock", buffer("volume")},
                   {"WarpTable", buffer("warp")},
                   {"ZeroSlice", buffer("zero_slice")},
                   {"ZeroArguments", buffer("zero_draw")},
                   {"ZeroTiles", buffer("zero_tiles")},
                   {"ZeroDepths", buffer("zero_depths")}},
                  tiles, {gpu::groups(uint64_t(tiles.x) * tiles.y, 64), 1, 1});
  });
  const gpu::Draw common{.vertex = "",
                         .fragment = "",
                         .targets = {},
                         .depth = &visible_depth(picture, plan),
                         .depth_use = gpu::DepthUse::kTestAndWrite,
                         .area = picture.area(),
                         .constants = {},
                         .bindings = {}};
  picture.frame.pass("zero_depth", [&](gpu::Pass& pass) {
    gpu::Draw draw = common;
    if (plan.settings.zero_depth == ZeroDepth::kQuads) {
      draw.vertex = "methods/avboit/zero_quads.vert";
      draw.bindings = {{"ZeroTiles", buffer("zero_tiles")}};
      draw.indirect = buffer("zero_draw");
      draw.strip = true;
      pass.draw(draw, plan.size);
    } else {
      draw.vertex = "post/fullscreen.vert";
      draw.fragment = "methods/avboit/zero_fullscreen.frag";
      draw.bindings = {{"ZeroDepths", buffer("zero_depths")}};
      pass.draw(draw, tiles);
    }
  });
}

}  // namespace plume::avboit
