// What is done while nobody looks comes out in steps that lose nothing.
#include "sandbox/window/input_queue.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

constexpr KeyPress kA{key('A')};

class InputQueueTest : public testing::Test {
 protected:
  void press(Button button) { queue_.push(ButtonChanged{.button = button, .down = true}, now_s); }
  void let_go(Button button) { queue_.push(ButtonChanged{.button = button, .down = false}, now_s); }
  void move(float x, float y) { queue_.push(PointerMoved{{x, y}}, now_s); }
  std::vector<WindowInput> steps() {
    std::vector<WindowInput> steps{queue_.take()};
    while (!queue_.empty()) steps.push_back(queue_.take());
    return steps;
  }

  InputQueue queue_;
  double now_s = 0;
};

TEST_F(InputQueueTest, AClickDuringASlowPictureIsSeenDownAndUpWhereItWas) {
  move(10, 20);
  press(Button::kLeft);
  let_go(Button::kLeft);
  move(300, 200);
  const auto seen = steps();
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_TRUE(seen[0].held[0]);
  EXPECT_EQ(seen[0].pointer, glm::vec2(10, 20));
  EXPECT_FALSE(seen[1].held[0]);
  EXPECT_EQ(seen[1].pointer, glm::vec2(10, 20));
  EXPECT_EQ(seen[1].clicks, (std::vector{WindowInput::Click{{10, 20}, false}}));
  EXPECT_EQ(seen[2].pointer, glm::vec2(300, 200));
}

TEST_F(InputQueueTest, TwoClicksAreTwo) {
  for (int i = 0; i < 2; ++i) press(Button::kLeft), let_go(Button::kLeft);
  std::string held;
  for (const WindowInput& step : steps()) held += step.held[0] ? '1' : '0';
  EXPECT_EQ(held, "1010");
}

TEST_F(InputQueueTest, ADoubleClickIsSoonOrInLooksThatFollowEachOther) {
  const auto click = [&](glm::vec2 at, double after_s, int looks) {
    now_s += after_s;
    for (int i = 0; i < looks; ++i) queue_.look();
    move(at.x, at.y);
    press(Button::kLeft), let_go(Button::kLeft);
    bool is_second = false;
    for (const WindowInput& step : steps())
      for (const WindowInput::Click& done : step.clicks) is_second = done.is_second;
    return is_second;
  };
  EXPECT_FALSE(click({10, 10}, 1, 5));
  EXPECT_TRUE(click({12, 10}, 0.5 * kDoubleClickSeconds, 9)) << "soon";
  EXPECT_FALSE(click({12, 10}, 0.1 * kDoubleClickSeconds, 1)) << "a third begins anew";
  EXPECT_TRUE(click({12, 10}, 7, 1)) << "after a slow picture";
  EXPECT_FALSE(click({12, 10}, 1, 5));
  EXPECT_FALSE(click({12, 10}, 2 * kDoubleClickSeconds, 2)) << "late";
  EXPECT_FALSE(click({12 + InputQueue::kSamePixels, 10}, 0.1 * kDoubleClickSeconds, 1)) << "elsewhere";
}

TEST_F(InputQueueTest, AKeyPressedAndLetGoIsSeenDown) {
  queue_.push(KeyChanged{.press = kA, .down = true}, now_s);
  queue_.push(TextTyped{'a'}, now_s);
  queue_.push(KeyChanged{.press = kA, .down = false}, now_s);
  const auto seen = steps();
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_EQ(seen[0].keys, (std::vector{kA}));
  EXPECT_EQ(seen[0].text, (std::vector{uint32_t('a')}));
  ASSERT_EQ(seen[0].key_changes.size(), 1u);
  EXPECT_TRUE(seen[0].key_changes[0].down);
  ASSERT_EQ(seen[1].key_changes.size(), 1u);
  EXPECT_FALSE(seen[1].key_changes[0].down);
  EXPECT_TRUE(seen[1].keys.empty());
}

TEST_F(InputQueueTest, RepeatsOfAHeldKeyTakeOneStep) {
  for (int i = 0; i < 5; ++i) queue_.push(KeyChanged{.press = kA, .down = true}, now_s);
  const auto seen = steps();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].keys.size(), 5u);
  EXPECT_TRUE(queue_.holds(key('A')));
}

TEST_F(InputQueueTest, ADragIsMeasuredFromWhereItsButtonWentDown) {
  move(5, 5);
  move(10, 10);
  press(Button::kRight);
  move(20, 14);
  move(30, 10);
  let_go(Button::kRight);
  move(90, 90);
  glm::vec2 dragged(0);
  for (const WindowInput& step : steps()) dragged += step.drag[size_t(Button::kRight)];
  EXPECT_EQ(dragged, glm::vec2(20, 0));
}

TEST_F(InputQueueTest, APressThatMovesIsNoClick) {
  press(Button::kLeft);
  move(InputQueue::kStillPixels + 1, 0);
  let_go(Button::kLeft);
  for (const WindowInput& step : steps()) EXPECT_TRUE(step.clicks.empty());
}

TEST_F(InputQueueTest, WithoutEventsThingsAreAsTheyWere) {
  move(1, 2);
  press(Button::kMiddle);
  steps();
  const WindowInput still = queue_.take();
  EXPECT_TRUE(still.held[size_t(Button::kMiddle)]);
  EXPECT_EQ(still.pointer, glm::vec2(1, 2));
  EXPECT_EQ(still.drag[size_t(Button::kMiddle)], glm::vec2(0));
  queue_.push(PointerLeft{}, now_s);
  EXPECT_FALSE(queue_.take().pointer);
}

}  // namespace
}  // namespace plume
