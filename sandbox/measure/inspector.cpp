#include "sandbox/measure/inspector.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sandbox/measure/flip.h"

namespace plume {
namespace {

constexpr std::string_view kFlip = "flip", kDifference = "difference";

/// Infinite where either is not a number.
Raster<float> largest_difference(const Image& a, const Image& b) {
  Raster<float> result{a.width, a.height, {}};
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::vec3 apart = glm::abs(a.pixels[i] - b.pixels[i]);
    result.pixels.push_back(std::isnan(apart.r + apart.g + apart.b) ? std::numeric_limits<float>::infinity()
                                                                    : std::max({apart.r, apart.g, apart.b}));
  }
  return result;
}

}  // namespace

ValueScale scale_of(const ViewChoice& choice, const Inspection& view, const ValueRange& found) {
  return scale_over(found, choice.range ? choice.range : view.range, choice.logarithmic);
}

DisplayImage image_of(const Inspected& seen, const ValueScale& scale) {
  return seen.what.classes.empty() ? value_image(seen.values, scale) : class_image(seen.values);
}

bool Inspector::needs_reference(std::string_view id) {
  return id == kFlip || id == kDifference;
}

void Inspector::release() {
  truth.release();
  errors_.clear();
}

std::vector<Inspection> Inspector::inspections(const Method& method) {
  std::vector<Inspection> all{
      {.id = std::string(kFlip),
       .title = "Error, as seen",
       .help = "FLIP against the exact reference on the displayed picture: 0 cannot be told apart, 1 is the "
               "largest there can be. Draws the reference too.",
       .unit = "FLIP",
       .range = glm::vec2(0, 1)},
      {.id = std::string(kDifference),
       .title = "Error, in light",
       .help = "Largest difference of a channel from the exact reference, linear light. Draws the reference "
               "too.",
       .unit = "radiance",
       .logarithmic = true}};
  std::ranges::move(inspections_of(method), std::back_inserter(all));
  return all;
}

std::optional<Inspection> Inspector::find(const Method& method, std::string_view id) {
  const auto all = inspections(method);
  const auto found = std::ranges::find(all, id, &Inspection::id);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

Inspected Inspector::inspect(const Subject& s, MethodInstance& instance, const Inspection& view,
                             uint32_t slice) {
  const auto draw = [&](MethodInstance& method, const Glance* glance) {
    return render_frame(s.device, s.pipelines, s.targets, s.prelude, s.transparents, method, nullptr, glance);
  };
  Inspected result{.what = view, .slice = slice, .values = {}, .slices = {}, .report = {}};
  if (needs_reference(view.id)) {
    const bool same_truth = truth.is_known();
    const DrawnPicture& exact = truth.of(s);
    result.report = draw(instance, nullptr);
    DrawnPicture picture = read_picture(s.device, s.targets);
    ErrorMap& known = errors_[instance.owner];
    if (!same_truth || known.view != view.id || known.picture.linear.pixels != picture.linear.pixels ||
        known.picture.display.pixels != picture.display.pixels) {
      known.values = view.id == kFlip ? flip(exact.display, picture.display).map
                                      : largest_difference(exact.linear, picture.linear);
      known.view = view.id;
      known.picture = std::move(picture);
    }
    result.values = known.values;
  } else {
    const Glance glance(s.device, s.targets.size, view.id, slice);
    result.report = draw(instance, &glance);
    result.values = {int(s.targets.size.x), int(s.targets.size.y), glance.read_values(s.device)};
  }
  result.slices = instance.method->depth_slices(s.device, instance.resources);
  return result;
}

}  // namespace plume
