// What can go wrong on the way to the GPU, one type for each thing a caller does about it.
#ifndef PLUME_GPU_ERRORS_H
#define PLUME_GPU_ERRORS_H

#include <stdexcept>

namespace plume::gpu {

/// There is no device that can run Plume, or the chosen one misses what is named in the message. Exit code 3.
struct NoUsableDevice : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The device was lost or its memory ran out; the message names the last pass. Exit code 4.
struct DeviceFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A shader is missing or does not compile; the message holds the compiler's.
struct ShaderError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace plume::gpu
#endif
