// What is drawn transparent, and how a method draws it: every card, with the shared vertex shader and the
// method's fragment shader.
#ifndef PLUME_RENDERER_TRANSPARENTS_H
#define PLUME_RENDERER_TRANSPARENTS_H

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/gpu/frame.h"

namespace plume {

/// What a card does to light decides which draws it belongs to, so that only those pay that need to. The
/// cards of one source stand together.
enum class Source {
  kScalar,  ///< passes all colours alike
  kHaze,    ///< only bends light
  kRgb,     ///< passes some colours better than others
};
constexpr uint32_t kSources = 3;

/// Of something seen that passes this share of light where it covers.
Source source_of(glm::vec3 transmission);

/// What an artist or a CPU orders as a whole: one pane, or the particles of one emitter of an instance,
/// oldest first.
struct CardGroup {
  uint32_t first, count;  ///< of the cards
  float depth;            ///< view depth of where it stands, m
  int draw_order;         ///< the artist's: lower ones are drawn first, behind
};

/// The cards of one tick and what shading them needs. Owned by whoever fills them; methods only draw. Which
/// are seen is known on the device only: see SeenCards.
struct Transparents {
  const gpu::Buffer* cards = nullptr;  ///< shared::Card[count]
  const gpu::Buffer* order =
      nullptr;  ///< those that are seen, in the order of submission: uint[at most count]
  const gpu::Buffer* work = nullptr;   ///< how many are seen: shared::Workload
  const gpu::Buffer* draws = nullptr;  ///< of all that are seen, then of each source: shared::DrawCommand
  const gpu::Image* puffs =
      nullptr;  ///< array of optical depth, normal, openness; see shaders/effects/puff.comp
  const gpu::Buffer* view = nullptr;  ///< shared::ViewData
  uint32_t count = 0;                 ///< of `cards`, seen or not
  std::array<uint32_t, kSources>
      counts{};                   ///< of each source, which follow each other in `cards` and `order`
  std::vector<CardGroup> groups;  ///< each card once, in the order of the scene; empty: all are one group

  struct Style {
    std::string fragment;  ///< the method's shader
    std::vector<gpu::Attachment> targets;
    const gpu::Image* depth_test = nullptr;          ///< null: the shader tests for itself
    gpu::DepthUse depth_use = gpu::DepthUse::kTest;  ///< of `depth_test`
    const gpu::Image* opaque_depth =
        nullptr;  ///< what shade() feathers against, at the resolution of the draw
    gpu::Area area{0, 0};
    std::optional<glm::uvec2> pixel;  ///< of the area: nothing else is drawn
    std::string vertex = "surface/card.vert";
    std::optional<Source> source;  ///< nothing: all cards; only in the order of submission
    gpu::Constants constants;
    gpu::Bindings bindings;                 ///< the method's own, bindings 8 and up
    const gpu::Buffer* order = nullptr;     ///< of all that are seen, instead of the order of submission
    const gpu::Buffer* indirect = nullptr;  ///< which of `order`, instead of `source`
    uint32_t indirect_index = 0;
    bool count_fragments = false;
    bool backwards = false;   ///< last of the order first
    glm::vec2 covered{1.0f};  ///< share of `area` that the picture fills, when cells do not divide it
  };
  void draw(gpu::Pass& pass, const Style& style) const;
  /// "View", "Cards", "Order" and "Work", for a dispatch over each_seen().
  gpu::Bindings seen() const;
  gpu::IndirectGroups each_seen() const;

  uint32_t first(Source source) const;
  uint32_t number(Source source) const { return counts[size_t(source)]; }
};

}  // namespace plume
#endif
