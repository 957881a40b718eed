#include "renderer/gpu/frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "renderer/gpu/errors.h"

namespace plume::gpu {
namespace {

constexpr uint32_t kMaxPasses = 256, kMaxCounters = 64;

const vk::MemoryBarrier2 kFullBarrier{
    .srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
    .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
    .dstStageMask = vk::PipelineStageFlagBits2::eAllCommands,
    .dstAccessMask = vk::AccessFlagBits2::eMemoryRead | vk::AccessFlagBits2::eMemoryWrite};

/// What is not written is not stored either: storing counts as a write, beside shaders that read the image.
vk::RenderingAttachmentInfo attachment(const Image& image, const std::optional<vk::ClearValue>& clear,
                                       bool writes = true) {
  return {.imageView = image.view(),
          .imageLayout = vk::ImageLayout::eGeneral,
          .loadOp = clear ? vk::AttachmentLoadOp::eClear : vk::AttachmentLoadOp::eLoad,
          .storeOp = writes ? vk::AttachmentStoreOp::eStore : vk::AttachmentStoreOp::eNone,
          .clearValue = clear.value_or(vk::ClearValue{})};
}

}  // namespace

void Pass::bind(const Pipeline& pipeline, const Bindings& bindings, std::span<const std::byte> push) {
  commands_.bindPipeline(pipeline.bind_point, *pipeline.pipeline);
  std::vector<vk::WriteDescriptorSet> writes;
  std::vector<vk::DescriptorBufferInfo> buffers(pipeline.bindings.size());
  std::vector<vk::DescriptorImageInfo> images(pipeline.bindings.size());
  for (size_t i = 0; i < pipeline.bindings.size(); ++i) {
    const ShaderBinding& wanted = pipeline.bindings[i];
    const auto given = std::find_if(bindings.begin(), bindings.end(),
                                    [&](const Binding& b) { return b.name == wanted.name; });
    if (given == bindings.end())
      throw ShaderError(fmt::format("{} needs '{}', which is not bound", pipeline.name, wanted.name));
    vk::WriteDescriptorSet write{
        .dstBinding = wanted.binding, .descriptorCount = 1, .descriptorType = wanted.type};
    if (const auto* buffer = std::get_if<const Buffer*>(&given->resource)) {
      const uint64_t most = pipelines_.limits().maxStorageBufferRange;
      if ((*buffer)->bytes() > most)
        throw DeviceFailure(fmt::format("{} needs {} bytes of '{}' in one binding, the device allows {}",
                                        pipeline.name, (*buffer)->bytes(), wanted.name, most));
      buffers[i] = vk::DescriptorBufferInfo{.buffer = (*buffer)->vk(), .range = VK_WHOLE_SIZE};
      write.pBufferInfo = &buffers[i];
    } else {
      const Image& image = *std::get<const Image*>(given->resource);
      images[i] = vk::DescriptorImageInfo{.sampler = pipelines_.sampler_for(image.format()),
                                          .imageView = image.view(),
                                          .imageLayout = vk::ImageLayout::eGeneral};
      write.pImageInfo = &images[i];
    }
    writes.push_back(write);
  }
  if (!writes.empty()) commands_.pushDescriptorSetKHR(pipeline.bind_point, *pipeline.layout, 0, writes);
  commands_.pushConstants<std::byte>(*pipeline.layout, vk::ShaderStageFlagBits::eAll, 0,
                                     vk::ArrayProxy<const std::byte>(uint32_t(push.size()), push.data()));
}

void Pass::dispatch_raw(const Pipeline& pipeline, const Bindings& bindings, std::span<const std::byte> push,
                        std::array<uint32_t, 3> groups) {
  const auto& most = pipelines_.limits().maxComputeWorkGroupCount;
  for (size_t axis = 0; axis < 3; ++axis)
    if (groups[axis] > most[axis])
      throw DeviceFailure(fmt::format("{} needs {} work groups, the device runs {} at once", pipeline.name,
                                      groups[axis], most[axis]));
  bind(pipeline, bindings, push);
  commands_.dispatch(groups[0], groups[1], groups[2]);
}

void Pass::dispatch_raw(const Pipeline& pipeline, const Bindings& bindings, std::span<const std::byte> push,
                        const IndirectGroups& groups) {
  bind(pipeline, bindings, push);
  commands_.dispatchIndirect(groups.buffer->vk(), groups.offset);
}

void Pass::draw_raw(const Draw& draw, std::span<const std::byte> push) {
  GraphicsDesc desc{.vertex = draw.vertex,
                    .fragment = draw.fragment,
                    .targets = {},
                    .depth = draw.depth_use,
                    .strip = draw.strip,
                    .samples = !draw.targets.empty() ? draw.targets.front().image->samples()
                               : draw.depth          ? draw.depth->samples()
                                                     : 1,
                    .constants = draw.constants};
  std::vector<vk::RenderingAttachmentInfo> colors;
  for (const Attachment& target : draw.targets) {
    desc.targets.push_back({target.image->format(), target.blend});
    colors.push_back(attachment(
        *target.image,
        target.clear ? std::optional(vk::ClearValue{.color = {.float32 = *target.clear}}) : std::nullopt));
  }
  if (colors.empty()) colors.emplace_back();  // as its pipeline says it
  const Pipeline& pipeline = pipelines_.graphics(desc);
  vk::RenderingAttachmentInfo depth;
  if (draw.depth)
    depth = attachment(
        *draw.depth,
        draw.clear_depth ? std::optional(vk::ClearValue{.depthStencil = {.depth = 0.0f}}) : std::nullopt,
        draw.clear_depth || draw.depth_use == DepthUse::kTestAndWrite || draw.depth_use == DepthUse::kWrite);
  const vk::Rect2D area{.extent = {draw.area.width, draw.area.height}};
  commands_.beginRendering({.renderArea = area,
                            .layerCount = draw.targets.empty() ? 1u : draw.targets.front().image->layers(),
                            .colorAttachmentCount = uint32_t(colors.size()),
                            .pColorAttachments = colors.data(),
                            .pDepthAttachment = draw.depth ? &depth : nullptr});
  commands_.setViewport(
      0, vk::Viewport{.width = float(draw.area.width), .height = float(draw.area.height), .maxDepth = 1.0f});
  commands_.setScissor(
      0, draw.pixel ? vk::Rect2D{{int32_t(draw.pixel->x), int32_t(draw.pixel->y)}, {1, 1}} : area);
  bind(pipeline, draw.bindings, push);
  if (draw.count_fragments) {
    if (counters_used_ == kMaxCounters) throw std::logic_error("a frame counts fragments in too many draws");
    commands_.beginQuery(counters_, counters_used_, vk::QueryControlFlagBits::ePrecise);
  }
  if (draw.indirect)
    commands_.drawIndirect(draw.indirect->vk(), draw.indirect_index * sizeof(vk::DrawIndirectCommand), 1,
                           sizeof(vk::DrawIndirectCommand));
  else if (draw.vertices > 0 && draw.instances > 0)
    commands_.draw(draw.vertices, draw.instances, 0, 0);
  if (draw.count_fragments) commands_.endQuery(counters_, counters_used_++);
  commands_.endRendering();
}

void Pass::fill(const Buffer& buffer, uint32_t word) {
  commands_.fillBuffer(buffer.vk(), 0, VK_WHOLE_SIZE, word);
}

void Pass::clear(const Image& image, const std::array<float, 4>& color) {
  commands_.clearColorImage(
      image.vk(), vk::ImageLayout::eGeneral, vk::ClearColorValue{.float32 = color},
      vk::ImageSubresourceRange{.aspectMask = image.aspect(), .levelCount = 1, .layerCount = image.layers()});
}

void Pass::update_raw(const Buffer& buffer, std::span<const std::byte> data, uint64_t offset) {
  constexpr size_t kMost = 65536;  // of vkCmdUpdateBuffer
  for (size_t at = 0; at < data.size(); at += kMost) {
    const auto part = data.subspan(at, std::min(kMost, data.size() - at));
    commands_.updateBuffer<std::byte>(buffer.vk(), offset + at,
                                      vk::ArrayProxy<const std::byte>(uint32_t(part.size()), part.data()));
  }
}

void Pass::copy(const Image& from, const Image& to) {
  const vk::ImageSubresourceLayers layers{.aspectMask = from.aspect(), .layerCount = 1};
  commands_.copyImage(
      from.vk(), vk::ImageLayout::eGeneral, to.vk(), vk::ImageLayout::eGeneral,
      vk::ImageCopy{.srcSubresource = layers, .dstSubresource = layers, .extent = from.extent()});
}

void Pass::barrier() {
  commands_.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &kFullBarrier});
}

