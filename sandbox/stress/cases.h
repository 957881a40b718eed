// The hard cases, by what is hard about them. Sizes of pictures are no multiples of a cell of 8 pixels.
#ifndef PLUME_STRESS_CASES_H
#define PLUME_STRESS_CASES_H

#include "sandbox/stress/stress.h"

namespace plume::stress {

std::vector<StressCase> coverage_cases();    ///< how much is covered, how often
std::vector<StressCase> depth_cases();       ///< where layers stand, and how close
std::vector<StressCase> light_cases();       ///< emission and coloured transmission
std::vector<StressCase> picture_cases();     ///< sizes of cards and pictures, edges
std::vector<StressCase> invariance_cases();  ///< what must change nothing

/// A card over the whole picture that looks at it.
PlacedCard layer(double z, double coverage, glm::vec3 color, bool sharp);
/// The scene with sharp cards, and with the same as smoke.
std::vector<StressPicture> sharp_and_smooth(const std::string& name,
                                            const std::function<CardScene(bool sharp)>& scene);

}  // namespace plume::stress
#endif
