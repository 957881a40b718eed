// What is at one pixel of a picture that stands, and what methods believe of it: exact fragments front to
// back, whose they are and how much of each is seen; the transmittance over depth of any method, and what it
// weighs each fragment by. `plume probe` prints it and the window's crosshair shows it.
#ifndef PLUME_MEASURE_PIXEL_PROBE_H
#define PLUME_MEASURE_PIXEL_PROBE_H

#include "renderer/drawn_pixel.h"
#include "sandbox/scene/card_owner.h"

namespace plume {

struct PixelFragment {
  float depth_m;
  uint32_t card;
  CardOwner owner;
  glm::vec3 light;     ///< that it adds: colour times alpha, and emission
  glm::vec3 color;     ///< not premultiplied; black where nothing covers
  glm::vec3 emission;  ///< radiance added whatever it covers
  float alpha;
  glm::vec3 transmittance;
  glm::vec3 weight;  ///< exact: the product of the transmittances in front of it, in double precision
};

struct MethodAtPixel {
  std::string id, name;  ///< `name` tells the same method of two sides apart
  nlohmann::json settings;
  std::string status = "ok";               ///< otherwise why there is nothing
  std::vector<glm::vec3> transmittance{};  ///< in front of each of the depths
  std::vector<glm::vec3> weights{};        ///< of each of the fragments, as the method's draw takes it
  DepthMarks marks{};
};

struct PixelProbe {
  std::string scene;
  uint32_t tick;
  glm::uvec2 size, pixel;
  std::optional<float> opaque_m;         ///< depth of the opaque surface; nothing: sky
  std::vector<PixelFragment> fragments;  ///< front to back
  std::vector<float> depths_m;           ///< at which methods are asked; ascending
  std::vector<MethodAtPixel> methods{};

  /// The exact step function: what all fragments nearer than `depth_m` let pass.
  glm::dvec3 exact_transmittance(double depth_m) const;
};

struct ProbedDepths {
  uint32_t count = 128;
  /// Nothing: from a little before the first fragment to a little behind the last.
  std::optional<std::pair<float, float>> range_m = {};
};

/// Everything but methods, of the picture that was drawn last into `targets`.
PixelProbe probe_pixel(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                       const Targets& targets, glm::uvec2 pixel, const ProbedDepths& depths = {});

/// A method that the device lacks something for is told by its status.
MethodAtPixel unavailable_at_pixel(gpu::Device& device, const MethodInstance& instance);
/// Of the method that drew that picture.
MethodAtPixel probe_method(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                           const Targets& targets, const MethodInstance& instance, const PixelProbe& at);

}  // namespace plume
#endif
