#include "renderer/post.h"

#include "shaders/post/lens.h"

namespace plume {
namespace {

uint32_t tile_pixels(glm::uvec2 size) {
  return std::max((size.y + shared::kMostCircleOfHeight - 1) / shared::kMostCircleOfHeight,
                  shared::kLeastTilePixels);
}

std::array<uint32_t, 3> squares_of_8(glm::uvec2 size) {
  return {gpu::groups(size.x, 8), gpu::groups(size.y, 8), 1};
}

void distort(gpu::Frame& frame, const Targets& targets, const gpu::Buffer& view, const gpu::Image& from,
             const gpu::Image& to) {
  frame.pass("distort", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("post/distort.comp"),
                  {{"View", &view},
                   {"distortion", &targets.distortion},
                   {"opaque_depth", &targets.opaque_depth},
                   {"composed", &from},
                   {"distorted", &to}},
                  targets.size, squares_of_8(targets.size));
  });
}

void depth_of_field(gpu::Frame& frame, const Targets& targets, bool has_surface, const gpu::Buffer& view,
                    const gpu::Image& from, const gpu::Image& to) {
  const shared::LensPush push{.size = targets.size,
                              .tiles = circle_tile_count(targets.size),
                              .tile_pixels = tile_pixels(targets.size),
                              .focus_m = targets.post.lens->focus_m,
                              .aperture_m = targets.post.lens->aperture_mm * 1e-3f};
  frame.pass("depth_of_field", [&](gpu::Pass& pass) {
    if (!has_surface) pass.clear(targets.surface, {0, 0, 0, 0});  // opaque depth is all that is known
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("post/circles.comp"),
                  {{"View", &view},
                   {"surface", &targets.surface},
                   {"opaque_depth", &targets.opaque_depth},
                   {"circles", &targets.circles},
                   {"circle_tiles", &targets.circle_tiles}},
                  push, {push.tiles.x, push.tiles.y, 1});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("post/depth_of_field.comp"),
                  {{"circles", &targets.circles},
                   {"circle_tiles", &targets.circle_tiles},
                   {"composed", &from},
                   {"blurred", &to}},
                  push, squares_of_8(targets.size));
  });
}

}  // namespace

glm::uvec2 circle_tile_count(glm::uvec2 size) {
  return (size + tile_pixels(size) - 1u) / tile_pixels(size);
}

PostChain::PostChain(const Targets& targets, const Outputs& written) : targets_(targets), written_(written) {}

const gpu::Image& PostChain::method_target() const {
  return written_.distortion != targets_.post.lens.has_value() ? targets_.composed : targets_.result;
}

void PostChain::record(gpu::Frame& frame, const gpu::Buffer& view) const {
  const gpu::Image* at = &method_target();
  const auto other = [&] { return at == &targets_.result ? &targets_.composed : &targets_.result; };
  if (written_.distortion) {
    distort(frame, targets_, view, *at, *other());
    at = other();
  }
  if (targets_.post.lens) depth_of_field(frame, targets_, written_.surface, view, *at, *other());
}

}  // namespace plume
