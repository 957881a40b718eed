// What the user did while nobody looked, in its order. A slow picture may lie between two looks, and panels
// know only the state of a button, a key and the pointer at each look: a click, or a key pressed and let go,
// would be gone, and a press would be where the pointer went afterwards. So what was done is handed out in
// steps, each as long as one look can tell apart: no button and no key changes twice in a step, the pointer
// does not move after a button has changed, and keys and text keep their order.
#ifndef PLUME_WINDOW_INPUT_QUEUE_H
#define PLUME_WINDOW_INPUT_QUEUE_H

#include <deque>
#include <map>
#include <set>

#include "sandbox/window/input.h"

namespace plume {

class InputQueue {
 public:
  static constexpr float kStillPixels = 3;  ///< a hand that clicks trembles
  static constexpr float kSamePixels = 6;   ///< and clicks twice nearly at the same place

  /// What is pushed from now on happened after the last look at the desktop.
  void look() { ++look_; }
  /// `now_s`: when it was heard of, which may be long after it was done.
  void push(const WindowEvent& event, double now_s) { waiting_.push_back({event, now_s, look_}); }
  bool empty() const { return waiting_.empty(); }

  /// The next step; without events, how things are.
  WindowInput take() {
    WindowInput step;
    Step seen;
    while (!waiting_.empty() && fits(waiting_.front().event, seen)) {
      heard_ = waiting_.front();
      waiting_.pop_front();
      note(heard_.event, seen);
      std::visit([&](const auto& event) { apply(event, step); }, heard_.event);
    }
    step.held = held_;
    if (inside_) step.pointer = pointer_;
    return step;
  }

  // As the last step left it.
  glm::vec2 pointer() const { return pointer_; }
  /// Where the left button went down last.
  glm::vec2 pressed_at() const { return pressed_at_; }
  bool holds(Button button) const { return held_[size_t(button)]; }
  bool holds(Key key) const { return keys_.contains(key); }

 private:
  /// What a step holds so far.
  struct Step {
    std::array<bool, kButtons> buttons{};
    bool any_button = false, text = false;
    std::map<Key, bool> keys;  // whether it went down
  };
  static bool fits(const WindowEvent& event, Step& step) {
    if (std::holds_alternative<PointerMoved>(event) || std::holds_alternative<PointerLeft>(event))
      return !step.any_button;
    if (const auto* button = std::get_if<ButtonChanged>(&event)) return !step.buttons[size_t(button->button)];
    if (const auto* key = std::get_if<KeyChanged>(&event))
      return !step.text && step.keys.try_emplace(key->press.key, key->down).first->second == key->down;
    return true;
  }
  static void note(const WindowEvent& event, Step& step) {
    if (const auto* button = std::get_if<ButtonChanged>(&event))
      step.any_button = step.buttons[size_t(button->button)] = true;
    step.text |= std::holds_alternative<TextTyped>(event);
  }

  void apply(const PointerMoved& moved, WindowInput& step) {
    if (known_)
      for (size_t button = 0; button < kButtons; ++button)
        if (held_[button]) step.drag[button] += moved.to - pointer_;
    pointer_ = moved.to;
    inside_ = known_ = true;
  }
  void apply(const PointerLeft&, WindowInput&) { inside_ = false; }
  void apply(const ButtonChanged& changed, WindowInput& step) {
    held_[size_t(changed.button)] = changed.down;
    if (changed.button != Button::kLeft) return;
    if (changed.down)
      pressed_at_ = pointer_;
    else if (glm::length(pointer_ - pressed_at_) < kStillPixels)
      click(step);
  }
  /// Two of a double click are heard of soon after each other; or, after a slow picture, at once, or one each
  /// in two looks that follow each other.
  void click(WindowInput& step) {
    const bool soon = last_click_ && (heard_.at_s - last_click_->heard.at_s < kDoubleClickSeconds ||
                                      heard_.look - last_click_->heard.look <= 1);
    const bool is_second = soon && glm::length(pointer_ - last_click_->at) < kSamePixels;
    step.clicks.push_back({pointer_, is_second});
    if (is_second)
      last_click_.reset();  // a third begins anew
    else
      last_click_ = {heard_, pointer_};
  }
  void apply(const WheelTurned& turned, WindowInput& step) { step.wheel += turned.steps; }
  void apply(const KeyChanged& changed, WindowInput& step) {
    step.key_changes.push_back(changed);
    if (!changed.down) {
      keys_.erase(changed.press.key);
      return;
    }
    keys_.insert(changed.press.key);
    step.keys.push_back(changed.press);
  }
  void apply(const TextTyped& typed, WindowInput& step) { step.text.push_back(typed.character); }

  struct Heard {
    WindowEvent event;
    double at_s;
    uint64_t look;
  };
  struct LastClick {
    Heard heard;
    glm::vec2 at;
  };

  std::deque<Heard> waiting_;
  Heard heard_{};  // the last that was taken
  uint64_t look_ = 0;
  std::optional<LastClick> last_click_;
  glm::vec2 pointer_{0.0f}, pressed_at_{0.0f};  // the left button was
  bool inside_ = false, known_ = false;         // the pointer is
  std::array<bool, kButtons> held_{};
  std::set<Key> keys_;  // held
};

}  // namespace plume
#endif
