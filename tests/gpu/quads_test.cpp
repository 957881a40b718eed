// The quads of the seed articles: the exact value where blue over green over red overlap, and WBOIT by its
// formula.
#include <algorithm>
#include <cmath>

#include "tests/gpu/gpu_test.h"
#include "tests/gpu/wboit_weights.h"

namespace plume {
namespace {

struct Layer {
  glm::dvec3 color;  // not premultiplied
  double alpha, z;   // view depth
};

class QuadsTest : public GpuTest {
 protected:
  static constexpr glm::uvec2 kPicture{320, 180};

  /// The scene's panes that cover a world point of the plane z = 0 as seen by the scene's camera, which looks
  /// along -z.
  static std::vector<Layer> layers_at(const Scene& scene, glm::dvec2 ndc) {
    const CameraKey& camera = scene.camera[0];
    const double tan_y = std::tan(glm::radians(double(camera.vertical_fov_deg)) / 2),
                 aspect = double(kPicture.x) / kPicture.y;
    std::vector<Layer> layers;
    for (const Pane& pane : scene.panes) {
      const double depth = camera.position.z - pane.position.z;
      const double x = ndc.x * tan_y * aspect * depth, y = -ndc.y * tan_y * depth;
      if (std::abs(x - pane.position.x) < pane.size_m.x / 2 &&
          std::abs(y - pane.position.y) < pane.size_m.y / 2)
        layers.push_back({pane.color, pane.coverage, depth});
    }
    return layers;
  }
  static glm::dvec2 ndc_of(size_t pixel) {
    return {(double(pixel % kPicture.x) + 0.5) / kPicture.x * 2 - 1,
            (double(pixel / kPicture.x) + 0.5) / kPicture.y * 2 - 1};
  }

  static glm::dvec3 exact(std::vector<Layer> layers, glm::dvec3 background) {
    std::ranges::sort(layers, {}, &Layer::z);
    glm::dvec3 light(0.0);
    double through = 1;
    for (const Layer& layer : layers) {
      light += layer.color * layer.alpha * through;
      through *= 1 - layer.alpha;
    }
    return light + background * through;
  }

  static glm::dvec3 weighted_blended(const std::string& name, const std::vector<Layer>& layers,
                                     glm::dvec3 background, const Scene& scene) {
    glm::dvec3 sum(0.0);
    double weights = 0, reveal = 1;
    for (const Layer& layer : layers) {
      const double w = wboit_weight(name, layer.color, layer.alpha, layer.z, scene.near_m, scene.far_m);
      sum += layer.color * layer.alpha * w;
      weights += layer.alpha * w;
      reveal *= 1 - layer.alpha;
    }
    return sum / std::max(weights, 1e-5) * (1 - reveal) + background * reveal;
  }

  /// Largest difference over pixels whose neighbours see the same layers (edges are rasterisation, not
  /// blending).
  template <class Expected>
  double worst_difference(const Scene& scene, const DrawnPicture& picture, const DrawnPicture& background,
                          Expected expected) {
    double worst = 0;
    size_t compared = 0;
    const glm::dvec2 texel(2.0 / kPicture.x, 2.0 / kPicture.y);
    for (size_t i = 0; i < picture.linear.pixels.size(); ++i) {
      const glm::dvec2 ndc = ndc_of(i);
      const auto layers = layers_at(scene, ndc);
      if (layers.empty() || layers.size() != layers_at(scene, ndc + texel).size() ||
          layers.size() != layers_at(scene, ndc - texel).size())
        continue;
      ++compared;
      const glm::dvec3 wanted = expected(layers, glm::dvec3(background.linear.pixels[i]));
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(wanted[c] - double(picture.linear.pixels[i][c])));
    }
    EXPECT_GT(compared, 1000u);
    return worst;
  }

  DrawnPicture background_of(Scene scene) {
    scene.panes.clear();
    Stage stage(device, pipelines, library, scene);
    return draw(stage, 0, kPicture, "reference");
  }

  /// Every weight drawn and compared with its formula.
  void expect_formulas(const Scene& scene, double tolerance) {
    const DrawnPicture background = background_of(scene);
    for (const std::string weight : kWboitWeights) {
      Stage stage(device, pipelines, library, scene);
      const DrawnPicture picture = draw(stage, 0, kPicture, "wboit", {{"weight", weight}});
      const auto formula = [&](const std::vector<Layer>& layers, glm::dvec3 behind) {
        return weighted_blended(weight, layers, behind, scene);
      };
      EXPECT_LT(worst_difference(scene, picture, background, formula), tolerance) << weight;
    }
  }
};

TEST_F(QuadsTest, BlueOverGreenOverRedAtHalfCoverageIsAQuarterAQuarterAHalf) {
  for (const char* name : {"quads_learnopengl", "quads_mcguire"}) {
    const Scene scene = library.scene(name);
    Stage stage(device, pipelines, library, scene);
    const DrawnPicture picture = draw(stage, 0, kPicture, "reference");
    size_t found = 0;
    for (const glm::vec3& pixel : picture.linear.pixels)
      found += glm::all(glm::lessThan(glm::abs(pixel - glm::vec3(0.25, 0.25, 0.5)), glm::vec3(1e-3f)));
    EXPECT_GT(found, 100u) << name;
  }
}

TEST_F(QuadsTest, TheReferenceIsTheOverOperatorEverywhere) {
  for (const char* name : {"quads_learnopengl", "quads_mcguire"}) {
    const Scene scene = library.scene(name);
    Stage stage(device, pipelines, library, scene);
    EXPECT_LT(worst_difference(scene, draw(stage, 0, kPicture, "reference"), background_of(scene), exact),
              1e-3)
        << name;
  }
}

TEST_F(QuadsTest, WboitIsWhatEachOfItsFormulasSays) {
  for (const char* name : {"quads_learnopengl", "quads_mcguire"}) {
    const Scene scene = library.scene(name);
    SCOPED_TRACE(name);
    expect_formulas(scene, 1.0 / 255);
  }
}

TEST_F(QuadsTest, WboitIsWhatEachOfItsFormulasSaysForThinLayers) {
  // The demo's weight is at its clamp of 3000 for every coverage above 0.03, at any depth: only thin layers
  // tell its shape.
  Scene scene;
  scene.id = "thin";
  scene.tonemap = Tonemap::kNone;
  scene.light.sky = false;
  scene.light.horizon = {0, 0, 0};
  scene.far_m = 100;
  scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
  for (int i = 0; i < 3; ++i) {
    Pane pane;
    pane.position = {0, 0, 4 - 2 * i};
    pane.size_m = {60, 60};
    pane.coverage = 0.004f + 0.006f * float(i);
    pane.color[i] = 1;
    scene.panes.push_back(pane);
  }
  expect_formulas(scene, 1.0 / 1024);  // revealage near 1 has steps of 2^-11 in 16 bits, three layers of them
}

}  // namespace
}  // namespace plume
