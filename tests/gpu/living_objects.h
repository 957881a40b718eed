// How many Vulkan objects of a device live: its functions that make and destroy them are replaced by ones
// that count. Objects from before are not counted, so those must outlive it; one at a time.
#ifndef PLUME_TESTS_LIVING_OBJECTS_H
#define PLUME_TESTS_LIVING_OBJECTS_H

#include <atomic>
#include <map>
#include <string>

#include "renderer/gpu/device.h"

namespace plume {

class LivingObjects {
  using Dispatcher = vk::raii::DeviceDispatcher;

 public:
  explicit LivingObjects(const gpu::Device& device)
      // What it points to is not const, and belongs to the device alone.
      : dispatcher_(const_cast<Dispatcher&>(*device.vk().getDispatcher())) {
    for (const Kind& kind : kinds()) kind.begin(dispatcher_);
  }
  ~LivingObjects() {
    for (const Kind& kind : kinds()) kind.end(dispatcher_);
  }
  LivingObjects(const LivingObjects&) = delete;
  LivingObjects& operator=(const LivingObjects&) = delete;

  /// By kind. Less than 0: more of those from before are gone than were made.
  static std::map<std::string, int64_t> counts() {
    std::map<std::string, int64_t> counts;
    for (const Kind& kind : kinds()) counts[kind.name] = kind.living();
    return counts;
  }

 private:
  /// One function: how often it was called and did not fail. Plume makes objects one by one.
  template <auto Function>
  struct Calls;
  template <class Result, class... Arguments, Result (VKAPI_PTR* Dispatcher::*Function)(Arguments...)>
  struct Calls<Function> {
    static inline Result(VKAPI_PTR* original)(Arguments...) = nullptr;
    static inline std::atomic<int64_t> count = 0;

    static VKAPI_ATTR Result VKAPI_CALL call(Arguments... arguments) {
      if constexpr (std::is_void_v<Result>) {
        ++count;
        original(arguments...);
      } else {
        const Result result = original(arguments...);
        count += result == VK_SUCCESS;
        return result;
      }
    }
    static void begin(Dispatcher& dispatcher) {
      count = 0;
      original = std::exchange(dispatcher.*Function, &call);
    }
    static void end(Dispatcher& dispatcher) { dispatcher.*Function = original; }
  };

  struct Kind {
    const char* name;
    void (*begin)(Dispatcher&);
    void (*end)(Dispatcher&);
    int64_t (*living)();
  };
  template <auto Destroy, auto... Make>
  static Kind kind(const char* name) {
    return {.name = name,
            .begin =
                [](Dispatcher& dispatcher) {
                  Calls<Destroy>::begin(dispatcher);
                  (Calls<Make>::begin(dispatcher), ...);
                },
            .end =
                [](Dispatcher& dispatcher) {
                  Calls<Destroy>::end(dispatcher);
                  (Calls<Make>::end(dispatcher), ...);
                },
            .living = [] { return (Calls<Make>::count + ...) - Calls<Destroy>::count; }};
  }
  static const std::vector<Kind>& kinds() {
    using D = Dispatcher;
    static const std::vector<Kind> kinds{
        kind<&D::vkFreeMemory, &D::vkAllocateMemory>("allocations"),
        kind<&D::vkDestroyBuffer, &D::vkCreateBuffer>("buffers"),
        kind<&D::vkDestroyImage, &D::vkCreateImage>("images"),
        kind<&D::vkDestroyImageView, &D::vkCreateImageView>("image views"),
        kind<&D::vkDestroySampler, &D::vkCreateSampler>("samplers"),
        kind<&D::vkDestroyShaderModule, &D::vkCreateShaderModule>("shader modules"),
        kind<&D::vkDestroyPipeline, &D::vkCreateComputePipelines, &D::vkCreateGraphicsPipelines>("pipelines"),
        kind<&D::vkDestroyPipelineLayout, &D::vkCreatePipelineLayout>("pipeline layouts"),
        kind<&D::vkDestroyDescriptorSetLayout, &D::vkCreateDescriptorSetLayout>("descriptor set layouts"),
        kind<&D::vkDestroyQueryPool, &D::vkCreateQueryPool>("query pools"),
        kind<&D::vkDestroyFence, &D::vkCreateFence>("fences"),
        kind<&D::vkFreeCommandBuffers, &D::vkAllocateCommandBuffers>("command buffers")};
    return kinds;
  }

  Dispatcher& dispatcher_;
};

}  // namespace plume
#endif
