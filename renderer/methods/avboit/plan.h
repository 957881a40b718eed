// One frame of AVBOIT: its settings and what follows from them for a picture and what is drawn in it. Each
// stage is a file that declares what it needs and records its passes.
#ifndef PLUME_AVBOIT_PLAN_H
#define PLUME_AVBOIT_PLAN_H

#include "renderer/methods/avboit/settings.h"
#include "renderer/methods/method.h"
#include "shaders/methods/avboit/card_class.h"
#include "shaders/methods/avboit/volume.h"

namespace plume::avboit {

/// Divisor of an image that these settings do not use: one texel, for the descriptor.
constexpr uint32_t kNowhere = 1u << 16;

struct Plan {
  Plan(const Settings& settings, glm::uvec2 size, const Transparents& transparents);

  Settings settings;
  glm::uvec2 size;  ///< of the picture
  shared::Volume volume;
  bool rgb;                 ///< RGB sources are there and keep extinction for each channel
  bool coloured;            ///< RGB sources are there and their colours count at all
  uint32_t first_coloured;  ///< index of the first such card

  uint64_t rays() const { return uint64_t(volume.cells.x) * volume.cells.y; }
  uint64_t tiles() const { return uint64_t(volume.tiles.x) * volume.tiles.y; }
  /// Weights are split by how far the volume is in doubt of them.
  bool tells_doubt() const { return settings.weigh_doubt && settings.sampling == Sampling::kSelfExcluded; }
  /// Coloured events that share a slice with another are looked for.
  bool watches_overlap() const {
    return coloured && (settings.colour == Colour::kSkew || settings.colour == Colour::kFirstEvent);
  }
  /// How transmission is treated where there may be nothing that has a colour.
  Colour colour() const { return coloured ? settings.colour : Colour::kMono; }
  bool raster() const { return settings.splat == Splat::kRaster; }
  bool rgb_raster() const { return rgb && settings.rgb_splat == RgbSplat::kRaster; }
  /// Words of RGB extinction a slice in the buffer.
  uint32_t rgb_words() const {
    if (!rgb || rgb_raster()) return 0;
    return settings.rgb_splat == RgbSplat::kPacked10 ? 1 : 3;
  }
};

/// What the last frame of this plan left in the method's buffers. Waits for the device.
nlohmann::json statistics(gpu::Device& device, const Resources& resources, const Plan& plan);

void add_depth_warp_needs(Needs& needs, const Plan& plan);
/// coverage, adapt: which virtual slices are occupied, and the table from depth to physical slice.
void record_depth_warp(const Picture& picture, const Plan& plan);

void add_occupancy_needs(Needs& needs, const Plan& plan);
/// occupancy, clear: which slices of which tiles are occupied, and zero extinction there.
void record_occupancy(const Picture& picture, const Plan& plan);

void add_exact_layers_needs(Needs& needs, const Plan& plan);
/// exact_layers: the nearest fragments of sharp cards, pixel by pixel.
void record_exact_layers(const Picture& picture, const Plan& plan);

void add_splat_needs(Needs& needs, const Plan& plan);
/// farthest, splat: optical depth of every card into the volume.
void record_splat(const Picture& picture, const Plan& plan);

void add_integrate_needs(Needs& needs, const Plan& plan);
/// integrate: extinction summed along every ray.
void record_integrate(const Picture& picture, const Plan& plan);

void add_zero_depth_needs(Needs& needs, const Plan& plan);
/// zero_depth: the depth behind which nothing is seen, into a depth image of its own.
void record_zero_depth(const Picture& picture, const Plan& plan);
/// What transparent draws are tested against.
const gpu::Image& visible_depth(const Picture& picture, const Plan& plan);

void add_classify_needs(Needs& needs, const Plan& plan);
/// sources: cards sorted by where their extinction goes.
void record_sources(const Picture& picture, const Plan& plan);
/// classify: cards sorted by what drawing them has to do.
void record_classify(const Picture& picture, const Plan& plan);

void add_half_particles_needs(Needs& needs, const Plan& plan);
/// half_depth: depths for the particles that are drawn at half resolution.
void record_half_depth(const Picture& picture, const Plan& plan);

/// What methods/avboit/transmittance.glsl reads.
gpu::Bindings transmittance_bindings(const Picture& picture);

void add_resolve_needs(Needs& needs, const Plan& plan);
/// resolve: the final image from the sums.
void record_resolve(const Picture& picture, const Plan& plan);

void add_accumulate_needs(Needs& needs, const Plan& plan);
/// The draws of every fragment weighted by its transmittance.
std::vector<Transparents::Style> shading(const Picture& picture, const Plan& plan);
/// draw: all of them.
void record_accumulate(const Picture& picture, const Plan& plan);

void add_sums_needs(Needs& needs, const Plan& plan);
/// draw, gather: all of them, added up as integers.
void record_sums(const Picture& picture, const Plan& plan);

/// distortion, surface: where the picture wants them, weighted by the same transmittance.
void record_outputs(const Picture& picture, const Plan& plan);

/// What can be looked at, and a glance at one of these.
std::vector<Inspection> inspections(const Settings& settings);
void record_inspection(const Picture& picture, const Plan& plan, const Glance& glance);
/// Of the last frame of this plan. Waits for the device.
std::vector<DepthSlice> depth_slices(gpu::Device& device, const Resources& resources, const Plan& plan);

/// probe: what the frame believes of one pixel.
void record_probe(const Picture& picture, const Plan& plan, const Probe& probe);
/// Slices, zero-transmittance depth and first overflow at a pixel. Waits for the device.
DepthMarks depth_marks(gpu::Device& device, const Resources& resources, const Plan& plan,
                       const Transparents& transparents, glm::uvec2 pixel);

}  // namespace plume::avboit
#endif
