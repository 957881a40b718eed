// Births that kernels work on, as the device reads them: spans of one kernel stand together, and each kernel
// is one dispatch however many emitters it serves.
#ifndef PLUME_EFFECTS_SPAN_LIST_H
#define PLUME_EFFECTS_SPAN_LIST_H

#include <map>

#include "renderer/gpu/frame.h"
#include "shaders/shared/particle.h"

namespace plume {

class SpanList {
 public:
  /// As the kernels take it, its id apart.
  struct Kernel {
    uint32_t id;
    uint32_t threads, first_group;
  };

  void clear();
  /// Empty spans are left out. Spans keep the order in which they were added to a kernel; `offset` is set
  /// here.
  void add(uint32_t kernel, shared::Span span, uint32_t threads_a_birth = 1);
  /// Makes what was added readable for the device, which must be idle.
  void upload(gpu::Device& device, const char* label);

  bool empty() const { return by_kernel_.empty(); }
  const std::vector<Kernel>& kernels() const { return kernels_; }
  /// What the kernels read: shaders/effects/spans.glsl.
  gpu::Bindings bindings() const { return {{"Spans", &spans_}, {"SpanOfGroup", &span_of_group_}}; }

 private:
  struct Spans {
    std::vector<shared::Span> spans;
    uint32_t threads = 0;
  };
  std::map<uint32_t, Spans> by_kernel_;
  std::vector<Kernel> kernels_;
  gpu::Buffer spans_, span_of_group_;
};

/// Fills a host-visible buffer, made anew only when it has been outgrown.
void upload(gpu::Device& device, gpu::Buffer& buffer, const char* label, std::span<const std::byte> data);
template <class T>
void upload(gpu::Device& device, gpu::Buffer& buffer, const char* label, const std::vector<T>& data) {
  upload(device, buffer, label, std::as_bytes(std::span(data)));
}

}  // namespace plume
#endif
