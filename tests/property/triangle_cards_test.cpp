// Half a card is a triangle to every method: it covers what its three corners span, and two halves are the
// whole.
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

// A few half floats are summed and divided, which carry 11 bits each.
constexpr float kRounding = 4.0f / 2048;

class TriangleCards : public AvboitTest, public testing::WithParamInterface<std::string> {
 protected:
  void SetUp() override {
    size = {70, 42};
    scene.light.horizon = {0.2f, 0.3f, 0.5f};
  }
  /// No diagonal of it meets the centre of a pixel.
  static PlacedCard pane(uint32_t layer, bool faces = false) {
    return {.z = 4.0f,
            .optical_depth = 0.6f,
            .color = {0.8f, 0.4f, 0.1f},
            .half_size = {1.1f, 0.7f},
            .at = {0.13f, -0.07f},
            .yaw = faces ? 0.0f : 0.5f,
            .pitch = faces ? 0.0f : -0.3f,
            .layer = layer};
  }
  static shared::Card half(shared::Card card, bool other) {
    card.layers |= shared::kCardTriangle;
    if (other) card.axis_u = -card.axis_u, card.axis_v = -card.axis_v;
    return card;
  }
  DrawnPicture draw_these(std::vector<shared::Card> cards) {
    scalar = std::move(cards);
    return draw_cards(GetParam());
  }
  void expect_covers_its_corners(const shared::Card& card) {
    const Image drawn = draw_these({card}).linear;
    const auto on_screen = [&](glm::vec2 uv) {
      const shared::ViewData eye = view();
      const glm::dvec3 p = card.center + card.axis_u * uv.x + card.axis_v * uv.y;
      return (glm::dvec2(p.x, -p.y) / (-p.z * glm::dvec2(eye.tan_half_fov)) + 1.0) * 0.5 * glm::dvec2(size);
    };
    const std::array corners{on_screen({-1, -1}), on_screen({1, -1}), on_screen({-1, 1})};
    const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {  // pixels from the line
      const glm::dvec2 along = glm::normalize(b - a), arm = p - a;
      return along.x * arm.y - along.y * arm.x;
    };
    const double turn = side(corners[0], corners[1], corners[2]) > 0 ? 1 : -1;
    const float share = 1 - std::exp(-card.optical_depth);
    const glm::vec3 covered = glm::mix(scene.light.horizon, glm::vec3(0.8f, 0.4f, 0.1f), share);
    size_t inside = 0, outside = 0;
    for (size_t i = 0; i < drawn.pixels.size(); ++i) {
      const glm::dvec2 center(double(i % size.x) + 0.5, double(i / size.x) + 0.5);
      double depth = 1e9;  // pixels inside the nearest edge
      for (size_t e = 0; e < 3; ++e)
        depth = std::min(depth, turn * side(corners[e], corners[(e + 1) % 3], center));
      if (std::abs(depth) < 0.05) continue;  // on an edge
      const glm::vec3 expected = depth > 0 ? covered : scene.light.horizon;
      ++(depth > 0 ? inside : outside);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(expected[c], drawn.pixels[i][c],
                    kRounding + float(make_method(GetParam())->traits().rounding))
            << "pixel " << center.x << ", " << center.y << " is " << depth << " inside";
    }
    EXPECT_GT(inside, 100u);
    EXPECT_GT(outside, 1000u);
  }
};

INSTANTIATE_TEST_SUITE_P(All, TriangleCards, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

TEST_P(TriangleCards, TwoHalvesAreTheWhole) {
  // Hard edges, and soft ones that AVBOIT gives to its volume.
  for (const uint32_t layer : {shared::kSolidLayer, shared::kSoftLayer}) {
    const shared::Card whole = make_card(pane(layer));
    const Image expected = draw_these({whole}).linear;
    const Image drawn = draw_these({half(whole, false), half(whole, true)}).linear;
    for (size_t i = 0; i < expected.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(expected.pixels[i][c], drawn.pixels[i][c],
                    kRounding + float(make_method(GetParam())->traits().rounding))
            << "layer " << layer << " pixel " << i % size.x << ", " << i / size.x;
  }
}

TEST_P(TriangleCards, AHalfCoversWhatItsCornersSpanAndNothingElse) {
  for (const bool faces : {false, true})
    expect_covers_its_corners(half(make_card(pane(shared::kSolidLayer, faces)), false));
}

}  // namespace
}  // namespace plume
