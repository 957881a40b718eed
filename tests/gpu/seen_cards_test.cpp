#include "renderer/seen_cards.h"

#include <algorithm>
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
                 .work = gpu::read<shared::Workload>(device, *transparents.work)[0]};
    result.order.resize(result.work.count);
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
  card.sunlit = card.transmission = {~0u, ~0u};
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

}  // namespace
}  // namespace plume
