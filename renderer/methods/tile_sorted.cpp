// Tile-sorted compute, as renderers of Gaussian splats do it (Kerbl et al., "3D Gaussian Splatting for
// Real-Time Radiance Field Rendering", SIGGRAPH 2023, section 6): all cards are sorted once by depth and
// listed, in that order, by the screen tiles that they touch; then every pixel walks its tile's list front to
// back, shades, composites in registers and stops when nothing behind can matter.
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i
// It differs from the paper in that it stops by what can still come instead of by a threshold of T (what
// shines here may be thousands bright), in that transmittance is RGB, in that lists come from bit masks
// instead of a sort of (tile, card) pairs, and in what it does with cards that have no single depth: a tilted
// card's fragments are captured in per-pixel linked lists and join at their own depths.
// Limits: a pixel whose centre lies on a card's edge to within rounding may fall to the other side of it than
// in a draw, and filters weigh texels in steps that rounding decides: noise of some 1e-3 of the brightest
// light.
#include "shaders/methods/tile_sorted/tile_sorted.h"

#include <cstddef>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/fragment_list.h"
#include "renderer/probe.h"
#include "renderer/radix_sort.h"
#include "shaders/shared/draw_command.h"

namespace plume {
namespace {

using shared::TileGrid;
using shared::TileTotals;

constexpr std::array<std::string_view, 3> kTileNames = {"16", "32", "64"};
constexpr uint64_t kLongestBinding = 1u << 27;  // bytes a shader may bind at once on every device

struct Grid : TileGrid {
  uint32_t tile;         ///< pixels, each way
  uint32_t count_words;  ///< of the counts: whole rounds of the prefix sum

  Grid(uint32_t tile_pixels, glm::uvec2 size, uint32_t card_count) : tile(tile_pixels) {
    cards = card_count;
    words = std::max(gpu::groups(cards, 32), 1u);
    spans = gpu::groups(words, shared::kMaskSpan);
    // Masks of very many cards are for larger tiles: a list is then longer, and what it holds is the same.
    while (tiles = {gpu::groups(size.x, tile), gpu::groups(size.y, tile)}, mask_bytes() > kLongestBinding)
      tile *= 2;
    count_words = gpu::groups(uint64_t(number()) * spans + 1, shared::kRadixDigits) * shared::kRadixDigits;
  }
  uint32_t number() const { return tiles.x * tiles.y; }
  uint64_t mask_bytes() const { return uint64_t(number()) * words * 4; }
};

/// Work groups of 64 in two dimensions, for more of them than one may have.
std::array<uint32_t, 3> many_groups(uint64_t threads) {
  const uint32_t all = gpu::groups(threads, 64), across = std::min(all, 32768u);
  return {across, gpu::groups(all, across), 1};
}

class TileSorted final : public Method {
 public:
  std::string_view id() const override { return "tile_sorted"; }
  Traits traits() const override {
    return {
        .title = "Tile-sorted compute",
        .source = "Kerbl et al. 2023, 3D Gaussian Splatting, section 6",
        .transmission = "RGB, exact",
        .emission = "exact",
        .limits =
            "tilted cards take the road of linked lists; no haze or surface outputs; texture filters round "
            "otherwise than in a draw, and so do depths, which the order of cards in one plane hangs on",
        .exact = true,
        .rounding = 8e-3};
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.choice("tile", tile_, kTileNames,
                   "pixels across a tile: small ones have short lists, large ones are quicker to fill");
    visitor.number("stop_below", stop_below_,
                   {.min = 0,
                    .max = 1,
                    .unit = "radiance as exposed",
                    .help = "a pixel is finished when nothing behind can add this much: larger is faster and "
                            "loses faint light, 0 never stops"});
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    const auto properties =
        device.physical()
            .getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>();
    const auto& subgroup = properties.get<vk::PhysicalDeviceSubgroupProperties>();
    using Feature = vk::SubgroupFeatureFlagBits;
    constexpr auto kNeeded = Feature::eBasic | Feature::eVote | Feature::eArithmetic | Feature::eBallot;
    if ((subgroup.supportedOperations & kNeeded) == kNeeded && subgroup.subgroupSize <= 32) return {};
    return {"subgroup vote, arithmetic and ballot in groups of at most 32"};
  }

