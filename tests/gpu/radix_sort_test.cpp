#include "renderer/radix_sort.h"

#include <algorithm>
#include <random>

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

struct Pair {
  uint32_t key, value;
  bool operator==(const Pair&) const = default;
};

class RadixSortTest : public GpuTest {
 protected:
  std::vector<Pair> sort(const std::vector<Pair>& pairs, uint32_t bits = 32) {
    const uint32_t count = uint32_t(pairs.size());
    const auto source = gpu::make_buffer(device, "test", "pairs", pairs);
    const gpu::Buffer scratch(device, {.owner = "test", .label = "scratch", .bytes = source.bytes()});
    const gpu::Buffer counts(device,
                             {.owner = "test", .label = "counts", .bytes = radix_counts_bytes(count)});
    const auto work = gpu::make_buffer(device, "test", "work", std::vector{shared::workload_of(count)});
    gpu::Frame frame(device, pipelines);
    frame.pass("sort", [&](gpu::Pass& pass) { radix_sort(pass, source, scratch, counts, work, bits); });
    frame.finish();
    auto sorted = gpu::read<Pair>(device, source);
    sorted.resize(count);
    return sorted;
  }
};

TEST_F(RadixSortTest, EqualsAStableSortForAnyCount) {
  std::mt19937 random(7);
  for (const uint32_t count : {1u, 2u, 63u, 1023u, 1024u, 1025u, 5000u, 70001u})
    for (const uint32_t most : {3u, 1000u, 0xffffffffu}) {  // many ties, few, hardly any
      std::vector<Pair> pairs;
      for (uint32_t i = 0; i < count; ++i) pairs.push_back({uint32_t(random()) % most, i});
      auto expected = pairs;
      std::ranges::stable_sort(expected, {}, &Pair::key);
      EXPECT_EQ(expected, sort(pairs)) << count << " pairs, keys below " << most;
    }
}

TEST_F(RadixSortTest, SortsByAsManyBitsAsItIsTold) {
  std::mt19937 random(8);
  for (const uint32_t bits : {1u, 4u, 6u, 8u, 12u, 17u}) {
    std::vector<Pair> pairs;
    for (uint32_t i = 0; i < 3000; ++i) pairs.push_back({uint32_t(random()) & ((1u << bits) - 1), i});
    auto expected = pairs;
    std::ranges::stable_sort(expected, {}, &Pair::key);
    EXPECT_EQ(expected, sort(pairs, bits)) << bits << " bits";
  }
}

}  // namespace
}  // namespace plume
