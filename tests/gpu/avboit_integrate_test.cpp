// The integration of random extinction words, alone, against sums in double precision.
#include <algorithm>

#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

using namespace shared;

class AvboitIntegrate : public AvboitTest {
 protected:
  struct Case {
    uint32_t lane_bits = 16, rgb_words = 0;
    bool transmittance = false, eight_bits = false, sparse = true;
  };
  /// What goes in.
  struct Words {
    Volume volume{};
    uint32_t used = 0;
    std::vector<uint32_t> occupancy, extinction, overflow, extinction_rgb, overflow_rgb;
  };
  /// What comes out. A slice of a ray is (before, behind).
  struct Integral {
    std::vector<std::vector<uint32_t>> all, b;
    std::vector<std::vector<uint64_t>> rg;
    std::vector<uint32_t> zero_slice, rgb_start;
  };
  static constexpr uint32_t kUntouched = 0x7e007e00;  // two halves that are no number
  static constexpr glm::uvec2 kCells{11, 9};          // two tiles by two

  Random random{1};

  Words random_words(const Case& c, double depth_per_slice) {
    Words w;
    w.volume = {.cells = kCells,
                .tiles = {2, 2},
                .divisor = 8,
                .slices = 96,
                .zero_depth = float(-std::log(1.0 / 1024)),
                .cards = 1};
    w.used = 70;
    const uint32_t rays = kCells.x * kCells.y, tiles = 4, lanes = 32 / c.lane_bits;
    w.occupancy.resize(2 * tiles * kMaskWords);
    for (uint32_t& word : w.occupancy)
      word = random.one_in(5) ? 0 : random.word() & (random.one_in(2) ? random.word() : ~0u);
    w.extinction.resize(rays * w.volume.slices / lanes);
    const uint64_t full = (uint64_t(1) << c.lane_bits) - 1;
    const double steps = steps_of(c.lane_bits);
    for (uint32_t& word : w.extinction)
      for (uint32_t lane = 0; lane < lanes; ++lane) {
        const double tau = random.one_in(3) ? 0 : random.octaves(0.001, depth_per_slice);
        const uint64_t field = random.one_in(200) ? full : uint64_t(tau * steps);
        word |= uint32_t(std::min(field, full) << lane * c.lane_bits);
      }
    w.overflow.assign(rays, kNoOverflow);
    for (uint32_t& slice : w.overflow)
      if (random.one_in(3)) slice = random.below(w.used);
    w.extinction_rgb.resize(std::max<size_t>(rays * w.volume.slices * c.rgb_words, 1));
    for (uint32_t& word : w.extinction_rgb) {
      const auto field = [&](uint32_t bits) {
        return random.one_in(3) ? 0u : uint32_t(random.octaves(0.001, depth_per_slice) * steps_of(bits));
      };
      word = c.rgb_words == 1 ? std::min(field(8), 1023u) | std::min(field(8), 1023u) << 10 |
                                    std::min(field(8), 1023u) << 20
                              : field(32);
    }
    w.overflow_rgb.assign(c.rgb_words == 1 ? rays * 4 : 1, kNoOverflow);
    for (uint32_t& slice : w.overflow_rgb)
      if (random.one_in(3)) slice = random.below(w.used);
    return w;
  }
  static double steps_of(uint32_t bits) {
    return bits == 8 ? 255 / std::log(255.0) : bits == 16 ? 65535 / 16.0 : 4096;
  }

