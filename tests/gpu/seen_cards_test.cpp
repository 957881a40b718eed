#include "renderer/seen_cards.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

#include "renderer/radix_sort.h"
#include "shaders/shared/card.h"
#include "shaders/shared/draw_command.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

using shared::DrawCommand;

class SeenCardsTest : public GpuTest {
 protected:
  struct Found {
    std::vector<uint32_t> order;
    std::vector<DrawCommand> draws;
    shared::Workload work;
    shared::BadCards bad;
  };
  Found found(const std::vector<shared::Card>& cards, const std::vector<uint32_t>& submission,
              std::array<uint32_t, kSources> counts) {
    const auto card_buffer =
        gpu::make_buffer(device, "test", "cards", cards.empty() ? std::vector<shared::Card>(1) : cards);
    const auto submitted = gpu::make_buffer(device, "test", "submission",
                                            submission.empty() ? std::vector<uint32_t>(1) : submission);
    Transparents transparents{.cards = &card_buffer, .count = uint32_t(cards.size()), .counts = counts};
    seen.fit(transparents);
    gpu::Frame frame(device, pipelines);
    seen.record(frame, transparents, submitted);
    frame.finish();
    Found result{.order = gpu::read<uint32_t>(device, *transparents.order),
                 .draws = gpu::read<DrawCommand>(device, *transparents.draws),
                 .work = gpu::read<shared::Workload>(device, *transparents.work)[0],
                 .bad = {}};
    result.order.resize(result.work.count);
    result.bad = seen.bad();
    return result;
  }

  SeenCards seen{device};  // of all counts in turn: what one leaves is not taken for the next one's
};

enum class Shows { kNothing, kCoverage, kEmission, kHaze };

shared::Card card_that(Shows shows) {
  shared::Card card{};
  if (shows == Shows::kCoverage) card.optical_depth = 1e-6f;
  if (shows == Shows::kEmission) card.emission = {1, 0};
  if (shows == Shows::kHaze) card.motion = {0, 1u << 16};
  card.sunlit = card.transmission = {0x7bff7bffu, 0xfbff7bffu};
  return card;
}

TEST_F(SeenCardsTest, AreThoseThatShowAnythingBySourceAsTheyWereSubmitted) {
  std::mt19937 random(5);
  for (const uint32_t count : {0u, 1u, 256u, 257u, 1023u, 1025u, 40000u, 9u})
    for (const uint32_t hidden_of_four : {0u, 1u, 3u, 4u}) {
      SCOPED_TRACE(testing::Message() << count << " cards, " << hidden_of_four << " of 4 hidden");
      std::array<uint32_t, kSources> counts{count / 2, count % 7 ? count / 5 : 0, 0};
      counts[2] = count - counts[0] - counts[1];
      std::vector<shared::Card> cards;
      std::vector<bool> shown;
      for (uint32_t i = 0; i < count; ++i) {
        shown.push_back(random() % 4 >= hidden_of_four);
        cards.push_back(card_that(shown.back() ? Shows(1 + random() % 3) : Shows::kNothing));
      }
      std::vector<uint32_t> submission(count);
      std::iota(submission.begin(), submission.end(), 0u);
      for (uint32_t source = 0, first = 0; source < kSources; first += counts[source++])
        std::shuffle(submission.begin() + first, submission.begin() + first + counts[source], random);

      const Found got = found(cards, submission, counts);
      std::vector<uint32_t> expected;
      std::ranges::copy_if(submission, std::back_inserter(expected), [&](uint32_t id) { return shown[id]; });
      EXPECT_EQ(expected, got.order);
      uint32_t first = 0, card = 0;
      for (uint32_t source = 0; source < kSources; ++source) {
        const auto begin = shown.begin() + card;
        const auto number = uint32_t(std::count(begin, begin + counts[source], true));
        const DrawCommand& draw = got.draws[1 + source];
        EXPECT_EQ(number, draw.instances) << "source " << source;
        if (number > 0) {
          EXPECT_EQ(first, draw.first_instance) << "source " << source;
        }
        first += number, card += counts[source];
      }
      EXPECT_EQ(first, got.draws[0].instances);
      EXPECT_EQ(0u, got.draws[0].first_instance);
      EXPECT_EQ(first, got.work.count);
      EXPECT_EQ((first + 255) / 256, got.work.groups.x);
      for (const DrawCommand& draw : got.draws) EXPECT_EQ(count > 0 ? 4u : 0u, draw.vertices);
    }
}

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
constexpr size_t kLayers = offsetof(shared::Card, layers);  // the one word that is no number
constexpr size_t kHalves = offsetof(shared::Card, sunlit);  // from there on

/// Cards that show, each with one of its numbers replaced: every number in turn by each of the values.
std::vector<shared::Card> with_each(std::span<const float> lengths, std::span<const float> others,
                                    std::span<const uint16_t> halves) {
  std::vector<shared::Card> cards;
  const auto add = [&](size_t at, const auto& value) {
    cards.push_back(card_that(Shows::kCoverage));
    std::memcpy(reinterpret_cast<std::byte*>(&cards.back()) + at, &value, sizeof value);
  };
  for (size_t at = 0; at < kHalves; at += 4) {
    if (at == kLayers) continue;
    const bool is_length =
        at != offsetof(shared::Card, optical_depth) && at != offsetof(shared::Card, inv_feather);
    for (const float value : is_length ? lengths : others) add(at, value);
  }
  for (size_t at = kHalves; at < sizeof(shared::Card); at += 2)
    for (const uint16_t value : halves) add(at, value);
  return cards;
}

TEST_F(SeenCardsTest, LeaveOutThoseThatNothingCanBeDrawnWithAndCountThem) {
  const auto bad =
      with_each(std::array{kNaN, -kNaN, kInf, -kInf, 1.001e9f, -1e38f}, std::array{kNaN, -kNaN, kInf, -kInf},
                std::array<uint16_t, 5>{0x7c00, 0xfc00, 0x7c01, 0x7fff, 0xffff});
  const auto good = with_each(std::array{0.0f, -0.0f, 1e-44f, 1e9f, -1e9f}, std::array{1e-30f, 3e38f},
                              std::array<uint16_t, 5>{0x0000, 0x8001, 0x7bff, 0xfbff, 0x03ff});
  std::vector<shared::Card> cards = good;
  cards.insert(cards.end(), bad.begin(), bad.end());
  cards.insert(cards.end(), good.begin(), good.end());
  const auto count = uint32_t(cards.size()), first = uint32_t(good.size());
  std::vector<uint32_t> submission(count);
  std::iota(submission.begin(), submission.end(), 0u);
  std::shuffle(submission.begin(), submission.end(), std::mt19937(3));
  const Found got = found(cards, submission, {count, 0, 0});
  std::vector<uint32_t> expected;
  std::ranges::copy_if(submission, std::back_inserter(expected),
                       [&](uint32_t id) { return id < first || id >= first + bad.size(); });
  EXPECT_EQ(expected, got.order);
  EXPECT_EQ(bad.size(), got.bad.count);
  EXPECT_EQ(first, got.bad.first);
  std::ranges::sort(submission);
  submission.resize(good.size());
  const Found next = found(good, submission, {first, 0, 0});
  EXPECT_EQ(0u, next.bad.count) << "what the frame before left out";
}

}  // namespace
}  // namespace plume