Frame::Frame(Device& device, Pipelines& pipelines)
    : device_(device),
      pipelines_(pipelines),
      use_(pipelines),
      stamps_(device.vk().createQueryPool(
          {.queryType = vk::QueryType::eTimestamp, .queryCount = 2 * kMaxPasses})),
      counters_(
          device.vk().createQueryPool({.queryType = vk::QueryType::eOcclusion, .queryCount = kMaxCounters})),
      breadcrumb_(device, {.owner = "frame", .label = "breadcrumb", .bytes = 4, .host_visible = true}) {
  stamps_.reset(0, 2 * kMaxPasses);
  counters_.reset(0, kMaxCounters);
  breadcrumb_.mapped<uint32_t>()[0] = 0;
  cut();
}

/// What is recorded from here on is handed over by itself.
void Frame::cut() {
  parts_.push_back({device_.new_commands(), ""});
  commands().begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
}

void Frame::full_barrier() {
  commands().pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &kFullBarrier});
}

void Frame::pass(std::string_view name, const std::function<void(Pass&)>& record) {
  if (passes_.size() == kMaxPasses) throw std::logic_error("a frame has too many passes");
  const std::string label(name);
  const uint32_t index = uint32_t(passes_.size());
  passes_.push_back({label, counters_used_, counters_used_});
  const uint64_t made_before = pipelines_.made();
  if (device_.has_debug_labels()) commands().beginDebugUtilsLabelEXT({.pLabelName = label.c_str()});
  commands().fillBuffer(breadcrumb_.vk(), 0, 4, index + 1);
  // Lavapipe batches work: a stamp is only true behind a full barrier (Mesa 22.3: without, a 143 ms pass
  // reads 0.02 ms). It also puts the stamp itself into the batch of the last framebuffer, which a dispatch
  // overtakes: without the barrier behind the first stamp, a 48 ms dispatch that follows any drawing reads
  // 0.1 ms.
  full_barrier();
  commands().writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *stamps_, 2 * index);
  full_barrier();
  Pass pass(commands(), pipelines_, *counters_, counters_used_);
  record(pass);
  passes_.back().end_counter = counters_used_;
  full_barrier();
  commands().writeTimestamp2(vk::PipelineStageFlagBits2::eAllCommands, *stamps_, 2 * index + 1);
  if (device_.has_debug_labels()) commands().endDebugUtilsLabelEXT();
  if (!pipelines_.listener() || pipelines_.made() == made_before) return;
  commands().end();
  parts_.back().last_pass = label;
  cut();
}

