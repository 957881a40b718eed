// What is told of one pixel, against the reference's own lists, the scene, the particles, and the picture.
#include "sandbox/measure/pixel_probe_text.h"
#include "sandbox/scene/view.h"
#include "tests/gpu/fragment_lists.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class PixelProbeTest : public GpuTest {
 protected:
  struct Drawn {
    Stage stage;
    Targets targets;
    MethodInstance method;
  };
  /// A scene at its default tick as a method draws it.
  std::unique_ptr<Drawn> drawn(Scene scene, glm::uvec2 size, std::string_view id,
                               const std::map<std::string, std::string>& settings = {}) {
    const uint32_t tick = scene.default_tick;
    auto d = std::unique_ptr<Drawn>(new Drawn{.stage = {device, pipelines, library, std::move(scene)},
                                              .targets = {device, size},
                                              .method = instance(id, settings)});
    d->stage.go_to(tick, size);
    render_frame(device, pipelines, d->targets, d->stage.prelude(), d->stage.transparents(), d->method);
    return d;
  }
  PixelProbe probe(const Drawn& d, glm::uvec2 pixel, const ProbedDepths& depths = {.count = 17}) {
    return probe_pixel(device, pipelines, d.stage, d.targets, pixel, depths);
  }
  MethodAtPixel ask(const Drawn& d, const PixelProbe& at) {
    return probe_method(device, pipelines, d.stage, d.targets, d.method, at);
  }
  /// Cards that face the camera five metres away, in front of grey.
  static Scene room(std::vector<Pane> panes) {
    Scene scene;
    scene.id = "room";
    scene.light.sky = false;
    scene.light.horizon = glm::vec3(0.3f);
    scene.tonemap = Tonemap::kNone;
    scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
    scene.panes = std::move(panes);
    return scene;
  }
  static Pane card(float z, float coverage) {
    return {.position = {0, 0, z}, .size_m = {40, 40}, .coverage = coverage};
  }
};

constexpr glm::uvec2 kSize{96, 54}, kMiddle{48, 27};

TEST_F(PixelProbeTest, FragmentsAreThoseOfTheReferenceBitForBit) {
  for (const char* scene : {"three_cards", "near_layers", "far_layer", "street"}) {
    const auto d = drawn(library.scene(scene), kSize, "reference");
    const FragmentLists lists(device, d->method.resources);
    for (const glm::uvec2 pixel : {kMiddle, glm::uvec2(40, 30), glm::uvec2(0, 0), kSize - 1u}) {
      const auto exact = lists.of(pixel.y * kSize.x + pixel.x);  // sorted by the reference's composite
      const PixelProbe told = probe(*d, pixel);
      ASSERT_EQ(told.fragments.size(), exact.size()) << scene;
      for (size_t i = 0; i < exact.size(); ++i) {
        EXPECT_EQ(told.fragments[i].depth_m, exact[i].depth) << scene;
        EXPECT_EQ(told.fragments[i].card, exact[i].id) << scene;
        EXPECT_EQ(told.fragments[i].light, exact[i].light) << scene;
        EXPECT_EQ(told.fragments[i].transmittance, exact[i].transmittance) << scene;
      }
    }
  }
}

TEST_F(PixelProbeTest, ExactWeightsAreTheProductInDouble) {
  for (const char* scene : {"three_cards", "far_layer", "street"}) {
    const auto d = drawn(library.scene(scene), kSize, "wboit");  // whatever method draws
    const PixelProbe told = probe(*d, {40, 30});
    ASSERT_GT(told.fragments.size(), 3u) << scene;
    glm::dvec3 through(1.0);
    for (const PixelFragment& f : told.fragments) {
      EXPECT_EQ(f.weight, glm::vec3(through)) << scene;
      through *= glm::dvec3(f.transmittance);
    }
    EXPECT_EQ(told.exact_transmittance(1e9), through) << scene;
  }
}

TEST_F(PixelProbeTest, ManyFragmentsAreAllTold) {
  std::vector<Pane> panes;
  for (int i = 0; i < 3000; ++i) panes.push_back(card(-0.001f * float(i), 0.01f));
  const auto d = drawn(room(panes), {8, 8}, "wboit");
  EXPECT_EQ(probe(*d, {4, 4}).fragments.size(), 3000u);
}

