// What can be asked of one pixel of a picture that stands: its fragments, the opaque surface there, what a
// method believes of it. Nothing is drawn anew but what falls on that pixel, so a question costs far less
// than a frame. It holds while the cards, the view and the method's resources are those of the picture.
#ifndef PLUME_RENDERER_DRAWN_PIXEL_H
#define PLUME_RENDERER_DRAWN_PIXEL_H

#include "renderer/frame.h"

namespace plume {

/// Every fragment at the pixel in front of the opaque surface, front to back, those of one depth in the order
/// of their cards: as the exact reference composites them. Haze is none. None is dropped: a list that is too
/// short is made longer.
std::vector<shared::ProbedFragment> fragments_at(gpu::Device& device, gpu::Pipelines& pipelines,
                                                 const Targets& targets, const Transparents& transparents,
                                                 glm::uvec2 pixel);

/// View depth of the opaque surface, m; nothing: sky.
std::optional<float> opaque_depth_at(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                                     const Transparents& transparents, glm::uvec2 pixel);

/// The answer of the method that the picture was drawn with last: the same as in the frame itself.
std::vector<glm::vec3> transmittance_at(gpu::Device& device, gpu::Pipelines& pipelines,
                                        const Targets& targets, const Transparents& transparents,
                                        const MethodInstance& instance, const Probe& probe);

}  // namespace plume
#endif
