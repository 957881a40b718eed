// What something was drawn and measured with.
#ifndef PLUME_RUNS_ENVIRONMENT_H
#define PLUME_RUNS_ENVIRONMENT_H

#include <nlohmann/json.hpp>

#include "renderer/gpu/device.h"

namespace plume {

/// Device, driver, build, commit and processor.
nlohmann::json environment_of(const gpu::Device& device);

}  // namespace plume
#endif
