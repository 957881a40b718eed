#include "renderer/methods/avboit/settings.h"

#include <bit>
#include <cmath>

#include "shaders/methods/avboit/volume.h"

namespace plume::avboit {
namespace {

constexpr std::string_view kResolutions[] = {"1/2", "1/4", "1/8"};
constexpr uint32_t kDivisors[] = {2, 4, 8};
constexpr std::string_view kSliceNames[] = {"32", "64", "128", "256"};
constexpr uint32_t kSliceCounts[] = {32, 64, 128, 256};
constexpr std::string_view kVirtualNames[] = {"1024", "2048", "4096", "8192", "16384", "32768"};
constexpr uint32_t kLeastVirtualChoice = 1024;
constexpr std::string_view kSplats[] = {"packed8",  "packed8_exchange", "packed8_overflow",
                                        "packed16", "words32",          "raster"};
constexpr std::string_view kRgbSplats[] = {"packed10", "words32", "raster"};
constexpr std::string_view kExactNames[] = {"0", "2", "4", "8"};
constexpr uint32_t kExactLayers[] = {0, 2, 4, 8};
constexpr std::string_view kSamples[] = {"1", "4"};
constexpr std::string_view kSamplings[] = {"point", "linear", "quadratic", "cubic", "self_excluded"};
constexpr Mode kColours[] = {
    {"mono", "Glass darkens and never tints: the mean of RGB. The cheapest."},
    {"total_extinction", "What is opaque is tinted by all glass in front of it; smoke behind glass is not."},
    {"skew",
     "Chromaticity skew: smoke and fire too are tinted, by the glass of all depths, as far as they are "
     "seen."},
    {"first_event",
     "The same, and what tints does not tint its own light: right for one glass, not for several."},
    {"rgb",
     "A transmittance for each channel: only what is behind glass is tinted. Coloured things pay for it."}};
constexpr std::string_view kAccumulations[] = {"11_11_10", "16f", "32f", "deterministic"};
constexpr std::string_view kZeroDepths[] = {"off", "quads", "fullscreen"};

template <class Enum>
void choice(ParameterVisitor& visitor, std::string_view name, Enum& value,
            std::span<const std::string_view> options, std::string_view help) {
  int index = int(value);
  visitor.choice(name, index, options, help);
  value = Enum(index);
}

}  // namespace

void Settings::visit(ParameterVisitor& visitor) {
  visitor.choice("resolution", resolution, kResolutions,
                 "of the volume across the picture: finer silhouettes, for splat time and memory");
  visitor.choice("slices", slices, kSliceNames,
                 "along a ray: more separate closer layers, for memory and integration time");
  visitor.number(
      "curve_a", curve_a,
      {.min = 0.01, .max = 10000.0, .unit = "m", .help = "depth up to which slices are about equally thick"});
  visitor.number(
      "curve_b", curve_b,
      {.min = 1.0, .max = 100000.0, .unit = "m", .help = "depth of the last slice; farther is in it"});
  if (adaptive) {
    visitor.choice("virtual_slices", virtual_slices, kVirtualNames,
                   "at which adaptation starts: more keep thin ranges finer");
    visitor.number(
        "slice_thickness", slice_thickness,
        {.min = 0.0,
         .max = 10.0,
         .unit = "m",
         .help = "asks for virtual slices this thin instead, up to thickness_range; 0 = do not ask"});
    visitor.number("thickness_range", thickness_range,
                   {.min = 0.1, .max = 10000.0, .unit = "m", .help = "depth up to which it is asked for"});
  }
  choice(visitor, "splat", splat, kSplats,
         "how optical depth of scalar sources is stored: more bits keep thin smoke, fewer take less memory; "
         "raster "
         "multiplies transmittance into layers and takes each card as one slice");
  choice(visitor, "rgb_splat", rgb_splat, kRgbSplats,
         "the same of RGB sources: packed carries into the next channel after four saturated events");
  visitor.toggle("linear_splat", linear_splat, "shares optical depth between two slices: smooth over depth");
  visitor.toggle("dither", dither, "rounds optical depth at random, unbiased: thin smoke does not vanish");
  visitor.choice("samples", samples, kSamples,
                 "of a card's texture in a cell: four alias less at silhouettes and small cards");
  visitor.toggle("sparse", sparse, "clears and integrates occupied slices only");
  choice(visitor, "sampling", sampling, kSamplings,
         "how the integral is read: biased in front of the fragment, or at it without its own share");
  visitor.number("bias", bias,
                 {.min = 0.0,
                  .max = 8.0,
                  .unit = "slices",
                  .help = "of biased samplings: less self-occludes, more misses what is close in front; the "
                          "talk takes 2 for linear, 2.5 for quadratic and cubic"});
  visitor.toggle("eight_bits", eight_bits,
                 "biased samplings read transmittance in 8 bits, as the talk stores it");
  int mode = int(colour);
  visitor.modes("colour", mode, kColours,
                "what coloured glass does to what lies behind it: cheaper modes tint the wrong things");
  colour = Colour(mode);
  visitor.toggle("skew_guard", skew_guard,
                 "skew and first_event: no tint where a coloured event shares its slice with another");
  visitor.toggle("normalise", normalise, "scales the sum so that coverage adds up exactly");
  visitor.toggle(
      "weigh_doubt", weigh_doubt,
      "of self_excluded: weights change as far as the volume is in doubt of them, not all alike: finer "
      "edges of smoke, for one sum more");
  visitor.choice("exact_layers", exact_layers, kExactNames,
                 "nearest fragments of hard-edged and small cards kept a pixel, instead of in the "
                 "volume: exact glass and sparks, for memory");
  visitor.number("small_cells", small_cells,
                 {.min = 0.0,
                  .max = 16.0,
                  .unit = "cells",
                  .help = "half extent below which smoke that is seen counts as small: finer edges of what "
                          "is far away, for time"});
  choice(visitor, "accumulation", accumulation, kAccumulations,
         "format of the sums: rounding for bandwidth; thin layers are lost in 16 bits. Deterministic adds "
         "integers: the same bits whatever the order of draws, before haze and depth of field");
  choice(visitor, "zero_depth", zero_depth, kZeroDepths,
         "does not draw what lies behind opaque smoke: tile quads, or every pixel's depth to compare");
  visitor.number("zero_transmittance", zero_transmittance,
                 {.min = 1e-6, .max = 0.1, .unit = "", .help = "below this nothing behind is drawn"});
  visitor.toggle(
      "half_particles", half_particles,
      "draws soft particles at half the resolution beside everything else: a quarter of the fragments, "
      "coarser edges");
  visitor.toggle("cull_opaque", cull_opaque, "does not shade opaque things behind opaque smoke either");
}

uint32_t Settings::divisor() const {
  return kDivisors[resolution];
}

uint32_t Settings::slice_count() const {
  return kSliceCounts[slices];
}

double Settings::virtual_slices_asked() const {
  if (slice_thickness <= 0.0f) return kLeastVirtualChoice << virtual_slices;
  // A slice at z is (a + z) ln(1 + b / a) / n thick.
  return std::ceil((curve_a + thickness_range) * std::log1p(double(curve_b) / curve_a) /
                   double(slice_thickness));
}

uint32_t Settings::virtual_slice_count() const {
  const double asked = std::min(virtual_slices_asked(), double(shared::kMostVirtualSlices));
  return std::max(std::bit_ceil(uint32_t(asked)), shared::kMostSlices);
}

uint32_t Settings::exact_layer_count() const {
  return kExactLayers[exact_layers];
}

uint32_t Settings::lane_bits() const {
  return splat == Splat::kWords32 ? 32 : splat == Splat::kPacked16Overflow ? 16 : 8;
}

}  // namespace plume::avboit
