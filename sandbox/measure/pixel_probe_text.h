// What is at a pixel, for other programs: JSON with everything, and two tables.
#ifndef PLUME_MEASURE_PIXEL_PROBE_TEXT_H
#define PLUME_MEASURE_PIXEL_PROBE_TEXT_H

#include "sandbox/measure/pixel_probe.h"

namespace plume {

nlohmann::json to_json(const PixelProbe& probe);
/// A line for each depth: what each method lets pass in front of it.
std::string curves_csv(const PixelProbe& probe);
/// A line for each fragment: whose it is, its exact weight, each method's weight and the difference.
std::string fragments_csv(const PixelProbe& probe);

}  // namespace plume
#endif
