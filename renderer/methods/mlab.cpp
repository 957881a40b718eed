// Multi-layer alpha blending. Salvi and Vaidyanathan, "Multi-Layer Alpha Blending", I3D 2014: k nodes a
// pixel, sorted by depth, each a layer of premultiplied light and transmittance. A fragment is inserted, and
// of k + 1 nodes the two farthest are blended into one,
//
//   L = L_front + t_front L_behind,   t = t_front t_behind,   z = z_front.
//
// The transmittance does not depend on the order in which fragments come: the nearest k - 1 stay apart and
// the last node's product is that of all the rest. Its light does: what comes late is blended behind the
// whole of what is merged, wherever it lies, and what comes early in front of it. So the draw's order is a
// parameter. Sorted farthest first, two nodes are enough for cards that do not cross, and k nodes set right
// what is out of place by fewer than k; sorted nearest first, what comes late stays behind the last node.
//
// The paper leaves open in which order fragments of equal depth lie (here: cards') and what a light without
// coverage is (here: a layer like any other, of transmittance 1). It stores 8 bits a channel, here 32.
//
// Limits: beyond k layers what lies in the last node is blended in the order of the draw.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/card_sort.h"
#include "renderer/methods/parts/pixel_nodes.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kOrders[] = {"cards", "front_to_back", "back_to_front", "submission"};
enum Order { kCards, kFrontToBack, kBackToFront, kSubmission };

constexpr pixel_nodes::Kind kKind{};

class Mlab final : public Method {
 public:
  std::string_view id() const override { return "mlab"; }
  Traits traits() const override {
    return {.title = "Multi-layer alpha blending",
            .source = "Salvi and Vaidyanathan, I3D 2014",
            .transmission = "RGB",
            .emission = "a layer of its own; in the merged layer as its light",
            .limits =
                "beyond k layers the farthest are blended in the order of the draw, which a spin lock on a "
                "parallel device does not keep",
            .street_rmse = 0.033};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    return pixel_nodes::missing(device, lock());
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.integer(
        "nodes", nodes_,
        {.min = 1,
         .max = 64,
         .unit = "layers",
         .help = "layers a pixel before the farthest merge: 32 bytes and a step of the search each"});
    visitor.choice("order", order_, kOrders,
                   "in which order cards come: as they are in their buffer, sorted by their centres, or as "
                   "submitted, which the picture then depends on");
    visitor.choice("lock", lock_, pixel_nodes::kLocks,
                   "how fragments of one pixel take turns; only the interlock keeps the draw's order on a "
                   "parallel device");
  }

  Needs needs(glm::uvec2 size, const Transparents& transparents) const override {
    Needs needs;
    pixel_nodes::add_needs(needs, size, uint32_t(nodes_), kKind);
    if (sorts()) card_sort::add_needs(needs, transparents);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    if (sorts())
      card_sort::record(picture, order_ == kCards ? card_sort::Key::kCard : card_sort::Key::kDepth);
    picture.frame.pass("insert", [&](gpu::Pass& pass) {
      pixel_nodes::reset(pass, resources, kKind);
      pass.barrier();
      pixel_nodes::draw(pass, picture, uint32_t(nodes_),
                        {.fragment = pixel_nodes::insert_shader("methods/mlab", lock()),
                         .targets = {},
                         .constants = {},
                         .bindings = {},
                         .order = sorts() ? &resources.buffer("order") : nullptr,
                         .backwards = order_ == kBackToFront});
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      gpu::Bindings bindings = pixel_nodes::bindings(resources);
      bindings.push_back({"opaque_color", &picture.opaque_color});
      bindings.push_back({"result", &picture.result});
      pass.dispatch(pass.pipelines().compute("methods/mlab/resolve.comp", {uint32_t(nodes_)}), bindings,
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  /// What a light that came last would be given.
  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/mlab/probe.comp", {uint32_t(nodes_)},
               pixel_nodes::bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const shared::NodeOverflow overflow = pixel_nodes::overflow(device, resources);
    return {{"merged_fragments", overflow.fragments}, {"pixels_with_merges", overflow.pixels}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "merged_fragments",
         .what = "Fragments that found no layer free and were merged into the farthest",
         .remedy = "Raise `nodes`"}};
    return kShortfalls;
  }

 private:
  bool sorts() const { return order_ != kSubmission; }
  pixel_nodes::Lock lock() const { return pixel_nodes::Lock(lock_); }

  int nodes_ = 8, order_ = kCards, lock_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_mlab() {
  return std::make_unique<Mlab>();
}

}  // namespace plume
