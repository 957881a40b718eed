// Which share of the window's resolution the picture is drawn at, so that a chosen rate is held while things
// move; what stands still is drawn at all of it. Cost goes with the number of pixels; a step down is taken at
// once, a step up only when it would still hold, so that it does not swing.
#ifndef PLUME_WORKSPACE_RESOLUTION_CONTROL_H
#define PLUME_WORKSPACE_RESOLUTION_CONTROL_H

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace plume {

class ResolutionControl {
 public:
  /// Of the window's width and height.
  static constexpr std::array kScales{1.0, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125};

  bool adapts = true;
  double frames_per_second = 10;  ///< that it holds

  double scale() const { return kScales[adapts && rests_ ? 0 : step_]; }
  /// While things move, and where it stays when it does not adapt.
  void set_step(size_t step) { step_ = step; }
  size_t step() const { return step_; }

  /// After a picture at the present scale that took so long, while things move. Returns whether the scale
  /// changed.
  bool learn(double frame_ms) {
    if (!adapts) return false;
    const double most = 1000.0 / frames_per_second;
    const size_t before = step_;
    if (frame_ms > kSlack * most) {
      // As many steps as the excess asks for, had all of the cost to do with pixels.
      while (step_ + 1 < kScales.size() && frame_ms * area(step_) / area(before) > most) ++step_;
      quick_ = 0;
    } else if (step_ > 0 && frame_ms * area(step_ - 1) / area(step_) < most) {
      if (++quick_ >= kQuickFrames) --step_, quick_ = 0;
    } else {
      quick_ = 0;
    }
    return step_ != before;
  }

  /// Nothing has moved for a while: until move(), pictures are whole. Returns whether that changes the scale.
  bool rest() {
    if (!adapts || rests_) return false;
    rests_ = true;
    return step_ > 0;
  }
  void move() { rests_ = false; }

  glm::uvec2 picture_size(glm::uvec2 window) const {
    return glm::max(glm::uvec2(glm::dvec2(window) * scale()), glm::uvec2(1));
  }

 private:
  static constexpr double kSlack = 1.1;
  static constexpr int kQuickFrames = 8;  // one lucky frame is no reason
  static double area(size_t step) { return kScales[step] * kScales[step]; }

  size_t step_ = 0;
  bool rests_ = false;
  int quick_ = 0;
};

}  // namespace plume
#endif
