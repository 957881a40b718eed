// The exact picture of what is shown. It costs many times what a method's own costs, so it is drawn once
// while nothing changes.
#ifndef PLUME_MEASURE_GROUND_TRUTH_H
#define PLUME_MEASURE_GROUND_TRUTH_H

#include "renderer/frame.h"
#include "sandbox/measure/picture.h"

namespace plume {

/// What is drawn: the same for a method and for the reference it is held against.
struct Subject {
  gpu::Device& device;
  gpu::Pipelines& pipelines;
  const Targets& targets;
  const Prelude& prelude;
  const Transparents& transparents;
};

class GroundTruth {
 public:
  /// Drawn by the reference, unless it is known: the targets hold it then. What drawing takes on the device
  /// is kept for the next picture.
  const DrawnPicture& of(const Subject& subject);
  bool is_known() const { return exact_.has_value(); }
  /// Another picture is shown.
  void forget() { exact_.reset(); }
  /// The same picture is shown again: gives back what drawing took on the device.
  void rest() { reference_.reset(); }
  /// Nobody asks any more: no memory is left, neither here nor on the device.
  void release();
  /// How often the reference was drawn.
  uint64_t drawings() const { return drawings_; }

 private:
  std::optional<MethodInstance> reference_;  // so that its lists have their length
  std::optional<DrawnPicture> exact_;
  uint64_t drawings_ = 0;
};

}  // namespace plume
#endif
