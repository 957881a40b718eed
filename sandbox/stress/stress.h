// Hard cases: pictures on which methods break, how far each method is off on them, and what is known of why.
#ifndef PLUME_STRESS_STRESS_H
#define PLUME_STRESS_STRESS_H

#include <functional>
#include <string>
#include <vector>

#include "renderer/gpu/pipelines.h"
#include "sandbox/presets/library.h"
#include "sandbox/stress/card_stage.h"

namespace plume {

/// One picture of a case: cards, or a shipped scene at a tick.
struct StressPicture {
  std::string name;  ///< what is special about it: "alpha 1/255"
  glm::uvec2 size{66, 34};
  CardScene cards;
  std::string scene;  ///< id; empty: the cards
  uint32_t tick = 0;
  // Of a picture that is held against the case's first one:
  glm::ivec2 shift{0};  ///< pixels that it is moved by
  uint32_t scale = 1;   ///< it has so many times as many pixels, each way
};

struct StressCase {
  std::string id, title;  ///< "one_slice", "255 layers of one depth"
  std::string trouble;    ///< what goes wrong with it, and where it is from
  /// Held against the exact picture, or each picture against the method's own first one.
  enum class Against { kExact, kItself } against = Against::kExact;
  std::vector<StressPicture> pictures;
};

/// All of them, in the order of reports.
std::vector<StressCase> stress_cases();

/// How far a method is off, in linear light, relative to the brightest light of the exact picture where that
/// is above 1: the worst of the case's pictures.
struct StressFinding {
  double rmse = 0.0, max = 0.0;
  std::string picture;  ///< the one with the largest error
  glm::ivec2 pixel{0};  ///< there
  bool finite = true;   ///< nothing drawn is NaN or infinite
};

/// Draws a case by one method after the other.
class StressRun {
 public:
  StressRun(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library)
      : device_(device), pipelines_(pipelines), library_(library) {}
  /// Of each of `methods`, in their order; nothing where the device lacks what it needs. Throws what drawing
  /// throws.
  std::vector<std::optional<StressFinding>> run(const StressCase& hard_case,
                                                const std::vector<MethodRun>& methods);

 private:
  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  const PresetLibrary& library_;
};

}  // namespace plume
#endif
