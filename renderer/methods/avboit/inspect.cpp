// What can be looked at in AVBOIT: each view reads what a stage left, with the functions of the stages that
// follow.
#include <bit>
#include <cmath>

#include "renderer/glance.h"
#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {
namespace {

bool notes_overflow(const Settings& s) {
  return s.splat == Splat::kPacked8Overflow || s.splat == Splat::kPacked16Overflow ||
         s.rgb_splat == RgbSplat::kPacked10;
}

struct View {
  Inspection what;
  void (*record)(const Picture&, const Plan&, const Glance&);
};

void glance_at_zero_depth(const Picture& picture, const Plan&, const Glance& glance, const char* depths,
                          uint32_t culling) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  glance_with(picture, glance, "methods/avboit/inspect_zero_depth.comp", {culling},
              {{"VolumeBlock", buffer("volume")},
               {"WarpTable", buffer("warp")},
               {"ZeroSlice", buffer("zero_slice")},
               {"ZeroDepths", buffer(depths)}});
}

void glance_at_overflow(const Picture& picture, const Plan& plan, const Glance& glance) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  glance_with(picture, glance, "methods/avboit/inspect_overflow.comp", {plan.rgb_words() == 1 ? 1u : 0u},
              {{"VolumeBlock", buffer("volume")},
               {"WarpTable", buffer("warp")},
               {"Overflow", buffer("overflow")},
               {"OverflowRgb", buffer("overflow_rgb")}});
}

void glance_at_occupancy(const Picture& picture, const Glance& glance, uint32_t one_slice) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  glance_with(
      picture, glance, "methods/avboit/inspect_occupancy.comp", {1, one_slice},
      {{"VolumeBlock", buffer("volume")}, {"WarpTable", buffer("warp")}, {"Occupancy", buffer("occupancy")}});
}

void glance_at_extinction(const Picture& picture, const Plan& plan, const Glance& glance) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  glance_with(picture, glance, "methods/avboit/inspect_extinction.comp",
              {plan.settings.sparse ? 1u : 0u, plan.settings.lane_bits(), plan.rgb_words(), 0, 0,
               plan.raster() ? 1u : 0u, plan.rgb ? 1u : 0u},
              {{"VolumeBlock", buffer("volume")},
               {"WarpTable", buffer("warp")},
               {"Occupancy", buffer("occupancy")},
               {"Extinction", buffer("extinction")},
               {"ExtinctionRgb", buffer("extinction_rgb")},
               {"extinction_layers", image("extinction_layers")},
               {"extinction_layers_rgb", image("extinction_layers_rgb")}});
}

void glance_at_integral(const Picture& picture, const Plan& plan, const Glance& glance) {
  gpu::Bindings bindings = transmittance_bindings(picture);
  bindings.push_back({"Occupancy", &picture.resources.buffer("occupancy")});
  const Settings& s = plan.settings;
  glance_with(picture, glance, "methods/avboit/inspect_integral.comp",
              {uint32_t(s.sampling), s.linear_splat ? 1u : 0u,
               plan.rgb && plan.colour() == Colour::kRgb ? 1u : 0u, s.sparse ? 1u : 0u},
              std::move(bindings));
}

void glance_at_slice_map(const Picture& picture, const Plan&, const Glance& glance) {
  glance_with(picture, glance, "methods/avboit/inspect_slice_map.comp", {},
              {{"VolumeBlock", &picture.resources.buffer("volume")},
               {"WarpTable", &picture.resources.buffer("warp")}});
}

