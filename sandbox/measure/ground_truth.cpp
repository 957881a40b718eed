#include "sandbox/measure/ground_truth.h"

#include "renderer/methods/methods.h"

namespace plume {

const DrawnPicture& GroundTruth::of(const Subject& s) {
  if (exact_) return *exact_;
  if (!reference_)
    reference_ = MethodInstance{.method = make_method("reference"), .owner = "ground truth", .resources = {}};
  render_frame(s.device, s.pipelines, s.targets, s.prelude, s.transparents, *reference_);
  ++drawings_;
  return exact_.emplace(read_picture(s.device, s.targets));
}

void GroundTruth::release() {
  exact_.reset();
  reference_.reset();
}

}  // namespace plume
