// Views: each number that can be looked at, against the reference's own fragments or what the method is known
// to have done.
#include <algorithm>
#include <bit>

#include "tests/gpu/avboit_scene.h"
#include "tests/gpu/fragment_lists.h"

namespace plume {
namespace {

using Map = std::map<std::string, std::string>;

class InspectTest : public AvboitTest {
 protected:
  Random random{1};

  struct Seen {
    std::unique_ptr<World> world;
    MethodInstance method;
    FrameReport report;
    std::vector<float> values;

    double sum() const {
      return std::accumulate(values.begin(), values.end(), 0.0,
                             [](double all, float v) { return std::isnan(v) ? all : all + double(v); });
    }
  };
  Seen see(std::string_view id, const std::string& view, const Map& settings = {}, uint32_t slice = 0) {
    Seen seen{.world = world(), .method = instance(id, settings), .report = {}, .values = {}};
    const Glance glance(device, size, view, slice);
    seen.report = render_frame(device, pipelines, seen.world->targets, seen.world->prelude(),
                               seen.world->transparents(), seen.method, nullptr, &glance);
    seen.values = glance.read_values(device);
    return seen;
  }
  std::vector<DepthSlice> slices_of(const Seen& seen) {
    return seen.method.method->depth_slices(device, seen.method.resources);
  }
  static uint64_t fragments_of(const FrameReport& report, std::string_view pass) {
    const auto found = std::ranges::find(report.passes, pass, &gpu::PassTime::name);
    return found == report.passes.end() ? 0 : found->fragments.value_or(0);
  }
  /// Of a depth along the ray, in slices.
  double place_of(const Seen& seen, double depth) {
    const auto volume = gpu::read<shared::Volume>(device, seen.method.resources.buffer("volume"))[0];
    return slice_at(volume, Warp::from(gpu::read<uint32_t>(device, seen.method.resources.buffer("warp"))),
                    depth);
  }
  float at(const Seen& seen, glm::uvec2 pixel) const { return seen.values[pixel.y * size.x + pixel.x]; }

