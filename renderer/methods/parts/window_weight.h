// The weight of McGuire's coloured and phenomenological transparency is a function of window depth: its two
// parameters, for methods/<id>/weight.glsl.
#ifndef PLUME_METHODS_WINDOW_WEIGHT_H
#define PLUME_METHODS_WINDOW_WEIGHT_H

#include <bit>

#include "renderer/gpu/pipelines.h"
#include "renderer/parameters.h"

namespace plume {

struct WindowWeight {
  bool far_scene = false;
  float near_scale = 1.0f;

  void visit(ParameterVisitor& visitor) {
    visitor.toggle("far_scene", far_scene,
                   "divides the weight by depth^1.5, for scenes whose window depths are all near one");
    visitor.number("near_scale", near_scale,
                   {.min = 0.01,
                    .max = 1000.0,
                    .unit = "",
                    .help = "of the near plane that the weight's window depth is made with: tunes the weight "
                            "to the scene"});
  }
  /// The first constants of the shaders.
  gpu::Constants constants() const { return {far_scene ? 1u : 0u, std::bit_cast<uint32_t>(near_scale)}; }
};

}  // namespace plume
#endif
