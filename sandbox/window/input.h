// What the user does in the window. Kept in full from one question to the next: a slow frame loses no key and
// no movement.
#ifndef PLUME_WINDOW_INPUT_H
#define PLUME_WINDOW_INPUT_H

#include <array>
#include <glm/glm.hpp>
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

/// Between the two of a double click, at most.
constexpr double kDoubleClickSeconds = 0.3;

struct WindowInput {
  std::vector<KeyPress> keys;  ///< pressed, or repeated while held
  /// The left button was pressed and let go without moving between.
  struct Click {
    glm::vec2 at;    ///< in screen coordinates
    bool is_second;  ///< of a double click; the first was told before
  };
  std::vector<Click> clicks;
  bool wants_to_close = false;      ///< by what the desktop has for it
  std::array<glm::vec2, 3> drag{};  ///< movement with each Button held, in screen coordinates
  float wheel = 0.0f;               ///< steps; up is positive
};

}  // namespace plume
#endif
