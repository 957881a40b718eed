// Methods that call themselves exact, on everything that is shipped.
#include <algorithm>

#include "sandbox/measure/metrics.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class ExactMethods : public GpuTest, public testing::WithParamInterface<std::string> {};

INSTANTIATE_TEST_SUITE_P(Shipped, ExactMethods,
                         testing::ValuesIn(PresetLibrary(PLUME_SOURCE_PRESETS).ids(PresetKind::kScene)),
                         [](const auto& scene) { return scene.param; });

TEST_P(ExactMethods, AgreeWithTheReference) {
  constexpr glm::uvec2 size{128, 72};
  Stage stage(device, pipelines, library, library.scene(GetParam()));
  // Peeling draws every card once for each layer: of the scenes that are all about many cards, a part.
  const bool load = GetParam() == "mist" || GetParam() == "everything";
  const uint32_t tick = std::min(stage.scene().default_tick, load ? 90u : UINT32_MAX);
  const Targets targets(device, size);  // before haze and lens, which not every method can serve
  stage.go_to(tick, size);
  MethodInstance reference = instance("reference");
  const Image exact = draw(stage, targets, reference).linear;
  float brightest = 0.0f;
  for (const glm::vec3& pixel : exact.pixels) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
  for (const std::string& id : method_ids()) {
    // Room for the deepest pixels, where room is a parameter.
    MethodInstance method = id == "linked_list" ? instance(id, {{"fragments", "256"}}) : instance(id);
    if (!method.method->traits().exact || !method.method->missing(device).empty()) continue;
    SCOPED_TRACE(id);
    const Image drawn = draw(stage, targets, method).linear;
    EXPECT_LT(rmse(exact, drawn), 1e-3 * brightest);
    EXPECT_LT(max_abs(exact, drawn).value, (1e-3 + method.method->traits().rounding) * brightest);
  }
}

}  // namespace
}  // namespace plume