  Integral integrate(const Case& c, const Words& w) {
    std::vector<uint32_t> warp_words(sizeof(DepthWarp) / 4);
    const DepthWarp warp{.virtual_slices = 1024, .used = w.used, .scale = 1, .apart_dropped = 0};
    std::memcpy(warp_words.data(), &warp, sizeof(warp));
    const uint32_t rays = kCells.x * kCells.y;
    const gpu::Buffer block = upload("volume", std::vector{w.volume}), table = upload("warp", warp_words),
                      occupancy = upload("occupancy", w.occupancy), in = upload("extinction", w.extinction),
                      over = upload("overflow", w.overflow), rgb_in = upload("rgb", w.extinction_rgb),
                      rgb_over = upload("overflow_rgb", w.overflow_rgb),
                      zero = upload("zero_slice", std::vector<uint32_t>(rays)),
                      start = upload("rgb_start", std::vector<uint32_t>(4));
    const auto image = [&](const char* name, vk::Format format) {
      return gpu::Image(device, {.owner = "test",
                                 .label = name,
                                 .format = format,
                                 .extent = {kCells.x, kCells.y, 1},
                                 .layers = w.volume.slices,
                                 .usage = vk::ImageUsageFlagBits::eStorage});
    };
    const gpu::Image all = image("integral", vk::Format::eR16G16Sfloat),
                     rg = image("integral_rg", vk::Format::eR16G16B16A16Sfloat),
                     b = image("integral_b", vk::Format::eR16G16Sfloat);
    const gpu::Image no_layers(device, {.owner = "test",
                                        .label = "no layers",
                                        .format = vk::Format::eR8Unorm,
                                        .layers = 1,
                                        .usage = vk::ImageUsageFlagBits::eSampled});
    gpu::Frame frame(device, pipelines);
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    frame.pass("poison", [&](gpu::Pass& pass) {
      for (const gpu::Image* i : {&all, &rg, &b}) pass.clear(*i, {kNan, kNan, kNan, kNan});
    });
    frame.pass("integrate", [&](gpu::Pass& pass) {
      pass.dispatch(
          pass.pipelines().compute("methods/avboit/integrate.comp",
                                   {c.sparse ? 1u : 0u, c.lane_bits, c.rgb_words, c.transmittance ? 1u : 0u,
                                    c.eight_bits ? 1u : 0u, 0u, c.rgb_words != 0 ? 1u : 0u}),
          {{"VolumeBlock", &block},
           {"WarpTable", &table},
           {"Occupancy", &occupancy},
           {"Extinction", &in},
           {"Overflow", &over},
           {"ExtinctionRgb", &rgb_in},
           {"OverflowRgb", &rgb_over},
           {"integral", &all},
           {"integral_rg", &rg},
           {"integral_b", &b},
           {"extinction_layers", &no_layers},
           {"extinction_layers_rgb", &no_layers},
           {"ZeroSlice", &zero},
           {"RgbStart", &start}},
          0u, {2, 2, 1});
    });
    frame.finish();
    Integral out;
    for (uint32_t s = 0; s < w.volume.slices; ++s) {
      out.all.push_back(read_layer<uint32_t>(all, s));
      out.rg.push_back(read_layer<uint64_t>(rg, s));
      out.b.push_back(read_layer<uint32_t>(b, s));
    }
    out.zero_slice = gpu::read<uint32_t>(device, zero);
    out.rgb_start = gpu::read<uint32_t>(device, start);
    return out;
  }

  static double stored(const Case& c, double tau) {
    if (!c.transmittance) return tau;
    const double t = tau >= double(kSaturatedDepth) ? 0 : std::exp(-tau);
    return c.eight_bits ? std::round(t * 255) / 255 : t;
  }
  /// A half float that was rounded once, from a sum that single precision rounded, of at most `events` terms.
  static void expect_stored(const Case& c, double tau, double half, const char* what) {
    const double value = stored(c, tau);
    double bound = std::abs(value) * (1.0 / 1024 + 1e-5) + 6e-8;
    if (c.eight_bits && std::abs(std::exp(-tau) * 255 - std::floor(std::exp(-tau) * 255) - 0.5) < 2e-3)
      bound += 1.0 / 255;
    ASSERT_NEAR(value, half, bound) << what << ", optical depth " << tau;
  }

  /// A slice counts 8 at most, and from an overflow on each does; all together 64.
  static double counted(double in_front, double behind, bool overflows) {
    const double most = std::min(in_front + 8, 64.0);
    return overflows ? most : std::min(behind, most);
  }

