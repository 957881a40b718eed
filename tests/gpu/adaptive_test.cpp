// Adaptive transparency against the same algorithm in double precision, and what compression costs it.
#include "renderer/probe.h"
#include "tests/gpu/avboit_scene.h"
#include "tests/gpu/fragment_lists.h"

namespace plume {
namespace {

using Map = std::map<std::string, std::string>;

/// Visibility along one ray: the paper's algorithm, written down once more.
struct Visibility {
  struct Node {
    double depth;
    uint32_t card;
    glm::dvec3 through;
    bool operator<(const Node& other) const {
      return std::tie(depth, card) < std::tie(other.depth, other.card);
    }
  };
  size_t most;
  std::vector<Node> nodes;

  glm::dvec3 at(double depth, uint32_t card) const {
    const auto behind = std::ranges::lower_bound(nodes, Node{depth, card, {}}, std::less<>());
    return behind == nodes.begin() ? glm::dvec3(1.0) : std::prev(behind)->through;
  }
  glm::dvec3 total() const { return nodes.empty() ? glm::dvec3(1.0) : nodes.back().through; }
  void insert(double depth, uint32_t card, glm::dvec3 t) {
    const glm::dvec3 before = at(depth, card);
    auto place = std::ranges::lower_bound(nodes, Node{depth, card, {}}, std::less<>());
    place = nodes.insert(place, {depth, card, before * t});
    for (++place; place != nodes.end(); ++place) place->through *= t;
    if (nodes.size() <= most) return;
    size_t least = 1;
    const auto error = [&](size_t i) {
      const glm::dvec3 step = nodes[i - 1].through - nodes[i].through;
      return (nodes[i].depth - nodes[i - 1].depth) * (step.r + step.g + step.b);
    };
    for (size_t i = 2; i < most; ++i)
      if (error(i) < error(least)) least = i;
    nodes[least - 1].through = nodes[least].through;
    nodes.erase(nodes.begin() + ptrdiff_t(least));
  }
};

class AdaptiveTest : public AvboitTest {
 protected:
  AdaptiveTest() {
    size = {24, 16};
    scene.light.horizon = {0.3f, 0.5f, 0.7f};
  }
  Random random{1};

  struct Drawn {
    std::vector<glm::vec3> pixels;
    FragmentLists lists;
  };
  Drawn draw_adaptive(const Map& settings) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance("adaptive", settings);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method);
    return {read_picture(device, w->targets).linear.pixels, {device, method.resources}};
  }
  /// Cards that cross each other, so that every pixel has its own order.
  void add_stack(int count, double thinnest, double thickest) {
    clear_cards();
    for (int i = 0; i < count; ++i) {
      PlacedCard card{.z = random.f(2, 20),
                      .optical_depth = float(random.octaves(thinnest, thickest)),
                      .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)}};
      if (i % 3 == 0) card.transmission = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      if (i % 5 == 0) card.emission = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      if (i % 2 == 0) card.yaw = random.f(-0.5, 0.5), card.pitch = random.f(-0.5, 0.5);
      add(card);
    }
  }
  static double rms(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += double(glm::dot(a[i] - b[i], a[i] - b[i]));
    return std::sqrt(sum / double(3 * a.size()));
  }
};

TEST_F(AdaptiveTest, EqualsTheSameAlgorithmInDoublePrecision) {
  for (const bool each_channel : {true, false})
    for (const int nodes : {2, 4, 8, 16}) {
      if (!each_channel && nodes != 4) continue;
      add_stack(30, 0.02, 3);
      const Drawn drawn =
          draw_adaptive({{"nodes", std::to_string(nodes)}, {"rgb", each_channel ? "true" : "false"}});
      size_t wrong = 0;
      for (size_t pixel = 0; pixel < drawn.pixels.size(); ++pixel) {
        auto list = drawn.lists.of(pixel);
        ASSERT_GT(list.size(), 20u);
        std::ranges::sort(list, std::greater<>(), &shared::FragmentNode::id);
        Visibility visibility{.most = size_t(nodes), .nodes = {}};
        for (const auto& f : list) {
          const glm::dvec3 t(f.transmittance);
          visibility.insert(double(f.depth), f.id, each_channel ? t : glm::dvec3((t.r + t.g + t.b) / 3));
        }
        glm::dvec3 expected = glm::dvec3(scene.light.horizon) * visibility.total();
        for (const auto& f : list) expected += glm::dvec3(f.light) * visibility.at(double(f.depth), f.id);
        for (int c = 0; c < 3; ++c)
          wrong += std::abs(expected[c] - double(drawn.pixels[pixel][c])) > 1e-3 * (1 + expected[c]);
      }
      // Where two removals cost the same to single precision, it may choose the other.
      EXPECT_LE(wrong, 6u) << nodes << " nodes, rgb " << each_channel;
    }
}

