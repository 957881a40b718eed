#include "sandbox/scene/debris.h"

#include <algorithm>
#include <iterator>

#include "shaders/effects/debris.h"

namespace plume {
namespace {

struct CountPush {
  shared::DebrisDraw drawn;
  uint32_t count, first_index;
};

shared::DebrisDraw draw_of(const shared::Span& span) {
  return {.emitter = span.emitter,
          .first = span.first,
          .base = span.base,
          .capacity = span.capacity,
          .first_slot = span.first_slot};
}

void count_bad(gpu::Pass& pass, const Simulation::Pieces& pieces, const gpu::Buffer& bad, uint32_t index) {
  for (const auto& [span, triangles] : pieces.draws) {
    if (span.count > 0)
      pass.dispatch(pass.pipelines().compute("effects/bad_pieces.comp"),
                    {{"Particles", pieces.particles}, {"Bad", &bad}},
                    CountPush{.drawn = draw_of(span), .count = span.count, .first_index = index},
                    {gpu::groups(span.count, shared::kSpanGroup), 1, 1});
    index += span.count;
  }
}

void draw_pieces(gpu::Pass& pass, const Simulation::Pieces& pieces, const gpu::Draw& style) {
  for (const auto& [span, triangles] : pieces.draws) {
    gpu::Draw draw = style;
    draw.vertex = "opaque/debris.vert";
    draw.bindings.insert(draw.bindings.end(), {{"Particles", pieces.particles},
                                               {"Emitters", pieces.emitters},
                                               {"Curves", pieces.curves},
                                               {"MeshRanges", pieces.mesh_ranges},
                                               {"MeshTriangles", pieces.mesh_triangles}});
    draw.vertices = 3 * triangles;
    draw.instances = span.count;
    pass.draw(draw, draw_of(span));
  }
}

}  // namespace

void record_debris_depth(gpu::Frame& frame, const Targets& targets, const Simulation::Pieces& pieces,
                         const gpu::Buffer& view, const gpu::Buffer& bad, uint32_t first_index) {
  if (pieces.draws.empty()) return;
  frame.pass("debris depth", [&](gpu::Pass& pass) {
    count_bad(pass, pieces, bad, first_index);
    draw_pieces(pass, pieces,
                {.depth = &targets.opaque_depth,
                 .depth_use = gpu::DepthUse::kTestAndWrite,
                 .area = {targets.size.x, targets.size.y},
                 .bindings = {{"View", &view}}});
  });
}

void record_debris_color(gpu::Frame& frame, const Targets& targets, const gpu::Image& depth,
                         const Simulation::Pieces& pieces, const gpu::Buffer& view, const gpu::Buffer& solids,
                         const Lighting& lighting) {
  if (pieces.draws.empty()) return;
  gpu::Bindings bindings{{"View", &view}, {"Solids", &solids}};
  const bool lit = lighting.bodies();
  if (lit) std::ranges::move(lighting.bindings(), std::back_inserter(bindings));
  frame.pass("debris", [&](gpu::Pass& pass) {
    draw_pieces(pass, pieces,
                {.fragment = lit ? "opaque/debris_lit.frag" : "opaque/debris.frag",
                 .targets = {{.image = &targets.opaque_color, .blend = gpu::Blend::kReplace, .clear = {}}},
                 .depth = &depth,  // equal where visible
                 .depth_use = gpu::DepthUse::kTest,
                 .area = {targets.size.x, targets.size.y},
                 .constants = lit ? gpu::Constants{lighting.shadows() ? 1u : 0u} : gpu::Constants{},
                 .bindings = bindings});
  });
}

}  // namespace plume
