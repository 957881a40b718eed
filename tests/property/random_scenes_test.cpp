// Scenes that nobody wrote (random_scene.h), by every method, with validation on: what holds for any picture
// of any method, whatever is in it.
//
// A few scenes by default; PLUME_RANDOM_SCENES=N draws N, of the seeds from PLUME_RANDOM_FIRST (1) on:
// scripts/random_scenes.sh. The files of a scene on which something fails stay where the message says.
#include <fmt/format.h>
#include <unistd.h>

#include "sandbox/measure/shortfalls.h"
#include "sandbox/presets/check.h"
#include "sandbox/presets/field_help.h"
#include "sandbox/presets/preset_file.h"
#include "tests/gpu/finite.h"
#include "tests/gpu/gpu_test.h"
#include "tests/property/picture_bounds.h"
#include "tests/property/random_scene.h"

namespace plume {
namespace {
namespace fs = std::filesystem;

constexpr uint32_t kFewScenes = 10;
constexpr uint32_t kEnoughForMostFields = 100;  // scenes

size_t failures() {
  const auto* result = testing::UnitTest::GetInstance()->current_test_info()->result();
  size_t failed = 0;
  for (int i = 0; i < result->total_part_count(); ++i) failed += result->GetTestPartResult(i).failed();
  return failed;
}

class RandomScenes : public GpuTest {
 protected:
  static uint32_t from_environment(const char* name, uint32_t otherwise) {
    const char* text = std::getenv(name);
    return text ? uint32_t(std::stoul(text)) : otherwise;
  }
  const fs::path root_ = fs::path(testing::TempDir()) / fmt::format("plume_random_{}", ::getpid());

  void check_files(const RandomScene& made) {
    for (const Diagnostic& mistake : made.disagreements)
      ADD_FAILURE() << "refused, though within the limits: " << to_string(mistake);
    for (const fs::path& file : made.files)
      for (const Diagnostic& mistake : check_file(file)) ADD_FAILURE() << to_string(mistake);
    edits_ += made.edits, contradictions_ += made.contradictions;
    patterns_.insert(made.patterns.begin(), made.patterns.end());
  }

  void check_particles(const Stage& stage) {
    const auto particles = stage.simulation().particles();
    for (const shared::Particle& particle : particles)
      ASSERT_TRUE(is_finite(particle)) << "particle " << particle.birth;
    auto cards = gpu::read<shared::Card>(device, *stage.transparents().cards);
    cards.resize(stage.transparents().count);
    for (size_t i = 0; i < cards.size(); ++i) ASSERT_TRUE(is_finite(cards[i])) << "card " << i;
    particles_ += particles.size(), cards_ += cards.size();
  }

  /// `worn` has drawn all scenes before, in other sizes: nothing of them may be left.
  void check_method(const std::string& id, Stage& stage, const Targets& targets, const Image& exact,
                    const PictureBounds& bounds) {
    MethodInstance fresh = instance(id);
    const Traits traits = fresh.method->traits();
    const Image drawn = draw(stage, targets, fresh).linear;
    const bool fell_short =
        !shortfall_sentences(*fresh.method, fresh.method->statistics(device, fresh.resources)).empty();
    if (const auto breach = bounds.breach(drawn, traits, fell_short)) ADD_FAILURE() << *breach;
    if (traits.exact && !fell_short)
      if (const auto difference = bounds.difference(exact, drawn, traits)) ADD_FAILURE() << *difference;
    auto worn = worn_.find(id);
    if (worn == worn_.end()) {
      worn = worn_.emplace(id, instance(id)).first;
      worn->second.owner = id + ", worn";
    }
    EXPECT_TRUE(draw(stage, targets, worn->second).linear.pixels == drawn.pixels)
        << "the same picture again is another";
  }

