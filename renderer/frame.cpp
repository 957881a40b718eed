#include "renderer/frame.h"

#include "renderer/post.h"

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

/// What this picture wants now, whether the method writes it or not.
Outputs wanted_now(const Targets& targets, const Transparents& transparents) {
  Outputs wanted = targets.post.wanted();
  wanted.distortion &= transparents.number(Source::kHaze) > 0;
  return wanted;
}

Needs all_needs(const Method& method, glm::uvec2 size, const Transparents& transparents,
                const Outputs& written) {
  Needs needs = method.needs(size, transparents), more = method.output_needs(size, transparents, written);
  std::ranges::move(more.images, std::back_inserter(needs.images));
  std::ranges::move(more.buffers, std::back_inserter(needs.buffers));
  return needs;
}

void show(gpu::Frame& frame, const Targets& targets, const gpu::Buffer& view) {
  frame.pass("display", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("post/display.comp"),
                  {{"View", &view}, {"result", &targets.result}, {"display", &targets.display}}, targets.size,
                  {gpu::groups(targets.size.x, 8), gpu::groups(targets.size.y, 8), 1});
  });
}

}  // namespace

Targets::Targets(gpu::Device& device, glm::uvec2 picture_size, const Post& wanted_post)
    : size(picture_size),
      post(wanted_post),
      opaque_color(picture_image(device, size, "opaque_color", kHdrFormat, kHdrUsage)),
      opaque_depth(
          picture_image(device, size, "opaque_depth", vk::Format::eD32Sfloat,
                        vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled)),
      result(picture_image(device, size, "result", kHdrFormat, kHdrUsage)),
      display(picture_image(device, size, "display", vk::Format::eR8G8B8A8Unorm,
                            vk::ImageUsageFlagBits::eStorage)) {
  const Outputs wanted = post.wanted();
  if (wanted.distortion) distortion = picture_image(device, size, "distortion", kOutputFormat, kHdrUsage);
  if (wanted.surface) surface = picture_image(device, size, "surface", kOutputFormat, kHdrUsage);
  if (post.distortion || post.lens) composed = picture_image(device, size, "composed", kHdrFormat, kHdrUsage);
  if (post.lens) {
    constexpr auto kComputed = vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eStorage;
    circles = picture_image(device, size, "circles", vk::Format::eR32Sfloat, kComputed);
    circle_tiles =
        picture_image(device, circle_tile_count(size), "circle_tiles", vk::Format::eR32Sfloat, kComputed);
  }
}

FrameReport render_frame(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                         const Prelude& prelude, const Transparents& transparents, MethodInstance& instance,
                         const Probe* probe, const Glance* glance) {
  FrameReport report;
  const Outputs wanted = wanted_now(targets, transparents), writes = instance.method->outputs();
  const Outputs written{.distortion = wanted.distortion && writes.distortion,
                        .surface = wanted.surface && writes.surface};
  if (wanted.distortion && !written.distortion) report.left_out.push_back("distortion");
  if (wanted.surface && !written.surface) report.left_out.push_back("surface");
  const PostChain chain(targets, written);
  for (;; ++report.redraws) {
    Method& method = *instance.method;
    const Needs needs = all_needs(method, targets.size, transparents, written);
    instance.resources.fit(device, instance.owner, needs, targets.size);

    gpu::Frame frame(device, pipelines);
    const Picture picture{.frame = frame,
                          .resources = instance.resources,
                          .transparents = transparents,
                          .opaque_color = targets.opaque_color,
                          .opaque_depth = targets.opaque_depth,
                          .result = chain.method_target(),
                          .distortion = written.distortion ? &targets.distortion : nullptr,
                          .surface = written.surface ? &targets.surface : nullptr,
                          .size = targets.size};
    prelude.geometry(frame, targets);
    const size_t own_first = frame.pass_count();
    clear_declared_buffers(frame, needs, instance.resources);
    const gpu::Image& visible = method.prepare(picture);
    const size_t opaque_first = frame.pass_count();
    prelude.opaque(frame, targets, visible);
    const size_t opaque_end = frame.pass_count();
    method.record(picture);
    const size_t own_end = frame.pass_count();
    if (probe) method.probe(picture, *probe);
    if (glance) record_glance(picture, method, *glance);
    chain.record(frame, *transparents.view);
    show(frame, targets, *transparents.view);
    report.passes = frame.finish();
    report.transparency_ms = 0.0;
    for (size_t i = own_first; i < own_end; ++i)
      if (i < opaque_first || i >= opaque_end) report.transparency_ms += report.passes[i].ms;
    if (!method.must_redraw(device, instance.resources)) return report;
  }
}

}  // namespace plume
