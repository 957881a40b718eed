#include "sandbox/workspace/side_view.h"

#include <algorithm>

namespace plume {
namespace {

void show(gpu::Device& device, const Targets& targets, const DisplayImage& image) {
  std::vector<std::array<uint8_t, 4>> texels;
  texels.reserve(image.pixels.size());
  for (const auto& [r, g, b] : image.pixels) texels.push_back({r, g, b, 255});
  gpu::write_bytes(device, targets.display, std::as_bytes(std::span(texels)));
}

}  // namespace

void SideView::choose(const Inspection& view) {
  if (id == view.id) return;
  id = view.id;
  logarithmic = view.logarithmic;
  range.reset();
}

FrameReport SideView::draw(const Subject& subject, MethodInstance& instance, Inspector& inspector) {
  shown.reset();
  const auto view = id.empty() ? std::nullopt : Inspector::find(*instance.method, id);
  if (!view)
    return render_frame(subject.device, subject.pipelines, subject.targets, subject.prelude,
                        subject.transparents, instance);
  slice = std::min(slice, std::max(view->slices, 1u) - 1);
  shown = inspector.inspect(subject, instance, *view, slice);
  found = range_of(shown->values);
  scale = scale_of(*this, *view, found);
  show(subject.device, subject.targets, value_image(shown->values, scale));
  return shown->report;
}

}  // namespace plume
