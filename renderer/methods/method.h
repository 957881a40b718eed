// What an order-independent transparency method is. One file in renderer/methods/, its shaders in
// shaders/methods/, one line in methods.cpp: the rest of Plume finds it there.
#ifndef PLUME_METHODS_METHOD_H
#define PLUME_METHODS_METHOD_H

#include <glm/glm.hpp>

#include "renderer/inspection.h"
#include "renderer/parameters.h"
#include "renderer/transparents.h"

namespace plume {

/// The one format of linear HDR images between passes.
constexpr vk::Format kHdrFormat = vk::Format::eR16G16B16A16Sfloat;

/// Of images that a draw writes and a later pass reads.
constexpr auto kTargetUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eSampled;

/// Images and buffers a method declares. The renderer makes them, names them, sizes them with the picture,
/// and clears those that say so.
struct ImageNeed {
  std::string name;
  vk::Format format;
  vk::ImageUsageFlags usage;
  uint32_t divisor = 1;  ///< of the picture's size, rounded up
  uint32_t depth = 1;    ///< slices of a 3-D image
  uint32_t layers = 0;   ///< of an array; 0: a plain image
  uint32_t samples = 1;  ///< a pixel: 1 or 4
};
struct BufferNeed {
  std::string name;
  uint64_t bytes;
  std::optional<uint32_t> clear;  ///< word written before every frame
};
struct Needs {
  std::vector<ImageNeed> images;
  std::vector<BufferNeed> buffers;
};

/// Bytes of all of them for a picture of `size`; drivers may round them up.
uint64_t bytes_of(const Needs& needs, glm::uvec2 size);

/// A method's declared resources, made real for one picture size.
class Resources {
 public:
  /// Keeps what still fits, makes what is new or has changed, drops the rest.
  void fit(gpu::Device& device, const std::string& owner, const Needs& needs, glm::uvec2 size);

  const gpu::Image& image(const std::string& name) const { return images_.at(name); }
  const gpu::Buffer& buffer(const std::string& name) const { return buffers_.at(name); }

 private:
  std::map<std::string, gpu::Image> images_;
  std::map<std::string, gpu::Buffer> buffers_;
};

/// What a picture can have beyond its colours. RGBA16F images, zero where there is nothing:
///   distortion  xy: sum over haze of shift * T, in pixels; what is seen there comes from pixel + shift
///               z, w: sum of |shift| T / depth and of |shift| T, so that z / w is the haze's inverse depth,
///               1/m
///   surface     r: sum of p T / depth, 1/m, and g: of p T, over everything visible, where p is how much of a
///               fragment shows (see shaders/surface/presence.glsl); ba: sum of p T * motion, in pixels a
///               tick
/// Depths are kept inverse because circles of confusion are linear in 1 / depth, and the sky's is 0.
struct Outputs {
  bool distortion = false, surface = false;
};
/// "distortion, no surface".
inline std::string to_text(const Outputs& outputs) {
  return std::string(outputs.distortion ? "distortion" : "no distortion") +
         (outputs.surface ? ", surface" : ", no surface");
}
constexpr vk::Format kOutputFormat = vk::Format::eR16G16B16A16Sfloat;

/// Everything a method needs to record one frame, between the opaque image and the final one.
struct Picture {
  gpu::Frame& frame;
  const Resources& resources;
  const Transparents& transparents;
  const gpu::Image& opaque_color;          ///< kHdrFormat
  const gpu::Image& opaque_depth;          ///< D32, reversed
  const gpu::Image& result;                ///< kHdrFormat: every pixel must be written
  const gpu::Image* distortion = nullptr;  ///< null: not wanted, or not among the method's outputs()
  const gpu::Image* surface = nullptr;     ///< the same
  glm::uvec2 size;