TEST_F(AdaptiveTest, IsExactWithANodeForEachFragment) {
  add_stack(16, 0.05, 6);
  const auto exact = draw_cards("reference").linear.pixels, drawn = draw_adaptive({{"nodes", "16"}}).pixels;
  for (size_t i = 0; i < exact.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(exact[i][c], drawn[i][c], 1e-3f) << "pixel " << i;
}

TEST_F(AdaptiveTest, CardsOfOneDepthHideEachOther) {
  for (int i = 0; i < 4; ++i) add({.z = 7, .optical_depth = 1, .color = {float(i) / 4, 1 - float(i) / 4, 0}});
  const auto exact = draw_cards("reference").linear.pixels, drawn = draw_adaptive({}).pixels;
  for (size_t i = 0; i < exact.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(exact[i][c], drawn[i][c], 1e-3f) << "pixel " << i;
}

TEST_F(AdaptiveTest, OpaqueFragmentsLeaveNothingToDivideBy) {
  for (int i = 0; i < 12; ++i)
    add({.z = 4 + float(i * 7 % 12),
         .optical_depth = shared::kOpaqueDepth,
         .color = glm::vec3(float(i) / 12)});
  const auto exact = draw_cards("reference").linear.pixels;
  const auto drawn = draw_adaptive({{"nodes", "16"}}).pixels;
  for (size_t i = 0; i < exact.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(exact[i][c], drawn[i][c], 1e-3f) << "pixel " << i;
  for (const glm::vec3& pixel : draw_adaptive({{"nodes", "2"}}).pixels)
    for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(pixel[c]));
}

TEST_F(AdaptiveTest, MoreNodesBringItNearer) {
  std::map<int, double> error;
  for (int round = 0; round < 4; ++round) {
    add_stack(40, 0.02, 1);
    const auto exact = draw_cards("reference").linear.pixels;
    for (const int nodes : {2, 4, 8, 16})
      error[nodes] += rms(exact, draw_adaptive({{"nodes", std::to_string(nodes)}}).pixels) / 4;
  }
  for (const int nodes : {2, 4, 8}) EXPECT_LT(error[2 * nodes], 0.75 * error[nodes]) << nodes;
  EXPECT_GT(error[2], 0.05);
  EXPECT_LT(error[16], 0.05);
  for (const auto& [nodes, rmse] : error)
    RecordProperty("rmse_of_" + std::to_string(nodes) + "_nodes", std::to_string(rmse));
}

TEST_F(AdaptiveTest, TheBackgroundIsSeenExactlyWhateverIsRemoved) {
  glm::dvec3 through(1.0);
  for (int i = 0; i < 30; ++i) {
    PlacedCard card{.z = random.f(2, 20), .optical_depth = random.f(0.01, 0.2)};
    if (i % 2 == 0) card.transmission = {0.9f, 0.5f, 0.1f};
    add(card);
    through *= 1.0 - (1 - std::exp(-double(card.optical_depth))) * (1.0 - glm::dvec3(card.transmission));
  }
  for (const char* nodes : {"2", "8"})
    for (const glm::vec3& pixel : draw_adaptive({{"nodes", nodes}}).pixels)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(through[c] * double(scene.light.horizon[c]), double(pixel[c]), 1e-3);
}

TEST_F(AdaptiveTest, NeverOverestimatesVisibility) {
  for (const char* nodes : {"2", "4", "8"}) {
    add_stack(40, 0.02, 1);
    const std::unique_ptr<World> w = world();
    MethodInstance adaptive = instance("adaptive", {{"nodes", nodes}}), exact = instance("reference");
    std::vector<float> depths;
    for (int i = 0; i < 64; ++i) depths.push_back(1.5f + float(i) * 0.35f);
    const Probe probe(device, {11, 7}, depths);
    const auto told = [&](MethodInstance& method) {
      render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
      return probe.read_answer(device);
    };
    const auto approximate = told(adaptive), right = told(exact);
    double worst = 0;
    for (size_t i = 0; i < depths.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        EXPECT_LE(approximate[i][c], right[i][c] + 1e-5f) << depths[i];
        worst = std::max(worst, double(right[i][c] - approximate[i][c]));
      }
    EXPECT_GT(worst, 0.01) << "nothing was compressed";
  }
}

TEST_F(AdaptiveTest, WithTwoNodesANearOpaqueCardHidesItself) {
  // A faint card, a red one, a green one: of three steps the red one's goes, to the faint card in front of
  // it.
  add({.z = 3, .optical_depth = 0.1f});
  add({.z = 5, .optical_depth = 4, .color = {0.8f, 0, 0}});
  add({.z = 9, .optical_depth = 4, .color = {0, 0.8f, 0}});
  const glm::vec3 exact = draw_cards("reference").linear.pixels[0];
  EXPECT_GT(exact.r, 0.7f);
  EXPECT_LT(draw_adaptive({{"nodes", "2"}}).pixels[0].r, 0.02f);
  EXPECT_NEAR(exact.r, draw_adaptive({{"nodes", "4"}}).pixels[0].r, 1e-3f);
}

TEST_F(AdaptiveTest, NoBitDependsOnTheOrderOfDraws) {
  add_stack(30, 0.02, 3);
  for (int i = 0; i < 6; ++i) add({.z = 7, .optical_depth = 0.3f, .color = {0.1f * float(i), 0.5f, 0.2f}});
  const auto in_order = draw_adaptive({{"nodes", "4"}}).pixels;
  order.resize(36);
  std::iota(order.begin(), order.end(), 0u);
  for (int round = 0; round < 3; ++round) {
    random.shuffle(order);
    EXPECT_EQ(in_order, draw_adaptive({{"nodes", "4"}}).pixels);
  }
}

}  // namespace
}  // namespace plume
