#include "sandbox/presets/text_history.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace plume {
namespace {

uint64_t next_order() {
  static std::atomic<uint64_t> steps = 0;
  return ++steps;
}

}  // namespace

TextHistory::TextHistory(std::string text, size_t most_bytes) : most_bytes_(most_bytes) {
  states_.push_back({std::move(text), ""});
}

void TextHistory::step(std::string text, std::string name, std::string_view gesture) {
  if (text == states_[now_].text) return;
  const bool goes_on = !gesture.empty() && gesture == open_gesture_ && now_ > 0;
  states_.resize(now_ + 1);
  if (goes_on)
    states_[now_].text = std::move(text);
  else
    states_.push_back({std::move(text), std::move(name)}), ++now_;
  states_[now_].order = next_order();
  open_gesture_ = gesture;

  size_t bytes = 0, first = states_.size();
  while (first > 0 && (bytes += states_[first - 1].text.size()) <= most_bytes_) --first;
  first = std::min(first, now_ - 1);
  states_.erase(states_.begin(), states_.begin() + static_cast<std::ptrdiff_t>(first));
  now_ -= first;
}

bool TextHistory::undo() {
  end_gesture();
  if (now_ == 0) return false;
  --now_;
  return true;
}

bool TextHistory::redo() {
  end_gesture();
  if (now_ + 1 >= states_.size()) return false;
  ++now_;
  return true;
}

}  // namespace plume