  /// Smoke before and behind a wall, thick to the left, with coloured cards in it.
  void add_smoke(bool coloured = true) {
    Solid wall;
    wall.position = {4, 0, -14};
    wall.size_m = {10, 8, 1};
    scene.solids = {wall};
    for (int i = 0; i < 140; ++i)
      add({.z = float(random.octaves(4, 16)),
           .optical_depth = float(random.octaves(0.2, 3)),
           .transmission = coloured && i % 10 == 0 ? glm::vec3(0.9f, 0.2f, 0.4f) : glm::vec3(0.0f),
           .half_size = {random.octaves(0.5, 4), random.octaves(0.5, 4)},
           .at = {random.f(-8, 1), random.f(-4, 4)}});
  }
  /// Cards that cover the picture.
  void add_walls_of_smoke(const std::vector<float>& depths, float optical_depth) {
    for (const float z : depths) add({.z = z, .optical_depth = optical_depth, .half_size = {100, 100}});
  }
};

TEST_F(InspectTest, OverdrawIsTheLengthOfTheReferencesLists) {
  add_smoke();
  const Seen seen = see("reference", "overdraw");
  const FragmentLists lists(device, seen.method.resources);
  size_t longest = 0;
  for (size_t i = 0; i < seen.values.size(); ++i) {
    const size_t length = lists.of(i).size();
    longest = std::max(longest, length);
    ASSERT_EQ(length == 0, std::isnan(seen.values[i])) << "pixel " << i;
    ASSERT_EQ(float(length), length == 0 ? 0.0f : seen.values[i]) << "pixel " << i;
  }
  EXPECT_GT(longest, 20u);
  EXPECT_EQ(double(lists.count), seen.sum());
}

TEST_F(InspectTest, ShadedFragmentsAreThoseBeforeTheCullingDepth) {
  add_smoke();
  for (const float z : {3.6f, 3.8f})  // the left half hides what is behind it
    add({.z = z, .optical_depth = 5, .half_size = {2.5f, 10}, .at = {-2.5f, 0}});
  const FragmentLists lists(device, see("reference", "overdraw").method.resources);
  const Map in_the_volume{{"small_cells", "0"}};  // what is in the exact layers hides nothing
  const Seen shaded = see("avboit", "shaded", in_the_volume),
             culling = see("avboit", "culling_depth", in_the_volume);
  EXPECT_EQ(double(fragments_of(shaded.report, "draw")), shaded.sum()) << "as the device counted";
  EXPECT_LT(shaded.sum(), 0.9 * lists.count);
  for (size_t i = 0; i < shaded.values.size(); ++i) {
    const double end = std::isnan(culling.values[i]) ? 1e30 : double(culling.values[i]);
    int least = 0, most = 0;
    for (const shared::FragmentNode& f : lists.of(i)) {
      least += double(f.depth) < end * (1 - 1e-5);
      most += double(f.depth) < end * (1 + 1e-5);
    }
    const int number = std::isnan(shaded.values[i]) ? 0 : int(shaded.values[i]);
    ASSERT_GE(number, least) << "pixel " << i;
    ASSERT_LE(number, most) << "pixel " << i;
  }
}

TEST_F(InspectTest, WithoutCullingEveryFragmentIsShaded) {
  add_smoke();
  const Seen overdraw = see("avboit", "overdraw"), shaded = see("avboit", "shaded", {{"zero_depth", "off"}});
  for (size_t i = 0; i < shaded.values.size(); ++i)
    ASSERT_EQ(std::bit_cast<uint32_t>(overdraw.values[i]), std::bit_cast<uint32_t>(shaded.values[i]));
}

TEST_F(InspectTest, FragmentsAtLowerResolutionCountForTheirShare) {
  add_smoke(false);
  const Map apart{{"exact_layers", "0"}}, halved{{"exact_layers", "0"}, {"half_particles", "true"}};
  const Seen full = see("avboit", "shaded", apart), half = see("avboit", "shaded", halved);
  EXPECT_EQ(double(fragments_of(half.report, "draw")), half.sum());
  EXPECT_NEAR(half.sum(), 0.25 * full.sum(), 0.05 * full.sum());
  for (const char* particles : {"half", "quarter"}) {
    const Seen low = see("wboit", "shaded", {{"particles", particles}});
    EXPECT_EQ(double(fragments_of(low.report, "draw")), low.sum()) << particles;
  }
}

TEST_F(InspectTest, OccupancyCountsTheBitsOfATile) {
  size = {150, 90};
  add_smoke();
  const Seen seen = see("avboit", "occupancy");
  const auto words = gpu::read<uint32_t>(device, seen.method.resources.buffer("occupancy"));
  const auto volume = gpu::read<shared::Volume>(device, seen.method.resources.buffer("volume"))[0];
  const uint32_t used = uint32_t(slices_of(seen).size()), tiles = volume.tiles.x * volume.tiles.y;
  const auto bits = [&](uint32_t tile, uint32_t slice) {
    const auto bit = [&](uint32_t of) {
      return words[of * shared::kMaskWords + slice / 32] >> slice % 32 & 1u;
    };
    return bit(tile) | bit(tiles + tile) << 1;
  };
  uint32_t chosen = 0, most = 0;  // the slice in which most tiles have RGB sources
  for (uint32_t s = 0; s < used; ++s) {
    uint32_t number = 0;
    for (uint32_t tile = 0; tile < tiles; ++tile) number += bits(tile, s) >> 1;
    if (number > most) most = number, chosen = s;
  }
  const Seen one = see("avboit", "occupied", {}, chosen);
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x) {
      const glm::uvec2 at_tile = glm::uvec2(x, y) / (volume.divisor * shared::kTileCells);
      const uint32_t tile = at_tile.y * volume.tiles.x + at_tile.x;
      uint32_t expected = 0;
      for (uint32_t s = 0; s < used; ++s) expected += bits(tile, s) != 0;
      const float value = at(seen, {x, y}), of_slice = at(one, {x, y});
      ASSERT_EQ(float(expected), std::isnan(value) ? 0.0f : value) << x << " " << y;
      ASSERT_EQ(float(bits(tile, chosen)), std::isnan(of_slice) ? 0.0f : of_slice) << x << " " << y;
    }
}

TEST_F(InspectTest, ExtinctionOfAllSlicesIsTheOpticalDepthOfTheCards) {
  // Rounding of each share of each card: half of a quantum, of 8 bits in the coarsest.
  const double bound = 2 * 3 * 0.5 * 5.5413 / 255;
  for (const Map& variant :
       {Map{}, Map{{"splat", "packed8_overflow"}, {"rgb_splat", "packed10"}}, Map{{"splat", "words32"}},
        Map{{"splat", "raster"}, {"rgb_splat", "raster"}}, Map{{"sparse", "false"}}}) {
    clear_cards();
    add({.z = 5, .optical_depth = 0.5f, .half_size = {100, 100}});
    add({.z = 9, .optical_depth = 0.8f, .half_size = {100, 100}});
    add({.z = 12, .optical_depth = 1.0f, .transmission = {1, 0.5f, 0}, .half_size = {100, 100}});
    const double middle = -std::log(0.5 + 0.5 * std::exp(-1.0));
    const double expected = 0.5 + 0.8 + (0.0 + middle + 1.0) / 3;
    Map settings = variant;
    settings["exact_layers"] = "0";
    double sum = 0;
    const size_t used = slices_of(see("avboit", "occupancy", settings)).size();
    ASSERT_LT(used, 16u);
    for (uint32_t s = 0; s < used; ++s) {
      const float value = at(see("avboit", "extinction", settings, s), {31, 17});
      if (!std::isnan(value)) sum += double(value);
    }
    EXPECT_NEAR(expected, sum, bound) << (variant.empty() ? "as set" : variant.begin()->second);
  }
}

TEST_F(InspectTest, TransmittanceBehindASliceIsWhatTheProbeReadsThere) {
  // The integral is kept in half floats, and read a hundred-thousandth of a slice beside its nodes.
  constexpr double kBound = 2e-3;
  add_smoke();
  for (const char* sparse : {"true", "false"}) {
    const Map settings{{"exact_layers", "0"}, {"sparse", sparse}};
    const std::unique_ptr<World> w = world();
    double least = 1, most = 0;
    for (const uint32_t slice : {20u, 27u, 33u, 40u, 64u}) {
      const Seen seen = see("vboit", "integral", settings, slice);
      const auto volume = gpu::read<shared::Volume>(device, seen.method.resources.buffer("volume"))[0];
      const double scale = double(volume.slices) / double(volume.curve_octaves);
      // Self-excluded sampling reads a depth in the middle of a slice at the slice's end.
      const double depth = double(volume.curve_a) * (std::exp2((slice + 0.5) / scale) - 1);
      for (const glm::uvec2 pixel : {glm::uvec2(5, 9), glm::uvec2(14, 20), glm::uvec2(40, 30)}) {
        MethodInstance method = instance("vboit", settings);
        const Probe probe(device, pixel, {float(depth)});
        render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, &probe);
        const glm::vec3 t = probe.read_answer(device)[0];
        EXPECT_NEAR(double(t.r + t.g + t.b) / 3, double(at(seen, pixel)), kBound)
            << "slice " << slice << " pixel " << pixel.x;
        least = std::min(least, double(at(seen, pixel)));
        most = std::max(most, double(at(seen, pixel)));
      }
    }
    EXPECT_LT(least, 0.3);
    EXPECT_GT(most, 0.7);
  }
}