TEST_F(PixelProbeTest, PanesAreTold) {
  const auto d = drawn(library.scene("three_cards"), kSize, "wboit");
  const auto& panes = d->stage.scene().panes;
  const PixelProbe told = probe(*d, kMiddle);
  ASSERT_EQ(told.fragments.size(), panes.size());
  for (const PixelFragment& f : told.fragments) {
    ASSERT_TRUE(f.owner.pane);
    const Pane& pane = panes[*f.owner.pane];
    EXPECT_NEAR(f.depth_m, 8.0f - pane.position.z, 1e-5f);
    EXPECT_NEAR(f.alpha, pane.coverage, 1e-5f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f.color[c], pane.color[c], 1e-3f);  // a half float
  }
}

TEST_F(PixelProbeTest, PanesThatTintAreToldBehindTheCardsOfEffects) {
  Scene scene = library.scene("street");
  for (Pane& pane : scene.panes) pane.size_m = glm::vec2(60.0f);  // each covers the pixel
  scene.solids.clear();                                           // and nothing hides one
  const auto d = drawn(scene, kSize, "wboit");
  std::vector<uint32_t> told_panes;
  for (const PixelFragment& f : probe(*d, kMiddle).fragments) {
    if (!f.owner.pane) continue;
    told_panes.push_back(*f.owner.pane);
    const Pane& pane = scene.panes[*f.owner.pane];
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(f.transmittance[c], 1 - f.alpha * (1 - pane.transmission[c]), 1e-3f) << *f.owner.pane;
  }
  EXPECT_EQ(told_panes.size(), scene.panes.size());
}

TEST_F(PixelProbeTest, ParticlesAreWhereTheirBirthIndicesSay) {
  const auto d = drawn(library.scene("street"), kSize, "wboit");
  const Simulation& simulation = d->stage.simulation();
  const Instances& instances = simulation.instances();
  std::map<std::pair<std::string, std::string>, std::pair<const EmitterState*, size_t>> first;
  size_t next = 0;
  for (const EmitterState& emitter : instances.emitters) {  // as particles() lists them
    if (!emitter.wanted || emitter.is_analytic()) continue;
    first[{instances.calls[emitter.call].call.name, instances.described(emitter).name}] = {&emitter, next};
    next += emitter.living();
  }
  const auto particles = simulation.particles();
  const Scene& scene = d->stage.scene();
  const shared::ViewData view =
      make_view(scene, camera_at(scene.camera, scene.default_tick), kSize, scene.default_tick);
  size_t checked = 0;
  for (const glm::uvec2 pixel : {kMiddle, glm::uvec2(30, 28), glm::uvec2(60, 24), glm::uvec2(70, 30)})
    for (const PixelFragment& f : probe(*d, pixel).fragments) {
      const auto found = first.find({f.owner.instance, f.owner.emitter});
      if (f.owner.pane || found == first.end()) continue;
      const auto [emitter, place] = found->second;
      const shared::EmitterData& data = emitter->data;
      if (data.cards_each != 1 || data.camera_offset != 0.0f || data.displacement_m != 0.0f) continue;
      const auto& p = particles[place + f.owner.birth - emitter->schedule.first_alive(*emitter->wanted)];
      EXPECT_EQ(p.birth, f.owner.birth);
      EXPECT_NEAR(f.depth_m, glm::dot(p.position - view.camera, view.forward), 1e-3f) << to_text(f.owner);
      ++checked;
    }
  EXPECT_GT(checked, 10u);
}

TEST_F(PixelProbeTest, WithoutAnInstanceItsFragmentsAreGoneAndNoOthers) {
  const Scene scene = library.scene("street");
  const auto all = drawn(scene, kSize, "wboit");
  const PixelProbe told = probe(*all, kMiddle);
  for (const Instance& instance : scene.instances) {
    Scene without = scene;
    for (Instance& other : without.instances)
      if (other.name == instance.name) other.call_tick.reset();
    const auto rest = drawn(without, kSize, "wboit");
    std::vector<float> expected, depths;
    for (const PixelFragment& f : told.fragments)
      if (f.owner.instance != instance.name) expected.push_back(f.depth_m);
    for (const PixelFragment& f : probe(*rest, kMiddle).fragments) depths.push_back(f.depth_m);
    EXPECT_EQ(depths, expected) << instance.name;
  }
}

TEST_F(PixelProbeTest, OpaqueSurfaceAndSkyAreToldApart) {
  Scene scene = room({card(0, 0.5f), card(-4, 0.5f)});
  EXPECT_FALSE(probe(*drawn(scene, kSize, "wboit"), kMiddle).opaque_m);
  scene.solids = {{.kind = SolidKind::kBox, .position = {0, 0, -2.5f}, .size_m = {9, 9, 1}}};
  const PixelProbe told = probe(*drawn(scene, kSize, "wboit"), kMiddle);
  ASSERT_TRUE(told.opaque_m);
  EXPECT_NEAR(*told.opaque_m, 7.0f, 1e-4f);
  ASSERT_EQ(told.fragments.size(), 1u);  // the other card is behind it
}