  void check_scene(uint64_t seed, const fs::path& folder) {
    const RandomScene made = make_random_scene(seed, folder);
    SCOPED_TRACE(fmt::format("seed {}: PLUME_PRESETS={} plume compare {} --size {}x{}", seed, folder.string(),
                             made.id, made.size.x, made.size.y));
    check_files(made);
    const PresetLibrary presets(folder);
    Stage stage(device, pipelines, presets, presets.scene(made.id));
    const Targets plain(device, made.size), whole(device, made.size, stage.post());
    stage.go_to(stage.scene().default_tick, made.size);
    MethodInstance reference = instance("reference");
    const Image exact = draw(stage, plain, reference).linear;
    check_particles(stage);
    Image background = exact;
    const auto texels = gpu::read<uint64_t>(device, plain.opaque_color);
    for (size_t i = 0; i < texels.size(); ++i) background.pixels[i] = glm::unpackHalf4x16(texels[i]);
    const PictureBounds bounds(device, reference.resources, std::move(background));
    for (const std::string& id : method_ids()) {
      if (!make_method(id)->missing(device).empty()) continue;
      SCOPED_TRACE(id);
      check_method(id, stage, plain, exact, bounds);
      if (stage.post() == Post{}) continue;
      MethodInstance with_post = instance(id);
      const Image drawn = draw(stage, whole, with_post).linear;
      for (const glm::vec3& pixel : drawn.pixels) ASSERT_TRUE(is_finite(pixel)) << "after haze and lens";
    }
    instances_ += stage.scene().instances.size(), fragments_ += bounds.fragments();
    shown_ += bounds.fragments() > 0, deepest_ = std::max(deepest_, bounds.deepest());
  }

  std::map<std::string, MethodInstance> worn_;
  size_t edits_ = 0, contradictions_ = 0, instances_ = 0, particles_ = 0, cards_ = 0, fragments_ = 0,
         shown_ = 0, deepest_ = 0;
  std::set<std::string> patterns_;
};

TEST_F(RandomScenes, KeepToWhatHoldsForEveryPictureOfEveryMethod) {
  const uint32_t count = from_environment("PLUME_RANDOM_SCENES", kFewScenes),
                 first = from_environment("PLUME_RANDOM_FIRST", 1);
  for (uint32_t seed = first; seed < first + count; ++seed) {
    const size_t before = failures(), messages = device.validation_messages().size();
    const fs::path folder = root_ / std::to_string(seed);
    try {
      check_scene(seed, folder);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
    EXPECT_EQ(device.validation_messages().size(), messages) << "seed " << seed;
    if (failures() == before) fs::remove_all(folder);
    if (count > kFewScenes && (seed - first) % 10 == 9)
      std::cerr << "random scenes: " << seed - first + 1 << " of " << count << "\n";
  }
  if (fs::exists(root_) && fs::is_empty(root_)) fs::remove(root_);
  std::vector<std::string_view> never_set;
  for (const FieldHelp& field : all_field_help())
    if (!patterns_.contains(std::string(field.pattern))) never_set.push_back(field.pattern);
  const std::string summary = fmt::format(
      "{} of {} scenes show something: {} instances, {} particles, {} cards, {} fragments, at most {} in a "
      "pixel; {} edits were taken and {} refused; of {} fields never set: {}",
      shown_, count, instances_, particles_, cards_, fragments_, deepest_, edits_, contradictions_,
      all_field_help().size(), never_set.empty() ? "none" : fmt::format("{}", fmt::join(never_set, ", ")));
  RecordProperty("summary", summary);
  if (count > kFewScenes) std::cerr << "random scenes: " << summary << "\n";
  EXPECT_GE(shown_, count / 4) << "too little is seen to tell anything";
  if (count >= kEnoughForMostFields) {
    EXPECT_LE(never_set.size(), all_field_help().size() / 20);
  }
}

TEST(RandomScene, IsTheSameOfTheSameSeed) {
  const fs::path root = fs::path(testing::TempDir()) / fmt::format("plume_random_twice_{}", ::getpid());
  const RandomScene one = make_random_scene(7, root / "one"), other = make_random_scene(7, root / "other"),
                    next = make_random_scene(8, root / "next");
  ASSERT_EQ(one.files.size(), other.files.size());
  for (size_t i = 0; i < one.files.size(); ++i)
    EXPECT_EQ(load_text(one.files[i]), load_text(other.files[i])) << one.files[i];
  EXPECT_EQ(one.size, other.size);
  EXPECT_NE(load_text(one.files.back()), load_text(next.files.back()));
  fs::remove_all(root);
}

}  // namespace
}  // namespace plume
