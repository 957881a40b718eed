#include "sandbox/effects/span_list.h"

#include <algorithm>

namespace plume {

void SpanList::clear() {
  by_kernel_.clear();
  kernels_.clear();
}

void SpanList::add(uint32_t kernel, shared::Span span, uint32_t threads_a_birth) {
  if (span.count == 0) return;
  Spans& of_kernel = by_kernel_[kernel];
  span.offset = of_kernel.threads;
  of_kernel.threads += span.count * threads_a_birth;
  of_kernel.spans.push_back(span);
}

void SpanList::upload(gpu::Device& device, const char* label) {
  std::vector<shared::Span> all;
  std::vector<uint32_t> span_of_group;
  kernels_.clear();
  for (const auto& [id, of_kernel] : by_kernel_) {
    const auto& [spans, threads] = of_kernel;
    kernels_.push_back({.id = id, .threads = threads, .first_group = uint32_t(span_of_group.size())});
    size_t span = 0;
    for (uint64_t thread = 0; thread < threads; thread += shared::kSpanGroup) {
      while (span + 1 < spans.size() && spans[span + 1].offset <= thread) ++span;
      span_of_group.push_back(uint32_t(all.size() + span));
    }
    all.insert(all.end(), spans.begin(), spans.end());
    span_of_group.push_back(uint32_t(all.size() - 1));
  }
  if (all.empty()) return;
  plume::upload(device, spans_, label, all);
  plume::upload(device, span_of_group_, label, span_of_group);
}

void upload(gpu::Device& device, gpu::Buffer& buffer, const char* label, std::span<const std::byte> data) {
  const uint64_t bytes = std::max<uint64_t>(data.size(), 16);
  if (buffer.bytes() < bytes)
    buffer = gpu::Buffer(
        device, {.owner = "simulation", .label = label, .bytes = bytes + bytes / 2, .host_visible = true});
  std::ranges::copy(data, buffer.mapped<std::byte>().begin());
}

}  // namespace plume