void Frame::submit() {
  const size_t total = parts_.size() - 1;
  for (size_t i = 0; i < parts_.size(); ++i) {
    device_.submit_and_wait(parts_[i].commands);
    if (i < total) pipelines_.listener()({.what = parts_[i].last_pass, .done = i + 1, .total = total});
  }
}

std::vector<PassTime> Frame::finish() {
  make_visible_to_host(commands());
  commands().end();
  if (passes_.empty()) return {};
  try {
    const std::string& fault = device_.options().fault;
    for (const auto& [name, first, end] : passes_) {  // of tests, where a real driver would report it
      if (!fault.ends_with("@" + name)) continue;
      device_.note_pass(name);
      if (fault == "device_lost@" + name) throw DeviceFailure("the device was lost (injected)");
      if (fault == "out_of_memory@" + name) throw DeviceFailure("out of device memory (injected)");
      if (fault == "crash@" + name) std::abort();
    }
    submit();
  } catch (const DeviceFailure& failure) {
    if (const uint32_t begun = breadcrumb_.mapped<uint32_t>()[0]) device_.note_pass(passes_[begun - 1].name);
    throw DeviceFailure(fmt::format("{}; the last pass was '{}'", failure.what(), device_.last_pass()));
  }
  device_.note_pass(passes_.back().name);

  std::vector<PassTime> times;
  const double ms_per_tick = double(device_.limits().timestampPeriod) * 1e-6;
  const auto [result, stamps] = stamps_.getResults<uint64_t>(
      0, 2 * uint32_t(passes_.size()), 2 * passes_.size() * sizeof(uint64_t), sizeof(uint64_t),
      vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
  std::vector<uint64_t> counts;
  if (counters_used_ > 0)
    counts = counters_
                 .getResults<uint64_t>(0, counters_used_, counters_used_ * sizeof(uint64_t), sizeof(uint64_t),
                                       vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait)
                 .second;
  for (size_t i = 0; i < passes_.size(); ++i) {
    const auto& [name, first, end] = passes_[i];
    times.push_back({name, double(stamps[2 * i + 1] - stamps[2 * i]) * ms_per_tick, {}});
    if (end > first)
      times.back().fragments = std::accumulate(counts.begin() + first, counts.begin() + end, uint64_t(0));
  }
  return times;
}

}  // namespace plume::gpu
