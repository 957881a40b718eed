// The procedural card textures, made on the GPU from a seed; see shaders/effects/puff_density.comp.
#ifndef PLUME_EFFECTS_PUFF_TEXTURES_H
#define PLUME_EFFECTS_PUFF_TEXTURES_H

#include "renderer/gpu/frame.h"

namespace plume {

gpu::Image make_puff_textures(gpu::Device& device, gpu::Pipelines& pipelines, uint32_t seed);

}  // namespace plume
#endif
