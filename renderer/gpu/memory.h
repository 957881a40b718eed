// Device memory, counted per owner, so that "memory per method" is a fact and a limit can be tested.
#ifndef PLUME_GPU_MEMORY_H
#define PLUME_GPU_MEMORY_H

#include <cstdint>
#include <map>
#include <string>

#include "renderer/gpu/vulkan.h"

namespace plume::gpu {

class Memory;

/// Owns one allocation; gives its bytes back to the account when it ends.
class Allocation {
 public:
  Allocation() = default;
  Allocation(Allocation&& other) noexcept { *this = std::move(other); }
  Allocation& operator=(Allocation&& other) noexcept;
  ~Allocation() { release(); }

  const vk::raii::DeviceMemory& memory() const { return memory_; }
  uint64_t bytes() const { return bytes_; }

 private:
  friend class Memory;
  void release();

  Memory* account_ = nullptr;
  std::string owner_;
  uint64_t bytes_ = 0;
  vk::raii::DeviceMemory memory_{nullptr};
};

class Memory {
 public:
  /// `limit_bytes` 0: no limit beyond the device's.
  void init(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device, uint64_t limit_bytes);

  /// Throws DeviceFailure naming owner, label and size when the device or the limit has no room.
  Allocation allocate(const vk::MemoryRequirements& needs, bool host_visible, bool device_address,
                      std::string_view owner, std::string_view label);

  /// For tests: the nth allocation from now on finds no room; 0: none.
  void refuse(uint64_t nth) { refused_ = nth; }

  uint64_t total_bytes() const { return total_; }
  uint64_t owner_bytes(const std::string& owner) const;
  const std::map<std::string, uint64_t>& owners() const { return by_owner_; }

 private:
  friend class Allocation;
  uint32_t type_index(uint32_t allowed, bool host_visible) const;

  const vk::raii::Device* device_ = nullptr;
  vk::PhysicalDeviceMemoryProperties properties_;
  uint64_t limit_ = 0;
  uint64_t total_ = 0;
  uint64_t refused_ = 0;  // from the next on, counted down
  std::map<std::string, uint64_t> by_owner_;
};

}  // namespace plume::gpu
#endif