  Needs needs(glm::uvec2 size, const Transparents& transparents) const override {
    const Grid grid = grid_of(size, transparents);
    const uint64_t count = std::max(transparents.count, 1u);
    const glm::uvec2 squares = squares_of(size);
    Needs needs{
        .images = {},
        .buffers = {{.name = "pairs", .bytes = count * 8, .clear = {}},
                    {.name = "scratch", .bytes = count * 8, .clear = {}},
                    {.name = "radix_counts", .bytes = radix_counts_bytes(transparents.count), .clear = {}},
                    {.name = "bounds", .bytes = uint64_t(bound_spans(grid.cards)) * 8, .clear = {}},
                    {.name = "tile_cards", .bytes = count * sizeof(shared::TileCard), .clear = {}},
                    {.name = "masks", .bytes = grid.mask_bytes(), .clear = 0},
                    {.name = "counts", .bytes = uint64_t(grid.count_words) * 4, .clear = {}},
                    {.name = "scan_work", .bytes = sizeof(shared::Workload), .clear = {}},
                    {.name = "entries", .bytes = uint64_t(capacity_) * 4, .clear = {}},
                    {.name = "squares",
                     .bytes = sizeof(shared::WalkSquares) + uint64_t(squares.x) * squares.y * 2 * 4,
                     .clear = {}},
                    {.name = "totals", .bytes = sizeof(TileTotals), .clear = {}},
                    {.name = "tilted_order", .bytes = count * 4, .clear = {}},
                    {.name = "tilted_draw", .bytes = sizeof(shared::DrawCommand), .clear = {}}}};
    fragment_list::add_needs(needs, size, tilted_capacity_);
    return needs;
  }

  void record(const Picture& picture) override {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    const Transparents& transparents = picture.transparents;
    const Grid grid = grid_of(picture.size, transparents);

    picture.frame.pass("sort", [&](gpu::Pass& pass) {
      pass.update(*buffer("totals"), TileTotals{.cards = 0,
                                                .tilted = 0,
                                                .entries = 0,
                                                .capacity = capacity_,
                                                .address = buffer("entries")->address_words(),
                                                .stopped_pixels = 0});
      pass.update(*buffer("tilted_draw"),
                  shared::DrawCommand{.vertices = 4, .instances = 0, .first_vertex = 0, .first_instance = 0});
      fragment_list::reset(pass, picture.resources, tilted_capacity_);
      pass.barrier();
      gpu::Bindings bindings = transparents.seen();
      bindings.insert(bindings.end(), {{"Pairs", buffer("pairs")},
                                       {"Totals", buffer("totals")},
                                       {"TiltedDraw", buffer("tilted_draw")},
                                       {"TiltedOrder", buffer("tilted_order")}});
      pass.dispatch(pass.pipelines().compute("methods/tile_sorted/keys.comp"), bindings, 0u,
                    transparents.each_seen());
      pass.barrier();
      radix_sort(pass, *buffer("pairs"), *buffer("scratch"), *buffer("radix_counts"), *transparents.work);
    });
    picture.frame.pass("tiles", [&](gpu::Pass& pass) {
      record_placing(pass, picture, grid);
      record_lists(pass, picture, grid);
    });
    if (tilted_)
      picture.frame.pass("capture", [&](gpu::Pass& pass) {
        transparents.draw(pass, {.fragment = "methods/reference/capture.frag",
                                 .targets = {},
                                 .depth_test = &picture.opaque_depth,
                                 .opaque_depth = &picture.opaque_depth,
                                 .area = picture.area(),
                                 .constants = {0u},
                                 .bindings = fragment_list::bindings(picture.resources),
                                 .order = buffer("tilted_order"),
                                 .indirect = buffer("tilted_draw")});
      });
    picture.frame.pass("walk", [&](gpu::Pass& pass) { record_walk(pass, picture, grid); });
    drawn_tile_ = grid.tile;
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    const Grid grid = grid_of(picture.size, picture.transparents);
    probe_with(picture, probe, "methods/tile_sorted/probe.comp",
               {grid.tile, tilted_ ? 1u : 0u, grid.tiles.x, grid.spans}, walk_bindings(picture));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const TileTotals totals = gpu::read<TileTotals>(device, resources.buffer("totals"))[0];
    return {{"tile_pixels", drawn_tile_},
            {"cards_in_tiles", totals.cards},
            {"list_entries", totals.entries},
            {"tilted_cards", totals.tilted},
            {"tilted_fragments", fragment_list::pool(device, resources).count},
            {"stopped_pixels", totals.stopped_pixels}};
  }

  bool must_redraw(gpu::Device& device, const Resources& resources) override {
    const TileTotals totals = gpu::read<TileTotals>(device, resources.buffer("totals"))[0];
    const bool drew_tilted = std::exchange(tilted_, totals.tilted > 0);
    bool again = tilted_ && !drew_tilted;  // costs one frame, once: without them pixels have no lists to sort
    const auto grow = [&](uint32_t& capacity, uint32_t needed) {
      if (needed <= capacity) return;
      capacity = needed + needed / 8;  // room for the next frame of a growing effect
      again = true;
    };
    grow(capacity_, totals.entries);
    if (drew_tilted) grow(tilted_capacity_, fragment_list::pool(device, resources).count);
    return again;
  }

 private:
  Grid grid_of(glm::uvec2 size, const Transparents& transparents) const {
    return Grid(shared::kWalkSquare << tile_, size, transparents.count);
  }
  static glm::uvec2 squares_of(glm::uvec2 size) {
    return {gpu::groups(size.x, shared::kWalkSquare), gpu::groups(size.y, shared::kWalkSquare)};
  }
  static uint32_t bound_spans(uint32_t cards) { return std::max(gpu::groups(cards, shared::kBoundSpan), 1u); }

