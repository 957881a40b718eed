// Alpha blending in sorted order ("No OIT"): cards are put in an order and blended back to front. The orders
// are those that engines have used, from the coarsest on: an artist's (by hand, emitter by emitter), a CPU's
// (emitters by the depth of where they stand), the same with a GPU sort inside each emitter, and a GPU sort
// across all cards by the depth of their centres. Inside what is not sorted the oldest particle is drawn
// first. The sort is part of the cost and its own pass. Limits: emitters in one another are wrong unless all
// cards are sorted together, and cards that cross each other are wrong in any order. The probe tells of cards
// in front by their centres, which is what the last of the orders draws; the others are no function of depth.
#include <bit>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/card_sort.h"
#include "renderer/probe.h"
#include "shaders/methods/sorted/groups.h"

namespace plume {
namespace {

enum class Order { kArtist, kCpu, kGpuEmitter, kGpuAll };
constexpr std::array<std::string_view, 4> kOrderNames = {"artist", "cpu", "gpu_emitter", "gpu_all"};

/// The rank of each group, front to back, when they are drawn as `order` says; by their first cards.
std::vector<shared::OrderedGroup> ordered_groups(const Transparents& transparents, Order order) {
  std::vector<CardGroup> groups = transparents.groups;
  if (groups.empty()) groups = {{.first = 0, .count = transparents.count, .depth = 0, .draw_order = 0}};
  if (order == Order::kArtist)
    std::ranges::stable_sort(groups, {}, &CardGroup::draw_order);
  else
    std::ranges::stable_sort(groups, std::ranges::greater(), &CardGroup::depth);
  std::vector<shared::OrderedGroup> ordered;
  uint32_t rank = uint32_t(groups.size());
  for (const CardGroup& group : groups) ordered.push_back({.first = group.first, .rank = --rank});
  std::ranges::sort(ordered, {}, &shared::OrderedGroup::first);
  return ordered;
}

class Sorted final : public Method {
 public:
  std::string_view id() const override { return "sorted"; }
  Traits traits() const override {
    return {.title = "Sorted alpha blending",
            .source = "the baseline of Drobot 2025 (\"No OIT\")",
            .transmission = "RGB, by dual-source blending",
            .emission = "exact",
            .limits =
                "interpenetrating cards are ordered by their centres, interleaved emitters only by gpu_all; "
                "16-bit blending rounds at every layer",
            .street_rmse = 0.002};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.choice("order", order_, kOrderNames,
                   "who sorts what: the coarser the cheaper, and the more is wrong where emitters mix");
  }

  Needs needs(glm::uvec2, const Transparents& transparents) const override {
    Needs needs;
    card_sort::add_needs(needs, transparents);
    needs.buffers.push_back(
        {.name = "groups",
         .bytes = std::max<uint64_t>(transparents.groups.size(), 1) * sizeof(shared::OrderedGroup),
         .clear = {}});
    return needs;
  }

  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  void record(const Picture& picture) override {
    const Transparents& transparents = picture.transparents;
    picture.frame.pass("sort", [&](gpu::Pass& pass) { record_order(pass, picture); });
    const auto draw = [&](const char* pass_name, const gpu::Image& target, Transparents::Style style) {
      style.targets = {{.image = &target, .blend = gpu::Blend::kOverDual, .clear = {}}};
      style.depth_test = style.opaque_depth = &picture.opaque_depth;
      style.area = picture.area();
      style.order = &picture.resources.buffer("order");
      style.backwards = true;
      picture.frame.pass(pass_name, [&](gpu::Pass& pass) {
        if (&target != &picture.result) pass.clear(target, {0, 0, 0, 0});
        pass.barrier();
        transparents.draw(pass, style);
      });
    };
    picture.frame.pass("copy", [&](gpu::Pass& pass) { pass.copy(picture.opaque_color, picture.result); });
    draw("draw", picture.result,
         {.fragment = "methods/sorted/draw.frag",
          .targets = {},
          .constants = {},
          .bindings = {},
          .count_fragments = true});
    if (picture.distortion)
      draw("distortion", *picture.distortion,
           {.fragment = "methods/sorted/distortion.frag",
            .targets = {},
            .vertex = "surface/haze.vert",
            .constants = {},
            .bindings = {}});
    if (picture.surface)
      draw("surface", *picture.surface,
           {.fragment = "methods/sorted/surface.frag", .targets = {}, .constants = {}, .bindings = {}});
  }

  nlohmann::json statistics(gpu::Device&, const Resources&) const override { return {{"groups", groups_}}; }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_by_drawing(picture, probe, InFront::kByCenter);
  }

 private:
  void record_order(gpu::Pass& pass, const Picture& picture) {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    const Transparents& transparents = picture.transparents;
    const auto order = Order(order_);
    groups_ = std::max<size_t>(transparents.groups.size(), 1);
    if (order == Order::kGpuAll) {
      card_sort::record_order(pass, picture);
      return;
    }
    pass.update(*buffer("groups"),
                std::span<const shared::OrderedGroup>(ordered_groups(transparents, order)));
    pass.barrier();
    const bool by_depth = order == Order::kGpuEmitter;
    const auto rank_bits = uint32_t(std::bit_width(groups_ - 1));
    gpu::Bindings bindings = transparents.seen();
    bindings.insert(bindings.end(), {{"Pairs", buffer("pairs")}, {"Groups", buffer("groups")}});
    pass.dispatch(pass.pipelines().compute("methods/sorted/group_keys.comp", {by_depth ? 1u : 0u}), bindings,
                  glm::uvec2(uint32_t(groups_), rank_bits), transparents.each_seen());
    pass.barrier();
    card_sort::record_pairs(pass, picture, by_depth ? 32 : std::max(rank_bits, 1u));
  }

  int order_ = int(Order::kGpuAll);
  size_t groups_ = 1;  // of the last frame
};

}  // namespace

std::unique_ptr<Method> make_sorted() {
  return std::make_unique<Sorted>();
}

}  // namespace plume
