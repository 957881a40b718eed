// What is drawn transparent, and how a method draws it: every card, with the shared vertex shader and the
// method's fragment shader.
#ifndef PLUME_RENDERER_TRANSPARENTS_H
#define PLUME_RENDERER_TRANSPARENTS_H

#include <glm/glm.hpp>

#include "renderer/gpu/frame.h"

namespace plume {

/// The cards of one tick and what shading them needs. Owned by whoever fills them; methods only draw.
struct Transparents {
  const gpu::Buffer* cards = nullptr;  ///< shared::Card[count]
  const gpu::Buffer* order = nullptr;  ///< uint[count], a permutation: the order of submission
  const gpu::Image* puffs =
      nullptr;  ///< array of optical depth, normal, openness; see shaders/effects/puff.comp
  const gpu::Buffer* view = nullptr;  ///< shared::ViewData
  uint32_t count = 0;

  struct Style {
    std::string fragment;  ///< the method's shader
    std::vector<gpu::Attachment> targets;
    const gpu::Image* depth_test = nullptr;  ///< null: the shader tests for itself
    const gpu::Image* opaque_depth =
        nullptr;  ///< what shade() feathers against, at the resolution of the draw
    gpu::Area area{0, 0};
    gpu::Constants constants;
    gpu::Bindings bindings;              ///< the method's own, bindings 8 and up
    const gpu::Buffer* order = nullptr;  ///< instead of the order of submission
    bool backwards = false;              ///< last of the order first
    glm::vec2 covered{1.0f};  ///< share of `area` that the picture fills, when cells do not divide it
  };
  void draw(gpu::Pass& pass, const Style& style) const;
};

}  // namespace plume
#endif