TEST_F(InspectTest, TransmittanceIsReadOnlyWhereItWasIntegrated) {
  size = {320, 180};  // many tiles, and slices that few of them have
  for (const double z : {4.0, 6.0, 9.0, 13.0})
    add({.z = float(z),
         .optical_depth = 0.5f,
         .transmission = {0.9f, 0.2f, 0.4f},
         .half_size = {1, 1},
         .at = {random.f(-2, 2), random.f(-1, 1)}});
  const auto w = world();
  MethodInstance method = instance("avboit");
  const auto draw = [&](const Glance* glance) {
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, nullptr, glance);
  };
  draw(nullptr);
  const size_t used = method.method->depth_slices(device, method.resources).size();
  fill_with_poison(method.method->needs(size, w->transparents()), method.resources);
  ASSERT_GT(used, 4u);
  float least = 1;
  for (uint32_t slice = 0; slice < used; ++slice) {
    const Glance glance(device, size, "integral", slice);
    draw(&glance);
    for (const float t : glance.read_values(device)) {
      ASSERT_GE(t, 0) << "slice " << slice;
      ASSERT_LE(t, 1) << "slice " << slice;
      least = std::min(least, t);
    }
  }
  EXPECT_LT(least, 0.8f);
}

TEST_F(InspectTest, ZeroTransmittanceIsWhereTheStepFunctionReachesItToASlice) {
  // The step function falls to exp(-6) at the sixth card and below 1/1024 at the seventh.
  add_walls_of_smoke({4, 5, 6, 7, 8.5f, 10, 12, 15, 20}, 1.0f);
  for (const char* id : {"avboit", "vboit"}) {
    const Seen seen = see(id, "zero_transmittance"), culling = see(id, "culling_depth");
    const auto slices = slices_of(seen);
    const double place = place_of(seen, 12.0);
    // Linear splatting puts a share of a card into the slice behind its own.
    const size_t first = size_t(place), reached = first + (7 - (place - double(first)) < std::log(1024.0));
    for (size_t i = 0; i < seen.values.size(); ++i) {
      ASSERT_EQ(seen.values[i], slices.at(reached).far_m) << id;
      ASSERT_GT(seen.values[i], 12.0f) << id;
      ASSERT_EQ(culling.values[i], slices.at(reached + 1).far_m) << id;
    }
  }
}

