// Undo and redo of a text: every state whole, which is simple and exact. Steps that belong to one gesture (a
// slider that is dragged) are one step.
#ifndef PLUME_PRESETS_TEXT_HISTORY_H
#define PLUME_PRESETS_TEXT_HISTORY_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plume {

class TextHistory {
 public:
  /// Beyond so many bytes the oldest steps are forgotten, though never the last.
  explicit TextHistory(std::string text, size_t most_bytes = size_t{64} << 20);

  const std::string& text() const { return states_[now_].text; }

  /// A step to `text`, called `name` ("Set radius_m"). What was undone is forgotten. Where `gesture` is not
  /// empty and the same as of the step before, the two are one, until end_gesture(). No step where nothing
  /// changes.
  void step(std::string text, std::string name, std::string_view gesture = "");
  void end_gesture() { open_gesture_.clear(); }

  /// What undo() or redo() would do, for people; "" when there is nothing to do.
  std::string_view undo_name() const { return now_ > 0 ? std::string_view(states_[now_].name) : ""; }
  std::string_view redo_name() const {
    return now_ + 1 < states_.size() ? std::string_view(states_[now_ + 1].name) : "";
  }
  /// Which of all steps of all histories that is, counted from 1 as they are made; 0 when there is nothing to
  /// do: the order in which several texts were worked on.
  uint64_t undo_order() const { return now_ > 0 ? states_[now_].order : 0; }
  uint64_t redo_order() const { return now_ + 1 < states_.size() ? states_[now_ + 1].order : 0; }
  /// Whether there was something to do.
  bool undo();
  bool redo();

 private:
  struct State {
    std::string text, name;  // the name of the step that led there
    uint64_t order = 0;      // of that step
  };
  std::vector<State> states_;
  size_t now_ = 0, most_bytes_;
  std::string open_gesture_;
};

}  // namespace plume
#endif
