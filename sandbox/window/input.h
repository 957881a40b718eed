// What the user does in the window.
#ifndef PLUME_WINDOW_INPUT_H
#define PLUME_WINDOW_INPUT_H

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace plume {

/// Letters and digits are their own; GLFW's numbers (glfw_window.cpp checks them).
enum class Key : int {
  kSpace = 32,
  kEscape = 256,
  kTab = 258,
  kDelete = 261,
  kRight = 262,
  kLeft = 263,
  kDown = 264,
  kUp = 265,
  kHome = 268,
  kEnd = 269,
  kF1 = 290,
  kF2 = 291,
  kF5 = 294,
  kF11 = 300,
  kF12 = 301,
  kLeftShift = 340,
  kLeftControl = 341,
  kLeftAlt = 342,
  kRightShift = 344,
  kRightControl = 345,
  kRightAlt = 346,
};
constexpr Key key(char letter) {
  return Key(letter);
}

struct KeyPress {
  Key key;
  bool shift = false, control = false;
  bool operator==(const KeyPress&) const = default;
};

enum class Button { kLeft, kRight, kMiddle };
constexpr size_t kButtons = 3;

/// Between the two of a double click, at most.
constexpr double kDoubleClickSeconds = 0.3;

// One thing that the user did, as the desktop tells it. Places are in screen coordinates.
struct PointerMoved {
  glm::vec2 to;
};
struct PointerLeft {};  // the window
struct ButtonChanged {
  Button button;
  bool down;
};
struct WheelTurned {
  glm::vec2 steps;  // to the right, up
};
struct KeyChanged {
  KeyPress press;
  bool down;  // again while it is held: repeated
};
struct TextTyped {
  uint32_t character;
};
using WindowEvent =
    std::variant<PointerMoved, PointerLeft, ButtonChanged, WheelTurned, KeyChanged, TextTyped>;

/// What was done between two looks at it: see input_queue.h.
struct WindowInput {
  std::vector<KeyPress> keys;  ///< pressed, or repeated while held
  /// The left button was pressed and let go without moving between.
  struct Click {
    glm::vec2 at;    ///< in screen coordinates
    bool is_second;  ///< of a double click; the first was told before
    bool operator==(const Click&) const = default;
  };
  std::vector<Click> clicks;
  bool wants_to_close = false;             ///< by what the desktop has for it
  std::array<glm::vec2, kButtons> drag{};  ///< movement with each Button held, in screen coordinates
  glm::vec2 wheel{0};                      ///< steps; right and up are positive
  std::vector<KeyChanged> key_changes;
  std::vector<uint32_t> text;
  // As it is in the end.
  std::optional<glm::vec2> pointer;   ///< nothing: outside of the window
  std::array<bool, kButtons> held{};  ///< by Button
};

}  // namespace plume
#endif
