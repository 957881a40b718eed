// AVBOIT's parameters.
#ifndef PLUME_AVBOIT_SETTINGS_H
#define PLUME_AVBOIT_SETTINGS_H

#include "renderer/parameters.h"

namespace plume::avboit {

enum class Sampling : int { kPoint, kLinear, kQuadratic, kCubic, kSelfExcluded };
enum class Splat : int { kPacked8, kPacked8Exchange, kPacked8Overflow, kPacked16Overflow, kWords32, kRaster };
enum class RgbSplat : int { kPacked10, kWords32, kRaster };
enum class Colour : int { kMono, kTotalExtinction, kSkew, kFirstEvent, kRgb };
enum class Accumulation : int { kR11G11B10, kHalf, kFloat, kDeterministic };
enum class ZeroDepth : int { kOff, kQuads, kFullscreen };

struct Settings {
  bool adaptive = true;  ///< false: VBOIT, fixed slices

  int resolution = 2;  ///< index into kDivisors
  int slices = 2;      ///< index into kSliceCounts
  float curve_a = 2.0f, curve_b = 800.0f;
  int virtual_slices = 3;  ///< index into kVirtualSlices
  float slice_thickness = 0.0f, thickness_range = 20.0f;
  Splat splat = Splat::kPacked16Overflow;
  RgbSplat rgb_splat = RgbSplat::kWords32;
  bool linear_splat = true, dither = false, sparse = true, eight_bits = false;
  int samples = 0;  ///< index: 1, 4
  Sampling sampling = Sampling::kSelfExcluded;
  float bias = 2.0f;
  Colour colour = Colour::kRgb;
  bool skew_guard = true;
  bool normalise = true, weigh_doubt = true;
  Accumulation accumulation = Accumulation::kFloat;
  ZeroDepth zero_depth = ZeroDepth::kQuads;
  float zero_transmittance = 1.0f / 1024;
  bool cull_opaque = false;
  bool half_particles = false;
  int exact_layers = 2;  ///< index into kExactLayers
  float small_cells = 4.0f;

  void visit(ParameterVisitor& visitor);

  uint32_t divisor() const;
  uint32_t slice_count() const;
  /// At the finest: as chosen, or the least that makes slices thin enough over the range asked for.
  uint32_t virtual_slice_count() const;
  double virtual_slices_asked() const;  ///< before they are rounded up to a power of two, or limited
  uint32_t lane_bits() const;
  uint32_t exact_layer_count() const;
};

}  // namespace plume::avboit
#endif
