// The zero-transmittance depth: exact from the zero slices, the same as quads and as a full-screen write, and
// such that what is left out is not missed.
#include <algorithm>

#include "shaders/methods/avboit/zero_tile.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

class AvboitZeroDepth : public AvboitTest {
 protected:
  Random random{1};

  /// Slices a fragment may lie behind the zero slice of its tile and still be drawn.
  static std::vector<float> tile_depths(const shared::Volume& v, const Warp& warp,
                                        const std::vector<uint32_t>& zero_slice, glm::uvec2 size,
                                        float near_m) {
    const glm::uvec2 tiles = (size + shared::kZeroTilePixels - 1u) / shared::kZeroTilePixels;
    const int each = int(shared::kZeroTilePixels / v.divisor);
    std::vector<float> depths;
    for (int ty = 0; ty < int(tiles.y); ++ty)
      for (int tx = 0; tx < int(tiles.x); ++tx) {
        uint32_t slice = 0;
        // Cells whose centres bilinear filtering reads for any pixel of the tile.
        for (int y = ty * each - 1; y <= (ty + 1) * each; ++y)
          for (int x = tx * each - 1; x <= (tx + 1) * each; ++x)
            if (x >= 0 && y >= 0 && x < int(v.cells.x) && y < int(v.cells.y))
              slice = std::max(slice, zero_slice[uint32_t(y) * v.cells.x + uint32_t(x)]);
        const uint64_t guarded = uint64_t(slice) + v.zero_guard;
        depths.push_back(slice == shared::kNoSlice || guarded >= warp.head.used
                             ? 0.0f
                             : near_m / warp.slice_ends[guarded]);
      }
    return depths;
  }

  /// Thick smoke before thin, in patches, before a wall.
  void add_smoke() {
    Solid wall;
    wall.position = {4, 0, -14};
    wall.size_m = {10, 8, 1};
    scene.solids = {wall};
    for (int i = 0; i < 160; ++i)
      add({.z = float(random.octaves(4, 16)),
           .optical_depth = float(random.octaves(0.2, 3)),
           .transmission = i % 20 == 0 ? glm::vec3(0.9f, 0.2f, 0.4f) : glm::vec3(0.0f),
           .half_size = {random.octaves(0.5, 4), random.octaves(0.5, 4)},
           .at = {random.f(-8, 1), random.f(-4, 4)}});
  }
};

TEST_F(AvboitZeroDepth, IsTheEndOfTheFarthestZeroSliceThatATileReads) {
  for (const uint32_t divisor : {2u, 4u, 8u}) {
    const glm::uvec2 picture{150, 70},
        cells = (picture + divisor - 1u) / divisor,
        tiles = (picture + shared::kZeroTilePixels - 1u) / shared::kZeroTilePixels;
    shared::Volume v{.cells = cells, .divisor = divisor, .slices = 64, .zero_guard = 1 + random.below(3)};
    size = picture;
    Warp warp{.head = {.virtual_slices = 1024, .used = 60, .scale = 1, .apart_dropped = 0},
              .slice_ends = {},
              .nodes = {}};
    std::vector<uint32_t> words(4 + shared::kMostSlices);
    std::memcpy(words.data(), &warp.head, 16);
    for (uint32_t s = 0; s < 60; ++s) {
      warp.slice_ends.push_back(0.3f + 0.37f * float(s));
      std::memcpy(&words[4 + s], &warp.slice_ends[s], 4);
    }
    std::vector<uint32_t> zero(cells.x * cells.y);
    const uint32_t mostly = divisor == 8 ? 30 : 300;
    for (uint32_t& slice : zero)
      slice = random.one_in(mostly) ? shared::kNoSlice : random.below(random.one_in(50) ? 64 : 20);
    const uint32_t count = tiles.x * tiles.y;
    const shared::DrawCommand draw{.vertices = 6, .instances = 0, .first_vertex = 0, .first_instance = 0};
    const gpu::Buffer eye = upload("view", std::vector{view()}), block = upload("volume", std::vector{v}),
                      table = upload("warp", words), in = upload("zero_slice", zero),
                      arguments = upload("zero_draw", std::vector{draw}),
                      list = upload("zero_tiles", std::vector<shared::ZeroTile>(count)),
                      out = upload("zero_depths", std::vector<float>(count, -1.0f));
    dispatch("methods/avboit/zero_depth.comp", {},
             {{"View", &eye},
              {"VolumeBlock", &block},
              {"WarpTable", &table},
              {"ZeroSlice", &in},
              {"ZeroArguments", &arguments},
              {"ZeroTiles", &list},
              {"ZeroDepths", &out}},
             tiles, {gpu::groups(count, 64), 1, 1});
    const auto expected = tile_depths(v, warp, zero, picture, view().near_m);
    const auto depths = gpu::read<float>(device, out);
    const auto drawn = gpu::read<shared::DrawCommand>(device, arguments)[0];
    const auto quads = gpu::read<shared::ZeroTile>(device, list);
    uint32_t with_one = 0;
    for (uint32_t i = 0; i < count; ++i) {
      ASSERT_FLOAT_EQ(expected[i], depths[i]) << "tile " << i << " divisor " << divisor;
      with_one += expected[i] > 0;
    }
    ASSERT_GT(with_one, 5u);
    ASSERT_LT(with_one, count);
    ASSERT_EQ(with_one, drawn.instances) << "one quad a tile that has a depth";
    std::vector<bool> listed(count);
    for (uint32_t k = 0; k < drawn.instances; ++k) {
      const uint32_t i = quads[k].tile.y * tiles.x + quads[k].tile.x;
      ASSERT_FALSE(listed[i]) << "listed twice";
      listed[i] = true;
      ASSERT_EQ(depths[i], quads[k].depth);
    }
  }
}