  /// Cards onto the screen, and their bits into the tiles' masks.
  static void record_placing(gpu::Pass& pass, const Picture& picture, const Grid& grid) {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    const Transparents& transparents = picture.transparents;
    const gpu::Binding work{"Work", transparents.work}, bounds{"Bounds", buffer("bounds")};
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/bounds.comp"),
                  {{"Cards", transparents.cards}, {"Pairs", buffer("pairs")}, bounds, work}, 0u,
                  {gpu::groups(bound_spans(grid.cards), 64), 1, 1});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/bounds_behind.comp"), {bounds, work}, 0u,
                  {1, 1, 1});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/place.comp", {grid.tile}),
                  {{"View", transparents.view},
                   {"Cards", transparents.cards},
                   {"Pairs", buffer("pairs")},
                   bounds,
                   work,
                   {"TileCards", buffer("tile_cards")},
                   {"Masks", buffer("masks")}},
                  TileGrid(grid), transparents.each_seen());
    pass.barrier();
  }

  /// Masks to lists.
  static void record_lists(gpu::Pass& pass, const Picture& picture, const Grid& grid) {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    struct CountPush {
      TileGrid grid;
      uint32_t padded;
    };
    pass.update(
        *buffer("scan_work"),
        shared::Workload{
            .count = 0, .groups = {0, 1, 1}, .tiles = {grid.count_words / shared::kRadixDigits, 1, 1}});
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/count.comp"),
                  {{"Masks", buffer("masks")}, {"Counts", buffer("counts")}},
                  CountPush{.grid = grid, .padded = grid.count_words}, many_groups(grid.count_words));
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("sort/scan.comp"),
                  {{"Counts", buffer("counts")}, {"Work", buffer("scan_work")}}, 0u, {1, 1, 1});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/fill.comp"),
                  {{"Totals", buffer("totals")}, {"Counts", buffer("counts")}, {"Masks", buffer("masks")}},
                  TileGrid(grid), many_groups(uint64_t(grid.number()) * grid.spans));
  }

  /// One pass over the picture; with tilted cards two, of the squares without and of those with their
  /// fragments.
  void record_walk(gpu::Pass& pass, const Picture& picture, const Grid& grid) const {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    gpu::Bindings bindings = walk_bindings(picture);
    bindings.insert(bindings.end(), {{"View", picture.transparents.view},
                                     {"Squares", buffer("squares")},
                                     {"opaque_color", &picture.opaque_color},
                                     {"result", &picture.result}});
    struct Push {
      TileGrid grid;
      float stop_below;
    };
    const Push push{.grid = grid, .stop_below = stop_below_};
    const glm::uvec2 squares = squares_of(picture.size);
    const uint32_t number = squares.x * squares.y;
    const auto walk = [&](bool tilted, bool listed) -> const gpu::Pipeline& {
      return pass.pipelines().compute("methods/tile_sorted/walk.comp",
                                      {grid.tile, tilted ? 1u : 0u, listed ? 1u : 0u});
    };
    constexpr uint32_t kMostGroups = 65535;  // of an indirect dispatch, on every device
    if (!tilted_ || number > kMostGroups) {
      pass.dispatch(walk(tilted_, false), bindings, push, {squares.x, squares.y, 1});
      return;
    }
    pass.update(*buffer("squares"), shared::WalkSquares{.groups = {{0, 1, 1}, {0, 1, 1}}, .number = number});
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("methods/tile_sorted/classify.comp"),
                  {{"Heads", buffer("heads")}, {"Squares", buffer("squares")}}, picture.size,
                  {squares.x, squares.y, 1});
    pass.barrier();
    for (const bool tilted : {false, true}) {
      pass.dispatch(walk(tilted, true), bindings, push, {0, 1, 1});  // binds; the device knows how many
      pass.commands().dispatchIndirect(buffer("squares")->vk(), offsetof(shared::WalkSquares, groups) +
                                                                    (tilted ? 3 : 0) * sizeof(uint32_t));
    }
  }

  static gpu::Bindings walk_bindings(const Picture& picture) {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    gpu::Bindings bindings = fragment_list::bindings(picture.resources);
    bindings.insert(bindings.end(), {{"puffs", picture.transparents.puffs},
                                     {"opaque_depth", &picture.opaque_depth},
                                     {"TileCards", buffer("tile_cards")},
                                     {"Totals", buffer("totals")},
                                     {"Counts", buffer("counts")}});
    return bindings;
  }

  int tile_ = 0;
  float stop_below_ = 1e-4f;
  uint32_t capacity_ = 1u << 12, tilted_capacity_ = 1u << 10;
  bool tilted_ = false;  ///< there are fragments of tilted cards to capture and to join
  uint32_t drawn_tile_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_tile_sorted() {
  return std::make_unique<TileSorted>();
}

}  // namespace plume
