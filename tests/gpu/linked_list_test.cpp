// Linked lists in a pool of fixed size: exact while there is room, counted and averaged beyond. The picture
// is small enough for the device to draw it card by card, so that it is known who comes last.
#include "tests/gpu/avboit_scene.h"
#include "tests/gpu/fragment_lists.h"

namespace plume {
namespace {

class LinkedListTest : public AvboitTest {
 protected:
  LinkedListTest() {
    size = {24, 16};
    scene.light.horizon = {0.25f, 0.5f, 0.75f};
  }
  Random random{1};

  struct Drawn {
    std::vector<glm::vec3> pixels;
    nlohmann::json statistics;
    FragmentLists lists;
  };
  Drawn draw_lists(int fragments) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance("linked_list", {{"fragments", std::to_string(fragments)}});
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method);
    return {read_picture(device, w->targets).linear.pixels,
            method.method->statistics(device, method.resources),
            {device, method.resources}};
  }
  PlacedCard random_card() {
    return {.z = random.f(2, 20),
            .optical_depth = random.f(0.05, 1.5),
            .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
            .transmission = random.one_in(2) ? glm::vec3(0.9f, 0.5f, 0.2f) : glm::vec3(0.0f)};
  }
};

TEST_F(LinkedListTest, HasTheReferencesBitsWhileThePoolHasRoom) {
  for (int i = 0; i < 30; ++i) {
    PlacedCard card = random_card();
    card.yaw = random.f(-0.5, 0.5);
    card.half_size = {random.f(0.5, 9), random.f(0.5, 9)};
    if (i % 4 == 0) card.emission = {2, 1, 0.5f};
    add(card);
  }
  const auto exact = draw_cards("reference").linear.pixels;
  const Drawn drawn = draw_lists(30);
  EXPECT_EQ(exact, drawn.pixels);
  EXPECT_EQ(0, drawn.statistics["fragments_in_tail"]);
  EXPECT_EQ(drawn.lists.count, drawn.statistics["fragments"]);
}

TEST_F(LinkedListTest, LosesNoFragmentUncounted) {
  for (int i = 0; i < 12; ++i) add(random_card());
  const Drawn drawn = draw_lists(5);
  const uint32_t pixels = size.x * size.y;
  EXPECT_EQ(12 * pixels, drawn.statistics["fragments"]);
  EXPECT_EQ(7 * pixels, drawn.statistics["fragments_in_tail"]);
  size_t kept = 0;
  for (size_t pixel = 0; pixel < pixels; ++pixel) kept += drawn.lists.of(pixel).size();
  EXPECT_EQ(5 * pixels, kept);
}

TEST_F(LinkedListTest, TheTailIsTheAverageOfWhatFoundNoPlaceBehindWhatDid) {
  const int kKept = 4;
  glm::dvec3 light(0), through(1), tail(0), weight(0), tail_through(1);
  for (int i = 0; i < 12; ++i) {
    PlacedCard card = random_card();
    if (i < kKept) card.z = 1 + float(i) * 0.1f, card.optical_depth *= 0.1f;
    add({.z = card.z, .optical_depth = card.optical_depth, .color = card.color});
    const double covers = 1 - std::exp(-double(card.optical_depth));
    const glm::dvec3 color = glm::dvec3(card.color) * covers;
    (i < kKept ? light : tail) += color * (i < kKept ? through : glm::dvec3(1));
    (i < kKept ? through : tail_through) *= 1 - covers;
    if (i >= kKept) weight += covers;
  }
  const glm::dvec3 behind =
      tail / weight * (1.0 - tail_through) + glm::dvec3(scene.light.horizon) * tail_through;
  for (const glm::vec3& pixel : draw_lists(kKept).pixels)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR((light + through * behind)[c], double(pixel[c]), 3e-3) << "channel " << c;
}

TEST_F(LinkedListTest, WhatIsInTheTailLetsThroughExactlyWhatItDoes) {
  for (int i = 0; i < 20; ++i) {
    PlacedCard card = random_card();
    card.color = glm::vec3(0.0f);
    card.optical_depth *= 0.1f;
    add(card);
  }
  const auto exact = draw_cards("reference").linear.pixels, drawn = draw_lists(2).pixels;
  for (size_t i = 0; i < exact.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(exact[i][c], drawn[i][c], 2e-3f) << "pixel " << i;
}

TEST_F(LinkedListTest, UncoveredEmissionInTheTailIsAdded) {
  add({.z = 3, .optical_depth = 0.7f, .color = glm::vec3(0.1f)});
  for (int i = 0; i < 5; ++i) add({.z = 5 + float(i), .optical_depth = 0, .emission = {0.5f, 0.25f, 0.125f}});
  const auto exact = draw_cards("reference").linear.pixels, drawn = draw_lists(1).pixels;
  for (size_t i = 0; i < exact.size(); ++i)
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(exact[i][c], drawn[i][c], 2e-3f) << "pixel " << i;
}

TEST_F(LinkedListTest, ANearCardThatComesAfterThePoolIsFullFallsBehind) {
  add({.z = 9, .optical_depth = 3, .color = {0, 0.8f, 0}});
  add({.z = 3, .optical_depth = 3, .color = {0.8f, 0, 0}});
  const glm::vec3 exact = draw_cards("reference").linear.pixels[0], full = draw_lists(1).pixels[0],
                  room = draw_lists(2).pixels[0];
  EXPECT_GT(exact.r, 0.7f);
  EXPECT_LT(full.r, 0.05f);
  EXPECT_GT(full.g, 0.7f);
  EXPECT_EQ(exact, room);
}

TEST_F(LinkedListTest, TheOrderOfTheTailChangesNothingBeyondRounding) {
  for (int i = 0; i < 14; ++i) {
    PlacedCard card = random_card();
    add({.z = card.z, .optical_depth = card.optical_depth, .color = card.color});
  }
  order.resize(14);
  std::iota(order.begin(), order.end(), 0u);
  const auto in_order = draw_lists(4).pixels;
  for (int round = 0; round < 3; ++round) {
    std::vector<uint32_t> last(order.begin() + 4, order.end());
    random.shuffle(last);
    std::ranges::copy(last, order.begin() + 4);
    const auto drawn = draw_lists(4).pixels;
    for (size_t i = 0; i < drawn.size(); ++i)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(in_order[i][c], drawn[i][c], 2e-3f) << "pixel " << i;
  }
}

}  // namespace
}  // namespace plume
