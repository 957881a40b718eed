// A glance at a frame: one number for each pixel, of the frame just recorded and with the resources that it
// was drawn with.
#ifndef PLUME_RENDERER_GLANCE_H
#define PLUME_RENDERER_GLANCE_H

#include "renderer/methods/method.h"

namespace plume {

/// Which view is asked for, and where its numbers go.
struct Glance {
  std::string id;        ///< of an Inspection
  uint32_t slice;        ///< of the views that have slices
  gpu::Buffer values{};  ///< on the device: a float a pixel, row by row

  Glance(gpu::Device& device, glm::uvec2 size, std::string id, uint32_t slice = 0);
  /// NaN where there is nothing. Waits for the device.
  std::vector<float> read_values(gpu::Device& device) const;
};

/// All that can be looked at with a method as it is set: what every method has, then its own.
std::vector<Inspection> inspections_of(const Method& method);

/// Records the pass "inspect" behind the method's own passes. Throws std::invalid_argument for a view that
/// inspections_of() does not have.
void record_glance(const Picture& picture, const Method& method, const Glance& glance);

/// Runs a method's own view shader, which includes inspect/inspect.glsl and is given what it binds beyond
/// that.
void glance_with(const Picture& picture, const Glance& glance, const std::string& shader,
                 const gpu::Constants& constants, gpu::Bindings bindings);

}  // namespace plume
#endif
