// Pipelines by description, made when first asked for and kept while there is room for them. Layouts come
// from the shaders themselves.
#ifndef PLUME_GPU_PIPELINES_H
#define PLUME_GPU_PIPELINES_H

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "renderer/gpu/device.h"
#include "renderer/gpu/pipeline_cache.h"
#include "renderer/gpu/reflection.h"
#include "renderer/gpu/shaders.h"

namespace plume::gpu {

/// Specialisation constants: constant_id = position.
using Constants = std::vector<uint32_t>;

struct Pipeline {
  std::string name;
  std::vector<ShaderBinding> bindings;
  vk::PipelineBindPoint bind_point;
  vk::raii::DescriptorSetLayout set_layout{nullptr};
  vk::raii::PipelineLayout layout{nullptr};
  vk::raii::Pipeline pipeline{nullptr};
};

/// How a fragment's output meets what the target holds.
enum class Blend { kReplace, kAdd, kMultiply, kAddMultiplyAlpha, kOverDual };

struct Target {
  vk::Format format;
  Blend blend = Blend::kReplace;
  bool operator<(const Target& other) const {
    return std::tie(format, blend) < std::tie(other.format, other.blend);
  }
};

enum class DepthUse {
  kNone,
  kTest,  ///< as near or nearer
  kTestAndWrite,
  kTestBehind,  ///< as far or farther
  kWrite        ///< whatever was there
};

struct GraphicsDesc {
  std::string vertex, fragment;  ///< shader names; fragment "": depth only. No vertex buffers: shaders pull
  std::vector<Target> targets;
  DepthUse depth = DepthUse::kNone;  ///< reversed: nearer is greater; D32
  bool strip = false;                ///< triangle strips, one an instance; otherwise lists
  uint32_t samples = 1;              ///< of all targets and the depth
  Constants constants;
};

/// What is being made ready, for whoever waits.
struct Preparing {
  std::string_view what;  ///< a shader, or the pass that runs it for the first time
  size_t done, total;     ///< passes that ran for the first time; 0 of 0 while pipelines are described
};

/// So many that all methods of a comparison find theirs again in every round. llvmpipe (LLVM 15, Mesa 22.3.6)
/// keeps 2.8 MiB of compiled code for each.
constexpr size_t kMostPipelines = 512;

class Pipelines {
 public:
  /// `kept`: what cache() had in an earlier run, so that the driver need not work again. `most`: so many stay
  /// between frames, those that were used last.
  Pipelines(Device& device, const Shaders& shaders, std::span<const uint8_t> kept = {},
            size_t most = kMostPipelines);
  Pipelines(const Pipelines&) = delete;

  /// What is given back stays where it is while a Use lives. Every frame has one from before it is recorded
  /// until the device has run it.
  class Use {
   public:
    explicit Use(Pipelines& pipelines) : pipelines_(pipelines) { ++pipelines_.uses_; }
    ~Use() {
      if (--pipelines_.uses_ == 0) pipelines_.keep_only(pipelines_.most_);
    }
    Use(const Use&) = delete;

   private:
    Pipelines& pipelines_;
  };

  const Pipeline& compute(const std::string& shader, const Constants& constants = {});
  const Pipeline& graphics(const GraphicsDesc& desc);

  /// Makes every pipeline anew from the shaders as they are now. A failure throws ShaderError and keeps the
  /// old ones.
  void reload();
  /// Drops those that were asked for longest ago until `most` are left, while no Use lives.
  void keep_only(size_t most);
  size_t count() const { return pipelines_.size(); }
  /// So many were made since the beginning, reloads aside.
  uint64_t made() const { return made_; }
  /// Called before each pipeline is made, and after each pass that ran new ones: some drivers compile a
  /// shader when it first runs, so frames hand those passes over one by one while somebody listens. The
  /// listener may use the device, and must not draw frames of passes.
  using Listener = std::function<void(const Preparing&)>;
  void listen(Listener listener) { listener_ = std::move(listener); }
  const Listener& listener() const { return listener_; }
  const PipelineCache& cache() const { return cache_; }
  const vk::PhysicalDeviceLimits& limits() const { return device_.limits(); }
  /// Clamped to the edge; linear, except for formats that devices need not filter.
  vk::Sampler sampler_for(vk::Format format) const;

 private:
  Pipeline start(const std::string& name, std::span<const std::vector<uint32_t>> modules,
                 vk::PipelineBindPoint bind_point);
  Pipeline make_compute(const std::string& shader, const Constants& constants);
  Pipeline make_graphics(const GraphicsDesc& desc);

  struct Entry {
    std::function<Pipeline()> make;
    std::unique_ptr<Pipeline> pipeline;
    uint64_t last_asked;  ///< of all questions, the number of the last one for it
  };
  const Pipeline& find_or_make(std::string key, const std::string& shader, std::function<Pipeline()> make);

  Device& device_;
  const Shaders& shaders_;
  PipelineCache cache_;
  vk::raii::Sampler linear_, nearest_;
  std::map<std::string, Entry> pipelines_;
  const size_t most_;
  uint64_t asked_ = 0, made_ = 0;
  int uses_ = 0;
  Listener listener_;
};

}  // namespace plume::gpu
#endif
