// Where the methods sum absorbance over depth that keep a function of it, -ln T, before they draw: in cells
// of one or more pixels, along the range of depths that each cell's fragments span, or the whole scene's.
// Shaders use methods/parts/absorbance/cells.glsl, where the equation is.
#ifndef PLUME_METHODS_ABSORBANCE_CELLS_H
#define PLUME_METHODS_ABSORBANCE_CELLS_H

#include "renderer/methods/method.h"

namespace plume {

struct AbsorbanceCells {
  int resolution = 0;                 ///< index: 1/1, 1/2, 1/4, 1/8
  int range = 0;                      ///< index: of each cell, of the scene
  float near_m = 0.0f, far_m = 0.0f;  ///< of the scene's; 0: the view's
  bool rgb = true;                    ///< a function of depth for each channel, instead of their mean's
  bool exclude_self = true;           ///< fragments read it without their own share

  void visit(ParameterVisitor& visitor);

  uint32_t divisor() const { return 1u << resolution; }
  glm::uvec2 cells(glm::uvec2 size) const { return (size + divisor() - 1u) / divisor(); }
  uint64_t count(glm::uvec2 size) const { return uint64_t(cells(size).x) * cells(size).y; }
  /// Kept a cell: three where they are wanted and something transparent has a colour.
  uint32_t channels(const Transparents& transparents) const;

  void add_needs(Needs& needs, glm::uvec2 size) const;
  /// Passes "farthest" and "range", where they are needed.
  void record_ranges(const Picture& picture) const;
  /// Draws all cards, or those of one source, at the cells' resolution. The method's own constants follow
  /// those of all.
  void draw(gpu::Pass& pass, const Picture& picture, const std::string& fragment,
            const gpu::Constants& own_constants, gpu::Bindings own_bindings,
            std::optional<Source> source = {}, std::vector<gpu::Attachment> targets = {}) const;
  /// What splats counted: absorbance_clamped, outside_range.
  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const;
  static std::span<const Shortfall> shortfalls();
  /// What cells.glsl specialises, and what it binds.
  gpu::Constants constants(const Transparents& transparents, const gpu::Constants& own) const;
  gpu::Bindings bindings(const Resources& resources, gpu::Bindings own) const;
};

}  // namespace plume
#endif