TEST_F(AvboitZeroDepth, ZeroSlicesAreWhereTheWordsSumToZeroTransmittance) {
  size = {96, 64};
  add_smoke();
  rgb.clear();
  avboit::Settings settings;
  settings.exact_layers = 0;
  const Stages s = run_stages(settings, Until::kZeroDepth);
  const auto words = s.words("extinction"), overflow = s.words("overflow"), zero = s.words("zero_slice"),
             occupancy = s.words("occupancy");
  const uint32_t used = s.warp().head.used;
  size_t found = 0;
  for (uint32_t ray = 0; ray < s.plan.rays(); ++ray) {
    const glm::uvec2 tile =
        glm::uvec2(ray % s.volume().cells.x, ray / s.volume().cells.x) / shared::kTileCells;
    double tau = 0;
    uint32_t expected = shared::kNoSlice;
    for (uint32_t slice = 0; slice < used && expected == shared::kNoSlice; ++slice) {
      const uint32_t at = (tile.y * s.volume().tiles.x + tile.x) * shared::kMaskWords + slice / 32;
      if (!(occupancy[at] >> slice % 32 & 1)) continue;
      tau += (words[ray * s.volume().slices / 2 + slice / 2] >> 16 * (slice % 2) & 0xffff) * 16.0 / 65535;
      if (tau >= std::log(1024.0) || slice >= overflow[ray]) expected = slice;
    }
    ASSERT_EQ(expected, zero[ray]) << "ray " << ray;
    found += expected != shared::kNoSlice;
  }
  EXPECT_GT(found, 20u);
}

TEST_F(AvboitZeroDepth, TileQuadsWriteWhatAFullScreenWriteDoes) {
  for (const glm::uvec2 odd : {glm::uvec2(96, 64), glm::uvec2(101, 59)}) {
    size = odd;
    clear_cards();
    add_smoke();
    avboit::Settings settings;
    settings.zero_depth = avboit::ZeroDepth::kQuads;
    settings.small_cells = 0;  // what the exact layers keep hides nothing from these depths
    Stages quads = run_stages(settings, Until::kZeroDepth);
    settings.zero_depth = avboit::ZeroDepth::kFullscreen;
    Stages fullscreen = run_stages(settings, Until::kZeroDepth);
    const auto a = gpu::read<float>(device, quads.resources.image("visible_depth")),
               b = gpu::read<float>(device, fullscreen.resources.image("visible_depth")),
               opaque = gpu::read<float>(device, quads.world->targets.opaque_depth),
               tiles = gpu::read<float>(device, quads.resources.buffer("zero_depths"));
    size_t nearer = 0;
    for (uint32_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(a[i], b[i]) << "pixel " << i;
      const uint32_t across = (size.x + 15) / 16;
      ASSERT_EQ(a[i], std::max(opaque[i], tiles[i / size.x / 16 * across + i % size.x / 16]))
          << "pixel " << i;
      nearer += a[i] > opaque[i];
    }
    EXPECT_GT(nearer, 500u);
    EXPECT_LT(nearer, a.size());
  }
}

class AvboitCulling : public GpuTest {
 protected:
  struct Drawn {
    DrawnPicture picture;
    uint64_t fragments = 0;
  };
  Drawn drawn(Stage& stage, const Targets& targets, const std::map<std::string, std::string>& settings) {
    MethodInstance method = instance("avboit", settings);
    Drawn result;
    for (const gpu::PassTime& pass :
         render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method).passes)
      if (pass.name == "draw") result.fragments = pass.fragments.value();
    result.picture = read_picture(device, targets);
    return result;
  }
};

TEST_F(AvboitCulling, DrawsLessAndLeavesOutNothingThatIsSeen) {
  struct Case {
    const char* scene;
    glm::uvec2 size;
    double least_saved;
  };
  // At 320 x 180 a tile reads 32 pixels across: of the grenade's bank, which is 90 wide, little is left; and
  // smaller cards are in the exact layers, which hide nothing from the zero depth.
  for (const auto& [name, size, least_saved] :
       {Case{"grenade", {320, 180}, 0.015}, Case{"grenade", {640, 360}, 0.11},
        Case{"closeup", {320, 180}, 0.11}, Case{"street", {640, 360}, 0.04}}) {
    SCOPED_TRACE(name);
    Stage stage(device, pipelines, library, library.scene(name));
    const Targets targets(device, size);
    stage.go_to(stage.scene().default_tick, size);
    const Drawn off = drawn(stage, targets, {{"zero_depth", "off"}});
    for (const char* cull_opaque : {"false", "true"}) {
      const Drawn on = drawn(stage, targets, {{"zero_depth", "quads"}, {"cull_opaque", cull_opaque}});
      int worst = 0;
      for (size_t i = 0; i < off.picture.display.pixels.size(); ++i)
        for (size_t c = 0; c < 3; ++c)
          worst = std::max(
              worst, std::abs(int(off.picture.display.pixels[i][c]) - int(on.picture.display.pixels[i][c])));
      EXPECT_LE(worst, 1) << "cull_opaque " << cull_opaque;
      const double saved = 1 - double(on.fragments) / double(off.fragments);
      EXPECT_GE(saved, least_saved);
      RecordProperty(std::string(name) + std::to_string(size.x) + "_fragments_saved", std::to_string(saved));
    }
  }
}

}  // namespace
}  // namespace plume
