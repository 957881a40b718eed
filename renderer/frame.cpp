#include "renderer/frame.h"

namespace plume {
namespace {

constexpr auto kHdrUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled |
                           vk::ImageUsageFlagBits::eStorage;

gpu::Image picture_image(gpu::Device& device, glm::uvec2 size, const char* label, vk::Format format,
                         vk::ImageUsageFlags usage) {
  return gpu::Image(
      device,
      {.owner = "frame", .label = label, .format = format, .extent = {size.x, size.y, 1}, .usage = usage});
}

void clear_declared_buffers(gpu::Frame& frame, const Needs& needs, const Resources& resources) {
  const auto wants_clear = [](const BufferNeed& need) { return need.clear.has_value(); };
  if (std::none_of(needs.buffers.begin(), needs.buffers.end(), wants_clear)) return;
  frame.pass("clear", [&](gpu::Pass& pass) {
    for (const BufferNeed& need : needs.buffers)
      if (need.clear) pass.fill(resources.buffer(need.name), *need.clear);
  });
}

void show(gpu::Frame& frame, const Targets& targets, const gpu::Buffer& view) {
  frame.pass("display", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("post/display.comp"),
                  {{"View", &view}, {"result", &targets.result}, {"display", &targets.display}}, targets.size,
                  {gpu::groups(targets.size.x, 8), gpu::groups(targets.size.y, 8), 1});
  });
}

}  // namespace

Targets::Targets(gpu::Device& device, glm::uvec2 picture_size)
    : size(picture_size),
      opaque_color(picture_image(device, size, "opaque_color", kHdrFormat, kHdrUsage)),
      opaque_depth(
          picture_image(device, size, "opaque_depth", vk::Format::eD32Sfloat,
                        vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled)),
      result(picture_image(device, size, "result", kHdrFormat, kHdrUsage)),
      display(picture_image(device, size, "display", vk::Format::eR8G8B8A8Unorm,
                            vk::ImageUsageFlagBits::eStorage)) {}

FrameReport render_frame(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                         const Prelude& prelude, const Transparents& transparents, MethodInstance& instance) {
  FrameReport report;
  for (;; ++report.redraws) {
    Method& method = *instance.method;
    const Needs needs = method.needs(targets.size, transparents);
    instance.resources.fit(device, instance.owner, needs, targets.size);

    gpu::Frame frame(device, pipelines);
    const Picture picture{.frame = frame,
                          .resources = instance.resources,
                          .transparents = transparents,
                          .opaque_color = targets.opaque_color,
                          .opaque_depth = targets.opaque_depth,
                          .result = targets.result,
                          .size = targets.size};
    prelude.geometry(frame, targets);
    clear_declared_buffers(frame, needs, instance.resources);
    prelude.opaque(frame, targets, method.prepare(picture));
    method.record(picture);
    show(frame, targets, *transparents.view);
    report.passes = frame.finish();
    if (!method.must_redraw(device, instance.resources)) return report;
  }
}

}  // namespace plume
