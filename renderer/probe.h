// What a method believes of one pixel: the transmittance in front of any depth there, as the frame that was
// drawn used it.
#ifndef PLUME_RENDERER_PROBE_H
#define PLUME_RENDERER_PROBE_H

#include "renderer/methods/method.h"
#include "shaders/probe/probe.h"

namespace plume {

/// Where, and what is asked. The buffers hold a shared::ProbeQuery with the points, and a vec3 for each
/// point.
struct Probe {
  glm::uvec2 pixel;
  std::vector<shared::ProbedPoint> points;
  gpu::Buffer query, answer{};  ///< on the device

  Probe(gpu::Device& device, glm::uvec2 pixel, std::span<const shared::ProbedPoint> points);
  /// Of a bare light at each of these view depths, m.
  Probe(gpu::Device& device, glm::uvec2 pixel, const std::vector<float>& depths);
  /// Transmittance of each channel in front of each point. Waits for the device.
  std::vector<glm::vec3> read_answer(gpu::Device& device) const;
};

/// Runs a method's own probe shader, which includes probe/probe.glsl and is given what it binds beyond that.
void probe_with(const Picture& picture, const Probe& probe, const std::string& shader,
                const gpu::Constants& constants, gpu::Bindings bindings);

enum class InFront { kByDepth, kByCenter };
/// For methods that keep no function of depth: draws the cards again and multiplies what those let through
/// that lie in front, by their own depth at the pixel, or by that of their centres.
void probe_by_drawing(const Picture& picture, const Probe& probe, InFront in_front);

}  // namespace plume
#endif
