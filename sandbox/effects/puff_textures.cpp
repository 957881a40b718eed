#include "sandbox/effects/puff_textures.h"

#include <glm/glm.hpp>

#include "shaders/effects/puff.h"

namespace plume {

gpu::Image make_puff_textures(gpu::Device& device, gpu::Pipelines& pipelines, uint32_t seed) {
  using namespace shared;
  const gpu::Buffer march(device,
                          {.owner = "textures",
                           .label = "march",
                           .bytes = uint64_t(kPuffSize) * kPuffSize * kDiscLayer * sizeof(glm::vec2)});
  gpu::Image puffs(device, {.owner = "textures",
                            .label = "puffs",
                            .format = vk::Format::eR8G8B8A8Unorm,
                            .extent = {kPuffSize, kPuffSize, 1},
                            .layers = kPuffLayers,
                            .usage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled});
  gpu::Frame frame(device, pipelines);
  frame.pass("puff density", [&](gpu::Pass& pass) {
    pass.dispatch(pipelines.compute("effects/puff_density.comp"), {{"March", &march}}, seed,
                  {kPuffSize / 8, kPuffSize / 8, kDiscLayer});
  });
  frame.pass("puff encode", [&](gpu::Pass& pass) {
    pass.dispatch(pipelines.compute("effects/puff_encode.comp"), {{"March", &march}, {"puffs", &puffs}}, seed,
                  {1, 1, kPuffLayers});
  });
  frame.finish();
  return puffs;
}

}  // namespace plume
