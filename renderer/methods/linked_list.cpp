// Per-pixel linked lists in a pool of fixed size. Yang et al., "Real-Time Concurrent Linked List Construction
// on the GPU", EGSR 2010: each fragment takes the next node of one pool and joins its pixel's list; each list
// is sorted by (depth, card) and composited front to back,
//   image = sum_i L_i prod_{j<i} t_j + background prod_i t_i.
//
// The paper leaves open what becomes of fragments when the pool is full. Here they are counted, and blend
// into one tail a pixel, as in hybrid transparency (Maule et al., I3D 2013): their average weighted by what
// they cover, seen through everything that was kept. What the pixel lets through stays right.
//
// Limits: exact while the pool has room. Beyond, the order of arrival decides which fragments find a place,
// in the whole picture: what comes last falls behind everything, even where it is nearest, and a device that
// draws in tiles leaves whole tiles without a place. Hybrid transparency keeps the nearest instead. A node
// takes 36 bytes, so that nothing is rounded.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/fragment_list.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr Weighted kTail{.each_channel = true};

class LinkedList final : public Method {
 public:
  std::string_view id() const override { return "linked_list"; }
  Traits traits() const override {
    return {.title = "Linked lists",
            .source = "Yang et al., EGSR 2010, per-pixel lists; what overflows: Maule et al., I3D 2013, tail",
            .transmission = "RGB, exact; in the tail, RGB and exact in all",
            .emission = "exact; in the tail, in its average where covered, added where not",
            .limits =
                "memory for the fragments of a picture must be guessed: what comes after the pool is "
                "full falls behind the rest",
            .exact = true};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.integer("fragments", fragments_,
                    {.min = 1,
                     .max = 256,
                     .unit = "a pixel",
                     .help = "room in the pool for so many fragments a pixel on average, at 36 bytes each"});
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    fragment_list::add_needs(needs, size, capacity(size));
    kTail.add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    picture.frame.pass("capture", [&](gpu::Pass& pass) {
      fragment_list::reset(pass, resources, capacity(picture.size));
      pass.barrier();
      picture.transparents.draw(pass, {.fragment = "methods/linked_list/capture.frag",
                                       .targets = kTail.targets(resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = {},
                                       .bindings = fragment_list::bindings(resources)});
    });
    kTail.record_resolve(picture);  // the tails over what is opaque: what the lists are blended over
    fragment_list::record_composite(picture, picture.result, false);
  }

  /// What was kept in front. A depth behind all of it may lie in the tail, which has no depth.
  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/parts/fragment_list/probe.comp", {},
               fragment_list::bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const shared::FragmentPool pool = fragment_list::pool(device, resources);
    return {{"fragments", pool.count},
            {"capacity", pool.capacity},
            {"fragments_in_tail", pool.count - std::min(pool.count, pool.capacity)}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "fragments_in_tail",
         .what = "Fragments that found the pool full and are averaged behind the rest, without their order",
         .remedy = "Raise `fragments`"}};
    return kShortfalls;
  }

 private:
  /// Nodes are numbered in 32 bits.
  uint32_t capacity(glm::uvec2 size) const {
    return uint32_t(std::min<uint64_t>(uint64_t(size.x) * size.y * uint64_t(fragments_), shared::kListEnd));
  }

  int fragments_ = 16;
};

}  // namespace

std::unique_ptr<Method> make_linked_list() {
  return std::make_unique<LinkedList>();
}

}  // namespace plume
