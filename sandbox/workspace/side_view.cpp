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

ViewChoice SideView::choice() const {
  if (!shown) return {};
  return {
      .id = id, .slice = shown->slice, .logarithmic = logarithmic, .range = glm::vec2(scale.low, scale.high)};
}

void SideView::choose(const Inspection& view) {
  if (id == view.id) return;
  id = view.id;
  logarithmic = view.logarithmic;
  range = view.range ? Range::kWhole : Range::kFound;
}

FrameReport SideView::draw(const Subject& subject, MethodInstance& instance, Inspector& inspector) {
  shown.reset();
  const auto view = id.empty() ? std::nullopt : Inspector::find(*instance.method, id);
  if (!view)
    return render_frame(subject.device, subject.pipelines, subject.targets, subject.prelude,
                        subject.transparents, instance);
  const uint32_t last = std::max(view->slices, 1u) - 1;
  shown = inspector.inspect(subject, instance, *view, std::min(slice.value_or(0), last));
  if (view->slices > 0 && !slice && !shown->slices.empty()) {
    slice = uint32_t(shown->slices.size() / 2);
    shown = inspector.inspect(subject, instance, *view, std::min(*slice, last));
  }
  found = range_of(shown->values);
  shares_scale = false;
  color(subject.device, subject.targets, found);
  return shown->report;
}

void SideView::color(gpu::Device& device, const Targets& targets, const ValueRange& over) {
  const std::optional<glm::vec2> wanted = range == Range::kHeld    ? std::optional(held)
                                          : range == Range::kWhole ? shown->what.range
                                                                   : std::nullopt;
  scale = scale_over(over, wanted, logarithmic);
  show(device, targets, image_of(*shown, scale));
}

void SideView::share_scale(gpu::Device& device, SideView& a, const Targets& a_targets, SideView& b,
                           const Targets& b_targets) {
  const auto takes_part = [](const SideView& view) { return view.shown && view.range == Range::kFound; };
  if (!takes_part(a) || !takes_part(b) || a.id != b.id || a.logarithmic != b.logarithmic) return;
  const ValueRange both = joined(a.found, b.found);
  a.color(device, a_targets, both);
  b.color(device, b_targets, both);
  a.shares_scale = b.shares_scale = true;
}

}  // namespace plume
