// The Vulkan instance, the chosen device and its one queue. Everything Plume needs of a device is asked for
// here by name.
#ifndef PLUME_GPU_DEVICE_H
#define PLUME_GPU_DEVICE_H

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/gpu/memory.h"
#include "renderer/gpu/vulkan.h"

namespace plume::gpu {

struct DeviceOptions {
  std::string select;     ///< part of a device's name, or its index in list_devices(); "" = best
  bool validate = false;  ///< Khronos validation; messages are collected
  bool synchronization_validation = false;       ///< with `validate`: hazards too
  std::vector<const char*> instance_extensions;  ///< a window's needs
  std::vector<const char*> device_extensions;
  uint64_t memory_limit_bytes = 0;  ///< refuse to allocate beyond; 0 = the device's own limit
  /// For tests: "device_lost@PASS", "device_lost@N" (the Nth submission, from 1), "out_of_memory@PASS",
  /// "no_room@N" (the Nth allocation), "crash@PASS", "missing@NAME" (of device_needs()).
  std::string fault;
};

struct DeviceInfo {
  std::string name, driver, api;
  bool is_cpu;
};

class Device {
 public:
  /// Throws NoUsableDevice with the devices seen, or with the names of all missing features and limits.
  explicit Device(const DeviceOptions& options);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const vk::raii::Instance& instance() const { return instance_; }
  const vk::raii::PhysicalDevice& physical() const { return physical_; }
  const vk::raii::Device& vk() const { return device_; }
  const vk::raii::Queue& queue() const { return queue_; }
  uint32_t queue_family() const { return queue_family_; }
  const DeviceInfo& info() const { return info_; }
  const vk::PhysicalDeviceLimits& limits() const { return limits_; }
  const DeviceOptions& options() const { return options_; }
  Memory& memory() { return memory_; }

  /// Records, submits and waits. For set-up and read-back, not for frames.
  void immediate(const std::function<void(const vk::raii::CommandBuffer&)>& record);
  /// Submits and waits; turns loss of the device and lack of memory into DeviceFailure.
  void submit_and_wait(const vk::raii::CommandBuffer& commands);
  vk::raii::CommandBuffer new_commands();

  /// Names an object for validation messages and debuggers.
  template <class Handle>
  void label(const Handle& handle, std::string_view text) const {
    const auto raw = *handle;
    label_object(decltype(raw)::objectType, uint64_t(static_cast<typename decltype(raw)::CType>(raw)), text);
  }

  /// The last pass that began on the device, as far as the host knows; failures name it.
  const std::string& last_pass() const { return last_pass_; }
  void note_pass(std::string name) { last_pass_ = std::move(name); }

  /// Every warning and error the validation layers gave so far; empty without `validate`.
  std::vector<std::string> validation_messages() const;
  bool has_debug_labels() const { return has_debug_utils_; }
  /// shaderInt64 and shaderBufferInt64Atomics.
  bool has_int64_atomics() const { return has_int64_atomics_; }
  /// shaderBufferFloat32AtomicAdd.
  bool has_float_atomics() const { return has_float_atomics_; }
  /// fragmentShaderPixelInterlock.
  bool has_fragment_interlock() const { return has_fragment_interlock_; }

 private:
  void create_instance();
  void choose_physical();
  void create_device();
  void label_object(vk::ObjectType type, uint64_t handle, std::string_view text) const;

  struct MessageLog {
    std::mutex mutex;
    std::vector<std::string> messages;
  };

  DeviceOptions options_;
  std::unique_ptr<MessageLog> log_ = std::make_unique<MessageLog>();  // address handed to the driver
  vk::raii::Context context_;
  vk::raii::Instance instance_{nullptr};
  vk::raii::DebugUtilsMessengerEXT messenger_{nullptr};
  vk::raii::PhysicalDevice physical_{nullptr};
  vk::raii::Device device_{nullptr};
  vk::raii::Queue queue_{nullptr};
  vk::raii::CommandPool pool_{nullptr};
  Memory memory_;
  uint32_t queue_family_ = 0;
  DeviceInfo info_;
  std::string last_pass_ = "none";
  uint64_t submissions_ = 0;
  vk::PhysicalDeviceLimits limits_;
  bool has_debug_utils_ = false;
  bool has_int64_atomics_ = false, has_float_atomics_ = false, has_fragment_interlock_ = false;
};

/// A feature, an extension or a limit, by its Vulkan name.
struct DeviceNeed {
  const char* name;
  bool required;  ///< or there is no device; the others cost only what is built on them
};
/// All that is asked of a device.
std::vector<DeviceNeed> device_needs();

/// The devices of this machine in the order of their indices; empty when there is no Vulkan driver.
std::vector<DeviceInfo> list_devices();

}  // namespace plume::gpu
#endif
