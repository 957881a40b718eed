// Methods that keep absorbance over depth, on cards that are put where a test wants them, beside what they
// should know of them in double precision.
#ifndef PLUME_TESTS_ABSORBANCE_SCENE_H
#define PLUME_TESTS_ABSORBANCE_SCENE_H

#include <algorithm>

#include "tests/gpu/avboit_scene.h"

namespace plume {

class AbsorbanceTest : public AvboitTest {
 protected:
  using Map = std::map<std::string, std::string>;
  Random random{1};

  AbsorbanceTest() { size = {16, 12}; }

  struct Shot {
    DrawnPicture picture;
    MethodInstance method;
  };
  Shot shoot(std::string_view id, const Map& settings) {
    const std::unique_ptr<World> w = world();
    Shot shot{.picture = {}, .method = instance(id, settings)};
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), shot.method);
    shot.picture = read_picture(device, w->targets);
    return shot;
  }
  /// What the method believes of a pixel.
  std::vector<glm::vec3> probe_at(std::string_view id, glm::uvec2 pixel, const std::vector<float>& depths,
                                  const Map& settings) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance(id, settings);
    const Probe probe(device, pixel, depths);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
    return probe.read_answer(device);
  }
  /// sum C a w and sum a w, of each pixel.
  std::vector<glm::vec4> weighted_sums(const Shot& shot) {
    return read_layer<glm::vec4>(shot.method.resources.image("accum"), 0);
  }

  /// A step of absorbance at a place in a pixel's range, 0..1.
  struct Step {
    double place;
    glm::dvec3 absorbance;
  };
  /// What the method may know at a pixel: its scene's cards, as steps.
  std::vector<Step> steps_at(glm::dvec2 pixel, bool scene_range, bool each_channel) const {
    std::vector<std::pair<double, glm::dvec3>> hits;
    double nearest = 1e30, farthest = 0;
    for (const shared::Card& card : cards()) {
      const std::optional<double> depth = hit(card, pixel);
      if (!depth || card.optical_depth <= 0) continue;
      const glm::vec2 rg = glm::unpackHalf2x16(card.transmission.x),
                      b = glm::unpackHalf2x16(card.transmission.y);
      const glm::dvec3 passes(rg.x, rg.y, b.x);
      glm::dvec3 t = passes + (1.0 - passes) * std::exp(-double(card.optical_depth));
      if (!each_channel) t = glm::dvec3((t.r + t.g + t.b) / 3.0);
      hits.emplace_back(*depth, -glm::log(glm::max(t, 1.1e-7)));
      nearest = std::min(nearest, *depth), farthest = std::max(farthest, *depth);
    }
    const shared::ViewData eye = view();
    if (scene_range) nearest = double(eye.near_m), farthest = double(eye.far_m);
    std::vector<Step> steps;
    for (const auto& [depth, absorbance] : hits) {
      const double place = std::log(depth / nearest) / std::max(std::log(farthest / nearest), 1e-6);
      steps.push_back({.place = std::clamp(place, 0.0, 1.0), .absorbance = absorbance});
    }
    return steps;
  }
  void add_random_cards(uint32_t number, bool coloured) {
    for (uint32_t i = 0; i < number; ++i) {
      const float z = float(random.octaves(0.5, 60));
      add({.z = z,
           .optical_depth = random.one_in(9) ? shared::kOpaqueDepth : float(random.octaves(0.001, 3)),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .transmission = coloured && random.one_in(2)
                               ? glm::vec3(random.f(0, 1), random.f(0, 1), random.f(0, 1))
                               : glm::vec3(0.0f),
           .half_size = glm::vec2(2 * z),
           .yaw = random.f(-0.3, 0.3),
           .pitch = random.f(-0.3, 0.3)});
    }
  }
};

}  // namespace plume
#endif
