#include "renderer/methods/parts/absorbance_cells.h"

#include <bit>

#include "renderer/methods/parts/farthest_depth.h"
#include "shaders/methods/parts/absorbance/counts.h"

namespace plume {
namespace {

constexpr std::string_view kResolutions[] = {"1/1", "1/2", "1/4", "1/8"};
constexpr std::string_view kRanges[] = {"pixel", "scene"};

}  // namespace

void AbsorbanceCells::visit(ParameterVisitor& visitor) {
  visitor.choice("resolution", resolution, kResolutions,
                 "of the transmittance across the picture: coarser is cheaper, silhouettes are as coarse");
  visitor.choice("range", range, kRanges,
                 "of depths that is resolved: found for each pixel in a pass of its own, or near to far for "
                 "all, which is cheaper and coarser");
  visitor.number("near", near_m,
                 {.min = 0.0,
                  .max = 10000.0,
                  .unit = "m",
                  .help = "where the scene's range begins: the nearer to what is seen the finer; 0 = the "
                          "near plane"});
  visitor.number(
      "far", far_m,
      {.min = 0.0,
       .max = 100000.0,
       .unit = "m",
       .help = "where the scene's range ends: farther things share a depth; 0 = the scene's far_m"});
  visitor.toggle("exclude_self", exclude_self,
                 "takes a fragment's own absorbance out of what it reads: it does not shade itself");
}

uint32_t AbsorbanceCells::channels(const Transparents& transparents) const {
  return rgb && transparents.number(Source::kRgb) > 0 ? 3 : 1;
}

void AbsorbanceCells::add_needs(Needs& needs, glm::uvec2 size) const {
  needs.buffers.push_back({.name = "ranges", .bytes = (range == 0 ? count(size) : 1) * 8, .clear = 0});
  needs.buffers.push_back({.name = "counts", .bytes = sizeof(shared::AbsorbanceCounts), .clear = 0});
  if (resolution == 0) return;
  farthest_depth::add_needs(needs, divisor());
}

void AbsorbanceCells::record_ranges(const Picture& picture) const {
  if (resolution != 0) farthest_depth::record(picture, divisor());
  if (range == 0)
    picture.frame.pass("range", [&](gpu::Pass& pass) {
      draw(pass, picture, "methods/parts/absorbance/range.frag", {}, {});
    });
}

void AbsorbanceCells::draw(gpu::Pass& pass, const Picture& picture, const std::string& fragment,
                           const gpu::Constants& own_constants, gpu::Bindings own_bindings,
                           std::optional<Source> source, std::vector<gpu::Attachment> targets) const {
  const glm::uvec2 area = cells(picture.size);
  picture.transparents.draw(
      pass, {.fragment = fragment,
             .targets = std::move(targets),
             .depth_test = resolution == 0 ? &picture.opaque_depth : nullptr,
             .opaque_depth = resolution == 0 ? &picture.opaque_depth : &picture.resources.image("farthest"),
             .area = {area.x, area.y},
             .source = source,
             .constants = constants(picture.transparents, own_constants),
             .bindings = bindings(picture.resources, std::move(own_bindings)),
             .covered = glm::vec2(picture.size) / glm::vec2(area * divisor())});
}

nlohmann::json AbsorbanceCells::statistics(gpu::Device& device, const Resources& resources) const {
  const auto counts = gpu::read<shared::AbsorbanceCounts>(device, resources.buffer("counts"))[0];
  return {{"absorbance_clamped", counts.clamped}, {"outside_range", counts.outside}};
}

std::span<const Shortfall> AbsorbanceCells::shortfalls() {
  static constexpr Shortfall kShortfalls[] = {
      {.statistic = "outside_range",
       .what = "Fragments outside the range of depths, which count as if at its end",
       .remedy = "Widen `near` and `far`, or set `range` to pixel"}};
  return kShortfalls;
}

gpu::Constants AbsorbanceCells::constants(const Transparents& transparents, const gpu::Constants& own) const {
  gpu::Constants all{divisor(),
                     range == 0 ? 1u : 0u,
                     channels(transparents),
                     exclude_self ? 1u : 0u,
                     std::bit_cast<uint32_t>(near_m),
                     std::bit_cast<uint32_t>(far_m)};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

gpu::Bindings AbsorbanceCells::bindings(const Resources& resources, gpu::Bindings own) const {
  own.insert(own.end(), {{"Ranges", &resources.buffer("ranges")}, {"Counts", &resources.buffer("counts")}});
  return own;
}

}  // namespace plume
