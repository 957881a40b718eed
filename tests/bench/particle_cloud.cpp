#include "tests/bench/particle_cloud.h"

#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"

namespace plume {

CardMaker::CardMaker(const Simulation& simulation)
    : cards_(bench_device().device, {.owner = "bench",
                                     .label = "cards",
                                     .bytes = uint64_t(simulation.cards()) * sizeof(shared::Card)}) {
  Scene scene;
  scene.camera = {CameraKey{}};
  view_ = gpu::make_buffer(bench_device().device, "bench", "view",
                           std::vector{make_view(scene, scene.camera[0], {640, 360}, 30)});
}

std::vector<gpu::PassTime> CardMaker::make(const Simulation& simulation) {
  gpu::Frame frame(bench_device().device, bench_device().pipelines);
  frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view_, cards_, 0); });
  return frame.finish();
}

}  // namespace plume
