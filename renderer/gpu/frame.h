// GPU work as a list of named, timed passes. frame.pass("splat", ...) is the one way to record: it opens a
// debug label, a pair of timestamps and the barriers that separate it from its neighbours.
#ifndef PLUME_GPU_FRAME_H
#define PLUME_GPU_FRAME_H

#include <array>
#include <functional>
#include <optional>
#include <variant>

#include "renderer/gpu/pipelines.h"
#include "renderer/gpu/resources.h"

namespace plume::gpu {

/// What a shader's named descriptor is bound to: an image is sampled or storage as the shader declares it.
struct Binding {
  std::string_view name;
  std::variant<const Buffer*, const Image*> resource;
};
using Bindings = std::vector<Binding>;

struct Attachment {
  const Image* image;
  Blend blend = Blend::kReplace;
  std::optional<std::array<float, 4>> clear;  ///< nothing: keeps what is there
};

struct Area {
  uint32_t width, height;
};

struct Draw {
  std::string vertex, fragment;  ///< fragment "": depth only
  std::vector<Attachment> targets;
  const Image* depth = nullptr;
  DepthUse depth_use = DepthUse::kNone;
  bool clear_depth = false;         ///< to "infinitely far", 0
  Area area{0, 0};                  ///< of viewport and scissor
  std::optional<glm::uvec2> pixel;  ///< of the area: nothing else is drawn
  Constants constants;
  Bindings bindings;
  uint32_t vertices = 3, instances = 1;
  bool strip = false;                ///< triangle strips, one an instance; otherwise lists
  const Buffer* indirect = nullptr;  ///< vk::DrawIndirectCommand, instead of `vertices` and `instances`
  uint32_t indirect_index = 0;       ///< of the command in the buffer
  bool count_fragments = false;      ///< those that pass the depth test, into PassTime::fragments
};

/// A vk::DispatchIndirectCommand in a buffer.
struct IndirectGroups {
  const Buffer* buffer;
  uint64_t offset;  ///< bytes
};

class Pass {
 public:
  template <class Push>
  void dispatch(const Pipeline& pipeline, const Bindings& bindings, const Push& push,
                std::array<uint32_t, 3> groups) {
    static_assert(sizeof(Push) <= 128 && sizeof(Push) % 4 == 0);
    dispatch_raw(pipeline, bindings, std::as_bytes(std::span(&push, 1)), groups);
  }
  /// As many groups as the device has written there.
  template <class Push>
  void dispatch(const Pipeline& pipeline, const Bindings& bindings, const Push& push,
                const IndirectGroups& groups) {
    static_assert(sizeof(Push) <= 128 && sizeof(Push) % 4 == 0);
    dispatch_raw(pipeline, bindings, std::as_bytes(std::span(&push, 1)), groups);
  }
  template <class Push>
  void draw(const Draw& draw, const Push& push) {
    static_assert(sizeof(Push) <= 128 && sizeof(Push) % 4 == 0);
    draw_raw(draw, std::as_bytes(std::span(&push, 1)));
  }
  void fill(const Buffer& buffer, uint32_t word);
  void clear(const Image& image, const std::array<float, 4>& color);
  /// Images of one size and format.
  void copy(const Image& from, const Image& to);
  /// Writes a few structs into the buffer, from element `first` on; a barrier() must follow before they are
  /// read.
  template <class Data>
  void update(const Buffer& buffer, std::span<const Data> data, uint64_t first = 0) {
    update_raw(buffer, std::as_bytes(data), first * sizeof(Data));
  }
  template <class Data>
  void update(const Buffer& buffer, const Data& data) {
    update(buffer, std::span<const Data>(&data, 1));
  }
  /// Between two steps of one pass where the second reads what the first wrote.
  void barrier();
  const vk::raii::CommandBuffer& commands() const { return commands_; }
  Pipelines& pipelines() { return pipelines_; }

 private:
  friend class Frame;
  Pass(const vk::raii::CommandBuffer& commands, Pipelines& pipelines, vk::QueryPool counters,
       uint32_t& counters_used)
      : commands_(commands), pipelines_(pipelines), counters_(counters), counters_used_(counters_used) {}
  void dispatch_raw(const Pipeline&, const Bindings&, std::span<const std::byte> push,
                    std::array<uint32_t, 3>);
  void dispatch_raw(const Pipeline&, const Bindings&, std::span<const std::byte> push, const IndirectGroups&);
  void draw_raw(const Draw&, std::span<const std::byte> push);
  void update_raw(const Buffer& buffer, std::span<const std::byte> data, uint64_t offset);
  void bind(const Pipeline&, const Bindings&, std::span<const std::byte> push);

  const vk::raii::CommandBuffer& commands_;
  Pipelines& pipelines_;
  vk::QueryPool counters_;  ///< occlusion queries
  uint32_t& counters_used_;
};

struct PassTime {
  std::string name;
  double ms;
  std::optional<uint64_t> fragments;  ///< that passed the depth test, in the draws that count them
};

class Frame {
 public:
  Frame(Device& device, Pipelines& pipelines);

  void pass(std::string_view name, const std::function<void(Pass&)>& record);
  /// Submits, waits, and gives the passes' times in the order of recording. Throws DeviceFailure naming the
  /// last pass that began when the device is lost or out of memory.
  std::vector<PassTime> finish();

  Device& device() { return device_; }
  Pipelines& pipelines() { return pipelines_; }
  size_t pass_count() const { return passes_.size(); }

 private:
  void full_barrier();
  void cut();
  void submit();
  const vk::raii::CommandBuffer& commands() const { return parts_.back().commands; }

  struct Part {
    vk::raii::CommandBuffer commands;
    std::string last_pass;  // the name that is told when it has run
  };

  Device& device_;
  Pipelines& pipelines_;
  const Pipelines::Use use_;
  std::vector<Part> parts_;  // one, unless somebody listens to pipelines being made
  vk::raii::QueryPool stamps_;
  vk::raii::QueryPool counters_;
  uint32_t counters_used_ = 0;
  Buffer breadcrumb_;  ///< host-visible: 1 + index of the last pass that began on the device
  struct Recorded {
    std::string name;
    uint32_t first_counter, end_counter;
  };
  std::vector<Recorded> passes_;
};

/// Work groups that cover `items` with groups of `size`.
constexpr uint32_t groups(uint64_t items, uint32_t size) {
  return uint32_t((items + size - 1) / size);
}

}  // namespace plume::gpu
#endif
