// A soak of the scene `everything`: its timeline is walked tick by tick again and again; between two rounds
// the walker goes to kMaxTick, where nothing lives, and back. At checkpoints everything is finite: particles,
// cards and the picture; the state is that of the rounds before, and that of another stage, called anywhere
// up to kMaxTick, which seeks to that tick; and memory is what it was.
//
// By default that is a few seconds, of some ticks and without the mist's 200 000 particles.
// PLUME_SOAK_TICKS=N walks N ticks of the whole, or of the whole without the instance PLUME_SOAK_WITHOUT:
// scripts/soak.sh ticks. Then without validation, whose layers keep a little of every frame.
#include <random>

#include "tests/gpu/finite.h"
#include "tests/gpu/gpu_test.h"
#include "tests/gpu/process.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{160, 90};
/// What the driver may keep for itself from the second round on: llvmpipe has lists of 36 MiB of triangles in
/// flight, more or fewer of them. Over 10^6 ticks this finds what leaks 140 bytes a tick.
constexpr uint64_t kHeapSlack = uint64_t{128} << 20;

class SoakTest : public GpuTest {
 protected:
  SoakTest() : GpuTest(!std::getenv("PLUME_SOAK_TICKS")) {}

  struct Timeline {
    Scene scene;
    uint32_t first, last;      // ticks of a round
    uint32_t checkpoint_each;  // ticks, from the first on
  };
  Scene everything_without(std::string_view name) {
    Scene scene = library.scene("everything");
    std::erase_if(scene.instances, [&](const Instance& instance) { return instance.name == name; });
    return scene;
  }
  Timeline a_busy_moment() { return {everything_without("mist"), 620, 639, 19}; }
  Timeline all_of_it() {
    const char* without = std::getenv("PLUME_SOAK_WITHOUT");
    Scene scene = everything_without(without ? without : "");
    const uint32_t last = scene.duration_ticks - 1;
    return {std::move(scene), 0, last, 399};
  }

  uint64_t hash_where_called_later(const Timeline& timeline, uint32_t later, uint32_t tick) {
    Scene scene = timeline.scene;
    for (Instance& instance : scene.instances) *instance.call_tick += later;
    Stage stage(device, pipelines, library, std::move(scene));
    stage.go_to(tick + later, kSize);
    return stage.simulation().state_hash();
  }

  void expect_finite(Stage& stage, const Targets& targets, MethodInstance& method) {
    for (const glm::vec3 pixel : draw(stage, targets, method).linear.pixels)
      ASSERT_TRUE(is_finite(pixel)) << "a pixel";
    for (const shared::Particle& particle : stage.simulation().particles())
      ASSERT_TRUE(is_finite(particle)) << "particle " << particle.birth;
    auto cards = gpu::read<shared::Card>(device, *stage.transparents().cards);
    cards.resize(stage.transparents().count);
    for (size_t i = 0; i < cards.size(); ++i) ASSERT_TRUE(is_finite(cards[i])) << "card " << i;
  }

  void soak(const Timeline& timeline, uint64_t ticks, bool says_where_it_is) {
    Stage stage(device, pipelines, library, timeline.scene);
    const Targets targets(device, kSize, stage.post());
    MethodInstance method = instance("avboit");
    std::map<uint32_t, uint64_t> hashes, device_bytes;  // by tick
    uint64_t warm_bytes = 0, walked = 0;
    std::mt19937 random(1);
    for (uint32_t round = 0; walked < ticks; ++round) {
      for (uint32_t tick = timeline.first; tick <= timeline.last; ++tick, ++walked) {
        stage.go_to(tick, kSize);
        if ((tick - timeline.first) % timeline.checkpoint_each != 0) continue;
        SCOPED_TRACE(testing::Message() << "round " << round << ", tick " << tick);
        expect_finite(stage, targets, method);
        if (HasFatalFailure()) return;
        const uint64_t hash = stage.simulation().state_hash();
        ASSERT_EQ(hashes.try_emplace(tick, hash).first->second, hash);
        if (round == 0) continue;  // which makes room for what comes
        const uint64_t bytes = device.memory().total_bytes();
        ASSERT_EQ(device_bytes.try_emplace(tick, bytes).first->second, bytes);
      }
      const auto checkpoint = std::next(hashes.begin(), long(random() % hashes.size()));
      const uint32_t later = uint32_t(random() % (kMaxTick - timeline.last));
      const uint64_t before = device.memory().total_bytes();
      ASSERT_EQ(checkpoint->second, hash_where_called_later(timeline, later, checkpoint->first))
          << "tick " << checkpoint->first << ", called " << later << " ticks later";
      ASSERT_EQ(before, device.memory().total_bytes());
      stage.go_to(kMaxTick, kSize);
      EXPECT_EQ(0u, device.memory().owner_bytes("particles"));
      const uint64_t in_use = heap_bytes();
      if (round <= 1) warm_bytes = in_use;
      ASSERT_LE(in_use, warm_bytes + kHeapSlack) << "round " << round;
      if (says_where_it_is)
        std::cerr << "soak: " << walked << " of " << ticks << " ticks, " << (in_use >> 10)
                  << " KiB of the heap in use\n";
    }
    RecordProperty("ticks", int(walked));
  }
};

TEST_F(SoakTest, EverythingStaysFiniteAndExactAndAsLargeAsItWas) {
  const char* wanted = std::getenv("PLUME_SOAK_TICKS");
  soak(wanted ? all_of_it() : a_busy_moment(), wanted ? std::stoull(wanted) : 60, wanted != nullptr);
}

}  // namespace
}  // namespace plume
