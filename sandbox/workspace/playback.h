// Which tick is shown, and when the next one is due. Every tick is shown and none is skipped: the chosen
// speed at most, and a device that is slower than that plays slower, not coarser.
#ifndef PLUME_WORKSPACE_PLAYBACK_H
#define PLUME_WORKSPACE_PLAYBACK_H

#include <algorithm>
#include <cstdint>

namespace plume {

class Playback {
 public:
  Playback(uint32_t tick, uint32_t last_tick, bool playing)
      : tick_(std::min(tick, last_tick)), last_tick_(last_tick), playing_(playing) {}

  uint32_t tick() const { return tick_; }
  uint32_t last_tick() const { return last_tick_; }
  bool playing() const { return playing_; }
  double speed = 1.0;  ///< times real time
  bool loops = true;   ///< goes on from the first tick after the last; otherwise it stops there

  /// From the first tick again when it had stopped at the last.
  void toggle() {
    playing_ = !playing_;
    if (playing_ && !loops && tick_ == last_tick_) tick_ = 0;
  }
  /// Goes on playing from there.
  void go_to(uint32_t tick) { tick_ = std::min(tick, last_tick_); }
  /// Of a scene that became longer or shorter.
  void set_last_tick(uint32_t last_tick) {
    last_tick_ = last_tick;
    tick_ = std::min(tick_, last_tick);
  }
  /// Stops, so that the tick can be looked at. Stays at the ends.
  void step_back() {
    playing_ = false;
    if (tick_ > 0) --tick_;
  }
  void step_forward() {
    playing_ = false;
    tick_ = std::min(tick_ + 1, last_tick_);
  }

  /// One tick on when it is due; true when the tick has changed.
  bool advance(double now_s) {
    if (!playing_ || now_s < next_s_) return false;
    if (!loops && tick_ == last_tick_) return playing_ = false;
    next_s_ = std::max(next_s_ + kTickSeconds / speed, now_s);  // time that was lost is not caught up
    tick_ = tick_ < last_tick_ ? tick_ + 1 : 0;
    return true;
  }
  /// How long advance() has nothing to do; only while playing.
  double seconds_to_next(double now_s) const { return std::max(next_s_ - now_s, 0.0); }

 private:
  static constexpr double kTickSeconds = 1.0 / 60.0;

  uint32_t tick_, last_tick_;
  bool playing_;
  double next_s_ = 0;
};

}  // namespace plume
#endif