TEST_F(InspectTest, NothingIsShownWhereTransmittanceNeverReachesZero) {
  add_walls_of_smoke({4, 5, 6}, 1.0f);
  for (const char* view : {"zero_transmittance", "culling_depth", "first_overflow"})
    for (const float value : see("avboit", view).values) ASSERT_TRUE(std::isnan(value)) << view;
}

TEST_F(InspectTest, FirstOverflowIsTheSliceThatCannotHoldWhatIsInIt) {
  add_walls_of_smoke({5, 5, 5, 5, 5, 5}, 3.0f);  // 18 in two 8-bit fields that hold 5.5 each
  const Map packed{{"splat", "packed8_overflow"}, {"exact_layers", "0"}};
  add_walls_of_smoke({7, 9}, 0.1f);
  const Seen seen = see("avboit", "first_overflow", packed);
  const double place = place_of(seen, 5.0), beyond = place - std::floor(place);
  const size_t first = size_t(place) + (18 * (1 - beyond) < 5.5413);
  const float expected = slices_of(seen).at(first).far_m;
  for (const float value : seen.values) ASSERT_EQ(value, expected);
  // A method that does not note overflow has no such view.
  EXPECT_THROW(see("avboit", "first_overflow", {{"splat", "words32"}}), std::invalid_argument);
}

TEST_F(InspectTest, DepthSlicesAreTheWarpsAndTheMapShowsThem) {
  add({.z = 3});
  add({.z = 40, .half_size = {30, 30}, .yaw = 1.2f});
  add({.z = 60, .apart = true});
  const Seen seen = see("avboit", "slice_map");
  const Warp warp = Warp::from(gpu::read<uint32_t>(device, seen.method.resources.buffer("warp")));
  const auto volume = gpu::read<shared::Volume>(device, seen.method.resources.buffer("volume"))[0];
  const auto slices = slices_of(seen);
  ASSERT_EQ(size_t(warp.head.used), slices.size());
  for (size_t s = 0; s < slices.size(); ++s) {
    ASSERT_LT(slices[s].near_m, slices[s].far_m) << s;
    ASSERT_LE(s > 0 ? slices[s - 1].far_m : 0.0f, slices[s].near_m * 1.00001f) << s;
    const double middle = 0.5 * double(slices[s].near_m + slices[s].far_m);
    EXPECT_NEAR(double(s) + 0.5, slice_at(volume, warp, middle), 0.05) << s;
    EXPECT_EQ(uint32_t(virtual_slice(volume, warp.head.virtual_slices, middle)), slices[s].virtual_slice);
  }
  for (uint32_t x = 0; x < size.x; ++x)
    ASSERT_EQ(float(slices[x * warp.head.used / size.x].virtual_slice), at(seen, {x, size.y - 1})) << x;
}

TEST_F(InspectTest, LookingChangesNoPicture) {
  add_smoke();
  const std::unique_ptr<World> w = world();
  for (const char* id : {"avboit", "wboit"}) {
    MethodInstance method = instance(id);
    const auto draw = [&](const Glance* glance) {
      render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method, nullptr, glance);
      return read_picture(device, w->targets).linear.pixels;
    };
    const auto expected = draw(nullptr);
    for (const Inspection& view : inspections_of(*method.method)) {
      const Glance glance(device, size, view.id, view.slices / 4);
      EXPECT_EQ(expected, draw(&glance)) << id << " " << view.id;
    }
  }
}

}  // namespace
}  // namespace plume
