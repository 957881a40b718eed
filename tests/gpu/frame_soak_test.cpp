// A soak of the window's work without a window: a workspace is led at random, from a seed, through the
// library's scenes, every method and its options, views, comparisons, sizes, ticks forth and back, solo and
// mute, an effect rewritten on disk (now and then with a mistake), and shaders made anew. Every so often it
// comes home, to the same scene, tick, size and method: there the device's memory, every kind of Vulkan
// object, open files, threads and the picture are what they were, and the process is as large; and one more
// method draws what it drew there the first time.
//
// By default 100 frames with validation: no message of the layers. PLUME_SOAK_FRAMES=N draws N, which the
// heap must not grow by (but where the driver's own does), and validates them only with
// PLUME_SOAK_VALIDATE=1: scripts/soak.sh frames N.
#include <random>

#include "tests/gpu/environment.h"
#include "tests/gpu/living_objects.h"
#include "tests/gpu/process.h"
#include "tests/gpu/workspace_test.h"

namespace plume {
namespace {

constexpr const char* kHomeScene = "interleaved";
constexpr uint32_t kHomeTick = 200;
constexpr glm::uvec2 kHomeSize{63, 35};
constexpr const char* kHomeMethod = "avboit";
/// Of the scene at home.
constexpr const char* kRewritten = "effects/rust_smoke.toml";
/// Of 50 frames each: then all pipelines are dropped and the heap is looked at. llvmpipe compiles a pipeline
/// again for each kind of texture and sampler it meets and keeps all of that with the pipeline, so that only
/// a heap without pipelines can be held to what it was.
constexpr int kHomesBetweenHeaps = 100;
/// What the driver's lists (see SoakTest) and the undo history of what is rewritten may take.
constexpr uint64_t kHeapSlack = uint64_t{128} << 20;
/// What llvmpipe of Mesa 22 keeps of a frame besides, on the average: its queue thread copies shaders when
/// they are bound and keeps some beyond their pipelines (260 MiB by frame 20,000). Mesa 25's does not.
constexpr uint64_t kMesa22HeapOfAFrame = uint64_t{32} << 10;
/// Looks in a row above that.
constexpr int kMostLargeHeaps = 3;
/// Their 200,000 particles take seconds to seek: SoakTest walks them.
const std::set<std::string> kHeavy{"everything", "mist", "closeup"};

/// The layers keep a few KiB of every frame: what is validated cannot be held to the size of the heap.
const bool kValidates = !std::getenv("PLUME_SOAK_FRAMES") || std::getenv("PLUME_SOAK_VALIDATE");

class FrameSoakTest : private EnvironmentVariable, public WorkspaceTest {
 protected:
  // Mesa's cache on disk starts threads and opens files of its own while it is written.
  FrameSoakTest() : EnvironmentVariable("MESA_SHADER_CACHE_DISABLE", "true"), WorkspaceTest(kValidates) {
    std::filesystem::copy(PLUME_SOURCE_PRESETS, root_, std::filesystem::copy_options::recursive);
    original_ = read(kRewritten);
    scenes_ = presets_.ids(PresetKind::kScene);
    std::erase_if(scenes_, [](const std::string& id) { return kHeavy.contains(id); });
  }

  /// What must be the same whenever the walk is at home.
  struct Held {
    uint64_t device_bytes;
    std::map<std::string, int64_t> objects;
    std::multiset<std::string> files;
    int64_t threads;
    bool operator==(const Held&) const = default;
    friend std::ostream& operator<<(std::ostream& out, const Held& held) {
      out << held.device_bytes << " bytes of the device, " << held.threads << " threads";
      for (const auto& [kind, count] : held.objects) out << ", " << count << " " << kind;
      for (const std::string& file : held.files) out << ", " << file;
      return out;
    }
  };
  Held held() {
    Held held{.device_bytes = device.memory().total_bytes(),
              .objects = LivingObjects::counts(),
              .files = open_files(),
              .threads = thread_count()};
    // So many are kept for whoever draws with the same settings again: one of each a pipeline.
    for (const char* kept : {"pipelines", "pipeline layouts", "descriptor set layouts"})
      held.objects[kept] -= int64_t(pipelines.count());
    return held;
  }

  bool chance(uint32_t one_in) { return random_() % one_in == 0; }
  template <class List>
  const auto& any_of(const List& list) {
    return list[random_() % list.size()];
  }