TEST_F(PixelProbeTest, ExactMethodsWeighExactly) {
  for (const char* id : {"reference", "kbuffer", "peel", "sorted"}) {
    const std::map<std::string, std::string> deep{{"nodes", "16"}};
    const auto d = drawn(library.scene("three_cards"), kSize, id,
                         std::string_view(id) == "kbuffer" ? deep : std::map<std::string, std::string>{});
    const PixelProbe told = probe(*d, kMiddle);
    const MethodAtPixel method = ask(*d, told);
    ASSERT_EQ(method.weights.size(), told.fragments.size());
    for (size_t i = 0; i < told.fragments.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(method.weights[i][c], told.fragments[i].weight[c], 1e-5) << id << " fragment " << i;
  }
}

// A fragment does not shade itself: what a bare light is given at its depth is another thing.
TEST_F(PixelProbeTest, WeightsAreWhatFragmentsAreDrawnWith) {
  const std::map<std::string, std::string> by_volume{{"exact_layers", "0"}, {"normalise", "false"}};
  for (const auto& settings : {std::map<std::string, std::string>{}, by_volume}) {
    std::vector<Pane> panes;
    for (int i = 0; i < 5; ++i) panes.push_back(card(1.0f - 0.8f * float(i), 0.3f + 0.1f * float(i)));
    const auto dark = drawn(room(panes), kSize, "avboit", settings);
    for (const size_t lit : {0u, 2u, 4u}) {
      std::vector<Pane> shining = panes;
      shining[lit].color = glm::vec3(2.0f);
      const auto bright = drawn(room(shining), kSize, "avboit", settings);
      const size_t place = kMiddle.y * kSize.x + kMiddle.x;
      const glm::vec3 received = read_picture(device, bright->targets).linear.pixels[place] -
                                 read_picture(device, dark->targets).linear.pixels[place];
      const PixelProbe told = probe(*bright, kMiddle);
      const float share = received.r / (2.0f * told.fragments[lit].alpha);
      EXPECT_NEAR(ask(*bright, told).weights[lit].r, share, 0.006) << "card " << lit;
    }
  }
}

// Of weighted blends too: light by weight, summed over the fragments, and the background that they let pass.
TEST_F(PixelProbeTest, WeightsOfWeightedBlendsAddUpToThePixel) {
  std::vector<Pane> panes;
  for (int i = 0; i < 6; ++i) {
    Pane pane = card(1.2f - 0.7f * float(i), 0.15f + 0.13f * float(i));
    pane.color = {0.2f + 0.15f * float(i), 0.9f - 0.1f * float(i), i % 2 == 0 ? 0.05f : 1.4f};
    if (i % 3 == 1) pane.transmission = {0.7f, 0.1f, 0.4f};
    panes.push_back(pane);
  }
  using Settings = std::map<std::string, std::string>;
  const std::pair<const char*, Settings> variants[] = {{"wboit", {{"weight", "eq7"}}},
                                                       {"wboit", {{"weight", "eq9"}, {"depth_scale", "4"}}},
                                                       {"wboit", {{"weight", "eq10"}}},
                                                       {"wboit", {{"weight", "colour_aware"}}},
                                                       {"wboit", {{"weight", "learnopengl"}}},
                                                       {"coloured", {}},
                                                       {"phenomenological", {}},
                                                       {"phenomenological", {{"self_modulation", "false"}}}};
  for (const auto& [id, settings] : variants) {
    Settings exact = settings;
    exact["sums"] = "float";
    if (std::string_view(id) == "wboit") exact["revealage"] = "float";
    const auto d = drawn(room(panes), kSize, id, exact);
    const size_t place = kMiddle.y * kSize.x + kMiddle.x;
    const glm::vec3 pixel = read_picture(device, d->targets).linear.pixels[place];
    const glm::vec3 behind =
        read_picture(device, drawn(room({}), kSize, id, exact)->targets).linear.pixels[place];
    const PixelProbe told = probe(*d, kMiddle);
    const MethodAtPixel method = ask(*d, told);
    ASSERT_EQ(method.weights.size(), panes.size());
    glm::dvec3 sum(0), passed(1);
    double apart = 0;
    for (size_t i = 0; i < panes.size(); ++i) {
      const PixelFragment& f = told.fragments[i];
      sum += glm::dvec3(f.light) * glm::dvec3(method.weights[i]);
      passed *= std::string_view(id) == "wboit"
                    ? glm::dvec3(double(f.transmittance.r + f.transmittance.g + f.transmittance.b) / 3)
                    : glm::dvec3(f.transmittance);
      apart = std::max(apart, double(glm::length(method.weights[i] - f.weight)));
    }
    const glm::dvec3 expected = sum + glm::dvec3(behind) * passed;
    // The picture and, of the other two, the background's share are half floats: 2^-11 each, some of it
    // twice.
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(double(pixel[c]), expected[c], 2e-3 * expected[c])
          << id << " " << (settings.empty() ? "" : settings.begin()->second) << " channel " << c;
    EXPECT_GT(apart, 0.05) << "a guess is not the truth";
  }
}

TEST_F(PixelProbeTest, OneCardAloneIsSeenWhole) {
  for (const char* id : {"avboit", "vboit", "wavelets", "fourier"}) {
    const std::map<std::string, std::string> by_volume{{"exact_layers", "0"}};
    const bool volume = std::string_view(id).ends_with("boit");
    const auto d =
        drawn(room({card(0, 0.9f)}), kSize, id, volume ? by_volume : std::map<std::string, std::string>{});
    EXPECT_NEAR(ask(*d, probe(*d, kMiddle)).weights.at(0).r, 1.0f, 0.01f) << id;
  }
}

TEST_F(PixelProbeTest, SlicesCoverTheFragmentsInOrder) {
  for (const char* id : {"avboit", "vboit"}) {
    const auto d = drawn(library.scene("near_layers"), kSize, id);
    const PixelProbe told = probe(*d, kMiddle);
    const auto slices = ask(*d, told).marks.slices;
    ASSERT_GT(slices.size(), 8u) << id;
    for (size_t i = 0; i < slices.size(); ++i) {
      EXPECT_LT(slices[i].begin, slices[i].end) << id << " " << i;
      if (i > 0) {
        EXPECT_GE(slices[i].begin, slices[i - 1].end * 0.9999f) << id << " " << i;
      }
      if (i > 0 && std::string_view(id) == "vboit") {  // no space between them
        EXPECT_NEAR(slices[i].begin, slices[i - 1].end, 1e-3f * slices[i].begin);
      }
    }
    for (const PixelFragment& f : told.fragments)
      EXPECT_TRUE(std::ranges::any_of(slices,
                                      [&](const DepthMarks::Slice& s) {
                                        return f.depth_m >= s.begin * 0.9999f && f.depth_m <= s.end * 1.0001f;
                                      }))
          << id << " " << f.depth_m;
  }
}

TEST_F(PixelProbeTest, ZeroDepthLiesBehindWhatHidesTheRest) {
  const std::map<std::string, std::string> by_volume{{"exact_layers", "0"}};  // sharp cards are not in it
  const auto d = drawn(room({card(2, 0.3f), card(0, 0.99f), card(-1, 0.99f), card(-3, 0.5f)}), kSize,
                       "avboit", by_volume);
  const PixelProbe told = probe(*d, kMiddle);
  const auto zero = ask(*d, told).marks.zero_m;
  ASSERT_TRUE(zero);
  EXPECT_GT(*zero, 5.999f);  // the second of the cards that hide: behind the first there is more left
  EXPECT_LT(told.exact_transmittance(double(*zero) + 0.01).r, 1.0 / 1024);
  const auto clear = drawn(room({card(2, 0.3f), card(0, 0.9f)}), kSize, "avboit", by_volume);
  EXPECT_FALSE(ask(*clear, probe(*clear, kMiddle)).marks.zero_m);
}

TEST_F(PixelProbeTest, OverflowIsToldWhereItBegins) {
  const auto d = drawn(room({card(2, 0.3f), card(0, 0.999f), card(-0.0001f, 0.999f)}), kSize, "avboit",
                       {{"exact_layers", "0"}, {"splat", "packed8_overflow"}});
  const DepthMarks marks = ask(*d, probe(*d, kMiddle)).marks;
  ASSERT_TRUE(marks.overflow_m);
  EXPECT_GT(*marks.overflow_m, 3.1f);    // behind the card that fits
  EXPECT_LE(*marks.overflow_m, 5.001f);  // where the others lie
  const auto fits = drawn(room({card(2, 0.3f), card(0, 0.9f)}), kSize, "avboit", {{"exact_layers", "0"}});
  EXPECT_FALSE(ask(*fits, probe(*fits, kMiddle)).marks.overflow_m);
}

}  // namespace
}  // namespace plume