  gpu::Area area() const { return {size.x, size.y}; }
};

/// The draw of all cards in front of opaque things, without a shader.
Transparents::Style front_of_opaque(const Picture& picture);

struct Probe;
struct Glance;

/// View depths at one pixel, m, for people who look at its transmittance. Empty where a method has no such
/// thing.
struct DepthMarks {
  struct Slice {
    float begin, end;
  };
  std::vector<Slice> slices;        ///< that depth is cut into, front to back; empty space may lie between
  std::optional<float> zero_m;      ///< behind it nothing is drawn: less than the zero transmittance is left
  std::optional<float> overflow_m;  ///< where the first slice begins whose sum overflowed
};

/// Something that a method got wrong because there was no room or no number for it. People read
/// "`what`: 12. `remedy`."; names of parameters stand in backticks.
struct Shortfall {
  std::string_view statistic;  ///< of statistics(), that counts it; 0, or not there: it did not happen
  std::string_view what, remedy;
};

/// What a reader of the method list wants to know before any picture.
struct Traits {
  std::string_view title;
  std::string_view source;        ///< paper or document, and section
  std::string_view transmission;  ///< how coloured transmission is treated
  std::string_view emission;      ///< how emission without coverage is treated
  std::string_view limits;        ///< its known failure
  /// Equal to the reference within 1e-3 of the picture's brightest light wherever nothing overflows.
  bool exact = false;
  /// RMSE against the reference, linear light, that its default parameters stay below on the shipped scene
  /// street at its default tick, 320x180. Held by a test.
  double street_rmse = 0.0;
  /// What rounding takes of a fragment's light or transmittance at most, relative, where it is more than half
  /// floats': by formats, or by texture filters that step.
  double rounding = 0.0;
  /// Blurs or bends the background by itself: a pixel may show what another has behind it.
  bool moves_background = false;
};

class Method {
 public:
  virtual ~Method() = default;

  virtual std::string_view id() const = 0;
  virtual Traits traits() const = 0;
  virtual void visit(ParameterVisitor&) {}
  /// Names of what the device lacks for this method; empty when it can run.
  virtual std::vector<std::string> missing(const gpu::Device&) const { return {}; }
  /// What it needs for a picture of `size` of these transparent things.
  virtual Needs needs(glm::uvec2 size, const Transparents& transparents) const = 0;
  /// Which of them it writes when a picture wants them. For the others the picture says that they are
  /// missing.
  virtual Outputs outputs() const { return {}; }
  /// What writing these takes, beyond needs().
  virtual Needs output_needs(glm::uvec2, const Transparents&, const Outputs&) const { return {}; }
  /// Records what can be done before opaque things are shaded; gives the depth that hides some of them.
  virtual const gpu::Image& prepare(const Picture& picture) { return picture.opaque_depth; }
  virtual void record(const Picture& picture) = 0;
  /// After record(), in the same frame or in a later one before the next: answers what it believes of one
  /// pixel, with the functions and the resources that the picture was drawn with. Writes none of them. See
  /// renderer/probe.h.
  virtual void probe(const Picture& picture, const Probe& probe) const = 0;
  /// Depths that mean something to it at one pixel of the picture that was drawn. May wait for the device.
  virtual DepthMarks depth_marks(gpu::Device&, const Resources&, const Transparents&,
                                 glm::uvec2 /*pixel*/) const {
    return {};
  }
  /// What can be looked at in it as it is set, and, as probe() is, a glance at one of these. See
  /// renderer/glance.h.
  virtual std::vector<Inspection> inspections() const { return {}; }
  virtual void inspect(const Picture&, const Glance&) const {}
  /// The draws that shade colour, as record() just issued them: what a glance at the shaded fragments draws
  /// again, to count.
  virtual std::vector<Transparents::Style> shading(const Picture& picture) const {
    return {front_of_opaque(picture)};
  }
  /// Slices of the last frame that hold something, front to back, where it cuts depth into slices. May wait
  /// for the device.
  virtual std::vector<DepthSlice> depth_slices(gpu::Device&, const Resources&) const { return {}; }
  /// What the last frame tells of itself beyond its passes, name -> number; for reports. May wait for the
  /// device.
  virtual nlohmann::json statistics(gpu::Device&, const Resources&) const { return nlohmann::json::object(); }
  /// What of these numbers means that the picture is less than the method can do.
  virtual std::span<const Shortfall> shortfalls() const { return {}; }
  /// Called when the frame is done: true when something overflowed, needs() has grown, and the frame must be
  /// drawn again.
  virtual bool must_redraw(gpu::Device&, const Resources&) { return false; }
};

}  // namespace plume
#endif