  void rewrite_effect() {
    const std::array<std::string_view, 3> rates{"rate = 24.0", "rate = 9.0", "rate = oops"};
    write(kRewritten, with(original_, rates[0], any_of(rates)));
  }
  void set_any_option(MethodInstance& instance) {
    const auto fresh = make_method(instance.method->id());
    for (const auto& [name, text] : parameter_texts(*fresh)) set_parameter(*instance.method, name, text);
    std::vector<std::pair<std::string, std::string>> options;
    for (const auto& parameter : parameter_list(*fresh)) {
      const std::string name = parameter.at("name");
      if (parameter.at("type") == "toggle")
        options.emplace_back(name, parameter.at("value") ? "false" : "true");
      if (parameter.at("type") == "choice")
        for (const std::string option : parameter.at("options")) options.emplace_back(name, option);
    }
    if (options.empty()) return;
    const auto& [name, value] = any_of(options);
    const std::string before = parameter_texts(*fresh).at(name);
    set_parameter(*instance.method, name, value);
    if (!instance.method->missing(device).empty()) set_parameter(*instance.method, name, before);
  }
  void switch_instances(Workspace& workspace) {
    const size_t count = workspace.scene().instances.size();
    if (count == 0) return;
    InstanceSwitches& switches = workspace.switches;
    if (chance(2)) switches = {};
    if (chance(2)) switches.muted.insert(random_() % count);
    if (chance(3)) switches.solo.insert(random_() % count);
    if (chance(4)) switches.frozen[random_() % count] = workspace.playback.tick();
  }
  /// Does something to the workspace, as one does who works with it, and draws.
  void step(Workspace& workspace) {
    Side& side = chance(2) ? workspace.a : workspace.b;
    if (chance(40)) workspace.open_scene(any_of(scenes_));
    if (chance(6)) workspace.choose_method(side, random_() % side.methods.size());
    if (chance(8)) set_any_option(side.method());
    if (chance(12)) size_ = {1 + random_() % 97, 1 + random_() % 61};
    if (chance(15)) workspace.compare(Comparison(random_() % 3));
    if (chance(20)) switch_instances(workspace);
    if (chance(25)) side.view.choose(any_of(Inspector::inspections(*side.method().method)));
    if (chance(15)) side.view = {};
    if (chance(30)) workspace.set_camera({.position = {1, 2, float(random_() % 9)}, .target = {0, 1, 0}});
    if (chance(30)) workspace.follow_scene_camera();
    if (chance(60)) rewrite_effect();
    const uint32_t tick = workspace.playback.tick();
    if (chance(12))
      workspace.playback.go_to(uint32_t(random_() % (workspace.playback.last_tick() + 1)));
    else
      workspace.playback.go_to(chance(4) ? tick - std::min(tick, 1u) : tick + 1);
    draw(workspace);
    if (chance(40)) workspace.measure_accuracy();
  }
  void draw(Workspace& workspace) {
    workspace.advance(now_s_ += 1);  // files are looked at every time
    workspace.draw(size_);
    ++frames_;
  }
  /// The picture there, by `method`.
  DrawnPicture at_home(Workspace& workspace, size_t method) {
    workspace.compare(Comparison::kNone);
    workspace.a.view = {};
    workspace.choose_method(workspace.a, method);
    workspace.draw(size_);
    return read_picture(device, *workspace.a.targets);
  }
  void come_home(Workspace& workspace) {
    write(kRewritten, original_);
    workspace.advance(now_s_ += 1);
    workspace.open_scene(kHomeScene);
    workspace.playback.go_to(kHomeTick);
    size_ = kHomeSize;
    for (Side* side : {&workspace.a, &workspace.b}) {
      side->view = {};
      for (MethodInstance& method : side->methods) method.method = make_method(method.method->id());
    }
    const size_t more = random_() % workspace.a.methods.size();
    for (const size_t method : {more, home_method_}) {
      const DrawnPicture picture = at_home(workspace, method);
      const auto& first = first_pictures_.try_emplace(method, picture.linear).first->second;
      ASSERT_EQ(first.pixels, picture.linear.pixels) << workspace.a.methods[method].owner;
    }
  }

  /// Of the heap, with no more pipelines than the method at home draws with.
  uint64_t heap_at_home(Workspace& workspace) {
    pipelines.keep_only(0);
    // The driver lets go of a pipeline with the next work that it is handed.
    for (int i = 0; i < 4; ++i) workspace.draw(size_);
    return heap_bytes();
  }

  uint64_t most_heap(uint64_t first) {
    const bool grows_itself = device.info().driver.starts_with("llvmpipe Mesa 22.");
    return first + kHeapSlack + (grows_itself ? frames_ * kMesa22HeapOfAFrame : 0);
  }

  void soak(uint64_t frames, bool says_where_it_is) {
    const LivingObjects objects(device);
    Workspace workspace = open(presets_.scene(kHomeScene));
    const auto& methods = workspace.a.methods;
    const auto home = std::ranges::find(methods, kHomeMethod, &MethodInstance::owner);
    home_method_ = size_t(home - methods.begin());
    std::optional<Held> first;
    std::optional<uint64_t> first_heap;
    int large_heaps = 0;
    for (int homes = 0; frames_ < frames; ++homes) {
      SCOPED_TRACE(testing::Message() << "frame " << frames_);
      come_home(workspace);
      if (HasFatalFailure()) return;
      const Held now = held();
      if (!first) first = now;
      ASSERT_EQ(*first, now);
      if (says_where_it_is)
        std::cerr << "soak: " << frames_ << " of " << frames << " frames, " << pipelines.count()
                  << " pipelines, " << (heap_bytes() >> 10) << " KiB of the heap, "
                  << (resident_bytes() >> 10) << " KiB resident\n";
      if (homes % kHomesBetweenHeaps == kHomesBetweenHeaps - 1) {
        const uint64_t heap = heap_at_home(workspace);
        if (says_where_it_is) std::cerr << "soak: " << (heap >> 10) << " KiB without other pipelines\n";
        if (!first_heap) first_heap = heap;
        large_heaps = heap > most_heap(*first_heap) ? large_heaps + 1 : 0;
        ASSERT_TRUE(kValidates || large_heaps <= kMostLargeHeaps) << heap << " bytes after " << *first_heap;
      }
      for (int i = 0; i < 50; ++i) step(workspace);
      if (chance(50)) pipelines.reload();
    }
  }

  std::mt19937 random_{1};
  std::string original_;
  std::vector<std::string> scenes_;
  size_t home_method_ = 0;
  std::map<size_t, Image> first_pictures_;  // at home, by method
  glm::uvec2 size_ = kHomeSize;
  double now_s_ = 0;
  uint64_t frames_ = 0;
};

TEST_F(FrameSoakTest, WhateverWasDoneComingHomeFindsEverythingAsItWas) {
  const char* wanted = std::getenv("PLUME_SOAK_FRAMES");
  soak(wanted ? std::stoull(wanted) : 100, wanted != nullptr);
}

}  // namespace
}  // namespace plume
