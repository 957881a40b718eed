// What the driver made of shaders, kept from one run to the next. Vulkan lets a driver trust what follows the
// head of such data, so ours has a head of its own, and what is cut short, damaged or another driver's never
// reaches the driver:
//   "PLUMEPC1", vendor, device and driver version, pipelineCacheUUID, length, FNV-1a 64 of what follows
// It says where bytes come from, not that they are harmless: nobody else should be able to write the file.
#ifndef PLUME_GPU_PIPELINE_CACHE_H
#define PLUME_GPU_PIPELINE_CACHE_H

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/gpu/device.h"

namespace plume::gpu {

class PipelineCache {
 public:
  /// From bytes() of an earlier run; empty: a new one. Starts anew, and says why, where they are no good.
  PipelineCache(Device& device, std::span<const uint8_t> kept);

  const vk::raii::PipelineCache& vk() const { return cache_; }
  /// Why the kept bytes were not used; empty when they were, or there were none.
  const std::string& refused() const { return refused_; }
  std::vector<uint8_t> bytes() const;

  /// Of a file for this device and driver: the same in every run, another for others.
  static std::string file_name(const Device& device);

 private:
  Device& device_;
  std::string refused_;
  vk::raii::PipelineCache cache_{nullptr};
};

}  // namespace plume::gpu
#endif
