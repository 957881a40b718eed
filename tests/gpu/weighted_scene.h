// Stacks of layers that cover the whole picture, for the methods that blend in any order by weights: the same
// layers as cards and as numbers.
#ifndef PLUME_TESTS_WEIGHTED_SCENE_H
#define PLUME_TESTS_WEIGHTED_SCENE_H

#include "tests/gpu/avboit_scene.h"
#include "tests/gpu/wboit_weights.h"

namespace plume {

struct WeightedLayer {
  glm::dvec3 color{0.0};  ///< not premultiplied
  double coverage = 0.5;
  glm::dvec3 transmission{0.0};
  double z = 5.0;

  double reduced() const { return coverage * (1 - (transmission.r + transmission.g + transmission.b) / 3); }
  /// Of the background that passes.
  glm::dvec3 passed() const { return 1.0 - coverage * (1.0 - transmission); }
};

class WeightedTest : public AvboitTest {
 protected:
  struct Drawn {
    std::vector<glm::vec3> pixels;
    nlohmann::json statistics;
    std::vector<glm::vec4> surface;  ///< where the picture wants it
  };

  void SetUp() override { size = {8, 4}; }

  static PlacedCard card_of(const WeightedLayer& layer, uint32_t texture = 0) {
    return {.z = float(layer.z),
            .optical_depth = layer.coverage < 1 ? float(-std::log1p(-layer.coverage)) : shared::kOpaqueDepth,
            .color = glm::vec3(layer.color),
            .transmission = glm::vec3(layer.transmission),
            .layer = texture};
  }
  void stack(const std::vector<WeightedLayer>& layers) {
    clear_cards();
    for (const WeightedLayer& layer : layers) add(card_of(layer));
  }
  /// From none to twelve layers, some of them opaque, some clear, some coloured.
  static std::vector<WeightedLayer> random_stack(Random& random) {
    std::vector<WeightedLayer> layers(random.below(13));
    for (WeightedLayer& layer : layers) {
      layer.z = random.octaves(0.4, 60);
      layer.coverage = random.one_in(8) ? 1.0 : random.between(0.02, 0.97);
      for (int c = 0; c < 3; ++c) {
        layer.color[c] = random.between(0, 1);
        layer.transmission[c] = random.one_in(2) ? 0.0 : random.between(0, 0.95);
      }
      if (random.one_in(3)) layer.transmission = glm::dvec3(0);
    }
    return layers;
  }
  /// What cards can hold of a colour.
  static glm::dvec3 halved(glm::dvec3 v) {
    return {glm::unpackHalf1x16(glm::packHalf1x16(float(v.x))),
            glm::unpackHalf1x16(glm::packHalf1x16(float(v.y))),
            glm::unpackHalf1x16(glm::packHalf1x16(float(v.z)))};
  }

  Drawn draw(const World& w, std::string_view id, const std::map<std::string, std::string>& settings) {
    MethodInstance method = instance(id, settings);
    render_frame(device, pipelines, w.targets, w.prelude(), w.transparents(), method);
    Drawn drawn{.pixels = read_picture(device, w.targets).linear.pixels,
                .statistics = method.method->statistics(device, method.resources),
                .surface = {}};
    if (w.targets.surface)
      for (const uint64_t texel : gpu::read<uint64_t>(device, w.targets.surface))
        drawn.surface.push_back(glm::unpackHalf4x16(texel));
    return drawn;
  }
  Drawn draw(std::string_view id, const std::map<std::string, std::string>& settings = {},
             const Post& post = {}) {
    const auto w = world();
    w->targets = Targets(device, size, post);
    return draw(*w, id, settings);
  }
  /// What the method believes to be in front of a depth, in the middle of the picture.
  glm::vec3 probe_at(std::string_view id, double z, const std::map<std::string, std::string>& settings = {}) {
    const auto w = world();
    MethodInstance method = instance(id, settings);
    const Probe probe(device, {size.x / 2, size.y / 2}, {float(z)});
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
    return probe.read_answer(device)[0];
  }
  const glm::vec3& middle(const Drawn& drawn) const {
    return drawn.pixels[size_t(size.y / 2) * size.x + size.x / 2];
  }
  static void expect_near(glm::dvec3 expected, glm::vec3 got, double tolerance, const std::string& what) {
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(expected[c], double(got[c]), tolerance) << what << ", channel " << c;
  }
};

}  // namespace plume
#endif