  void expect_integral(const Case& c, const Words& w, const Integral& out) {
    const uint32_t lanes = 32 / c.lane_bits;
    for (uint32_t ray = 0; ray < kCells.x * kCells.y; ++ray) {
      const uint32_t tile = ray / kCells.x / kTileCells * 2 + ray % kCells.x / kTileCells;
      const auto bit = [&](uint32_t slice, uint32_t base) {
        return !c.sparse || (w.occupancy[(base + tile) * kMaskWords + slice / 32] >> slice % 32 & 1);
      };
      double tau = 0;
      glm::dvec3 of_rgb(0.0), before_all(0.0);
      uint32_t zero = kNoSlice;
      bool doubtful = false;
      for (uint32_t s = 0; s < w.volume.slices; ++s) {
        SCOPED_TRACE(testing::Message() << "ray " << ray << " slice " << s);
        const bool in_scalar = bit(s, 0), in_rgb = c.rgb_words != 0 && bit(s, 4);
        if (s >= w.used || !(in_scalar || in_rgb)) {
          ASSERT_EQ(kUntouched, out.all[s][ray] & kUntouched) << "written where nothing is";
          continue;
        }
        const double before = tau;
        if (in_scalar) {
          const uint32_t word = w.extinction[ray * (w.volume.slices / lanes) + s / lanes];
          const uint64_t full = (uint64_t(1) << c.lane_bits) - 1;
          tau += double(word >> c.lane_bits * (s % lanes) & full) / steps_of(c.lane_bits);
        }
        tau = counted(before, tau, s >= w.overflow[ray]);
        const glm::vec2 found = glm::unpackHalf2x16(out.all[s][ray]);
        expect_stored(c, before, double(found.x), "before");
        expect_stored(c, tau, double(found.y), "behind");
        double least = tau;
        if (c.rgb_words != 0) {
          glm::dvec3 all;
          for (uint32_t k = 0; k < 3; ++k) {
            const double in_front = of_rgb[k];
            if (in_rgb)
              of_rgb[k] +=
                  c.rgb_words == 1
                      ? double(w.extinction_rgb[ray * w.volume.slices + s] >> 10 * k & 1023) / steps_of(8)
                      : double(w.extinction_rgb[(ray * w.volume.slices + s) * 3 + k]) / steps_of(32);
            of_rgb[k] = counted(in_front, of_rgb[k], c.rgb_words == 1 && s >= w.overflow_rgb[ray * 3 + k]);
            all[k] = tau + of_rgb[k];
          }
          const glm::vec4 rg = glm::unpackHalf4x16(out.rg[s][ray]);
          const glm::vec2 b = glm::unpackHalf2x16(out.b[s][ray]);
          const double halves[] = {rg.x, rg.y, rg.z, rg.w, b.x, b.y};
          for (int k = 0; k < 3; ++k) {
            expect_stored(c, before_all[k], halves[2 * k], "before, of all sources");
            expect_stored(c, all[k], halves[2 * k + 1], "behind, of all sources");
          }
          before_all = all;
          least = std::min({all.r, all.g, all.b});
        }
        doubtful = doubtful || std::abs(least - double(w.volume.zero_depth)) < 1e-4;
        if (least >= double(w.volume.zero_depth)) zero = std::min(zero, s);
      }
      ASSERT_TRUE(doubtful || zero == out.zero_slice[ray])
          << "ray " << ray << ": " << zero << ", " << out.zero_slice[ray];
      if (HasFatalFailure()) return;
    }
    for (uint32_t tile = 0; tile < 4 && c.rgb_words != 0; ++tile) {
      uint32_t start = kNoSlice;
      for (uint32_t s = (w.used + 31) / 32 * 32; s-- > 0;)
        if (!c.sparse || (w.occupancy[(4 + tile) * kMaskWords + s / 32] >> s % 32 & 1)) start = s;
      EXPECT_EQ(start, out.rgb_start[tile]);
    }
  }
};

TEST_F(AvboitIntegrate, IsTheRunningSumOfTheWordsOfARay) {
  for (const uint32_t lane_bits : {8u, 16u, 32u})
    for (const uint32_t rgb_words : {0u, 1u, 3u})
      for (const int kind : {0, 1, 2}) {
        const Case c{.lane_bits = lane_bits,
                     .rgb_words = rgb_words,
                     .transmittance = kind > 0,
                     .eight_bits = kind == 2,
                     .sparse = (lane_bits / 8 + rgb_words + uint32_t(kind)) % 3 != 0};
        SCOPED_TRACE(testing::Message() << lane_bits << " bits, " << rgb_words << " RGB words, kind " << kind
                                        << (c.sparse ? " sparse" : " dense"));
        const Words w = random_words(c, kind == 0 ? 2.0 : 0.3);
        expect_integral(c, w, integrate(c, w));
        if (HasFatalFailure()) return;
      }
}

TEST_F(AvboitIntegrate, NothingThatIsSeenPassesAnOverflow) {
  for (const bool transmittance : {false, true}) {
    const Case c{.rgb_words = 1, .transmittance = transmittance, .sparse = false};
    Words w = random_words(c, 0.01);
    std::ranges::fill(w.overflow, 20u);
    std::ranges::fill(w.overflow_rgb, kNoOverflow);
    const Integral out = integrate(c, w);
    for (uint32_t ray = 0; ray < kCells.x * kCells.y; ++ray) {
      ASSERT_LE(out.zero_slice[ray], 20u);
      for (uint32_t s = 20; s < w.used; ++s) {
        const float all = glm::unpackHalf2x16(out.all[s][ray]).y, b = glm::unpackHalf2x16(out.b[s][ray]).y;
        for (const float found : {all, b}) {
          const double t = transmittance ? double(found) : std::exp(-double(found));
          ASSERT_LE(t, std::exp(-8.0 * std::min(s - 19, 7u)) * 1.02 + 6e-8);
        }
        ASSERT_TRUE(s < 28 || all == (transmittance ? 0.0f : kSaturatedDepth));
      }
    }
  }
}

}  // namespace
}  // namespace plume