std::vector<View> views_of(const Settings& s) {
  std::vector<View> views{
      {{.id = "zero_transmittance",
        .title = "Zero-transmittance depth",
        .help =
            "Of a cell of the volume: view depth behind which less than zero_transmittance is left, at the "
            "end of a slice.",
        .unit = "m",
        .logarithmic = true,
        .absent = "some light passes all the way"},
       [](const Picture& picture, const Plan& plan, const Glance& glance) {
         glance_at_zero_depth(picture, plan, glance, "zero_slice", 0);
       }}};
  if (s.zero_depth != ZeroDepth::kOff)
    views.push_back({{.id = "culling_depth",
                      .title = "Culling depth",
                      .help = "Of a tile of 16 pixels: view depth behind which no fragment is drawn, the "
                              "farthest zero-transmittance depth that its pixels read and a guard.",
                      .unit = "m",
                      .logarithmic = true,
                      .absent = "nothing is culled"},
                     [](const Picture& picture, const Plan& plan, const Glance& glance) {
                       glance_at_zero_depth(picture, plan, glance, "zero_depths", 1);
                     }});
  if (notes_overflow(s))
    views.push_back(
        {{.id = "first_overflow",
          .title = "First-overflow depth",
          .help = "Of a cell: end of the first slice whose field could not hold the optical depth "
                  "in it, m. From there on every slice counts as full.",
          .unit = "m",
          .logarithmic = true,
          .absent = "no overflow"},
         glance_at_overflow});
  views.push_back({{.id = "occupancy",
                    .title = "Occupied slices",
                    .help = "Of a tile of cells: physical slices that cards touch or read, which are cleared "
                            "and integrated there.",
                    .unit = "slices",
                    .absent = "no slice"},
                   [](const Picture& picture, const Plan&, const Glance& glance) {
                     glance_at_occupancy(picture, glance, 0);
                   }});
  views.push_back({{.id = "occupied",
                    .title = "Occupancy of a slice",
                    .help = "Tiles of cells in which a slice is occupied, and what by.",
                    .unit = "",
                    .range = glm::vec2(0, 3),
                    .slices = s.slice_count(),
                    .absent = "empty there",
                    .classes = {"1: scalar sources", "2: RGB sources", "3: both"}},
                   [](const Picture& picture, const Plan&, const Glance& glance) {
                     glance_at_occupancy(picture, glance, 1);
                   }});
  views.push_back({{.id = "extinction",
                    .title = "Extinction in a slice",
                    .help = "Optical depth that was splatted into a slice of each cell, of RGB sources the "
                            "mean of the channels. Cards in exact layers are not in it.",
                    .unit = "optical depth",
                    .logarithmic = true,
                    .slices = s.slice_count(),
                    .absent = "empty there"},
                   glance_at_extinction});
  views.push_back(
      {{.id = "integral",
        .title = "Transmittance behind a slice",
        .help = "What passes from the far end of a slice to the camera, as draws read it, the mean "
                "of the channels. Cards in exact layers are not in it.",
        .unit = "transmittance",
        .range = glm::vec2(0, 1),
        .slices = s.slice_count(),
        .absent = "slice not in use"},
       glance_at_integral});
  views.push_back(
      {{.id = "slice_map",
        .title = "Physical to virtual slices",
        .help = "A chart over the picture: physical slices in use from left to right, the virtual "
                "slice of each as the height and the number of its bar. Steps are empty space "
                "that is skipped.",
        .unit = "virtual slice",
        .absent = "above the bar",
        .over_slices = true},
       glance_at_slice_map});
  return views;
}

}  // namespace

std::vector<Inspection> inspections(const Settings& settings) {
  std::vector<Inspection> all;
  for (View& view : views_of(settings)) all.push_back(std::move(view.what));
  return all;
}

void record_inspection(const Picture& picture, const Plan& plan, const Glance& glance) {
  for (const View& view : views_of(plan.settings))
    if (view.what.id == glance.id) view.record(picture, plan, glance);
}

std::vector<DepthSlice> depth_slices(gpu::Device& device, const Resources& resources, const Plan& plan) {
  const auto words = gpu::read<uint32_t>(device, resources.buffer("warp"));
  shared::DepthWarp warp;
  std::memcpy(&warp, words.data(), sizeof(warp));
  constexpr size_t kHead = sizeof(warp) / 4;
  const auto number = [&](size_t i) { return std::bit_cast<float>(words[kHead + i]); };
  std::vector<DepthSlice> slices;
  for (uint32_t v = 0; v < warp.virtual_slices; ++v) {
    float begin = plan.volume.curve_a * (std::exp2(float(v) / warp.scale) - 1.0f);
    for (auto s = uint32_t(number(shared::kMostSlices + v));
         s < uint32_t(number(shared::kMostSlices + v + 1)); ++s) {
      slices.push_back({.near_m = begin, .far_m = number(s), .virtual_slice = v});
      begin = number(s);  // several share a virtual slice that is set apart
    }
  }
  return slices;
}

}  // namespace plume::avboit
