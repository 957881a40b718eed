// Effects that are edited while they run: what one sees is what the saved file would give.
#include "sandbox/scene/view.h"
#include "sandbox/workspace/emitter_depths.h"
#include "tests/gpu/workspace_test.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEffect = R"(name = "Small"

[[layer]]
name = "near"
camera_offset_m = 0.5

[[emitter]]
name = "puffs"
  [emitter.spawn]
  rate = 60.0
  duration = 100
  life = [20, 40]
  [emitter.shape]
  kind = "sphere"
  radius_m = 0.5
  [emitter.motion]
  speed = [0.5, 1.0]
  [emitter.look]
  layer = "near"
  radius_m = 0.2
  opacity = 0.5
)";

constexpr std::string_view kScene = R"(name = "Three"
duration_ticks = 200
[camera]
position = [0.0, 1.0, 6.0]
target = [0.0, 1.0, 0.0]
[[solid]]
kind = "plane"
size_m = [40.0, 40.0]
[[instance]]
name = "left"
effect = "small"
call_tick = 0
position = [-1.5, 1.0, 0.0]
seed = 1
[instance.layers]
near = 1.0
[[instance]]
name = "right"
effect = "other"
call_tick = 5
position = [1.5, 1.0, 0.0]
seed = 2
[[instance]]
name = "never"
effect = "other"
)";

class EffectEdits : public WorkspaceTest {
 protected:
  EffectEdits() {
    write("effects/small.toml", kEffect);
    write("effects/other.toml", kEffect);
    write("scenes/three.toml", kScene);
  }

  Workspace open(uint32_t tick = 50) { return WorkspaceTest::open(presets_.scene("three"), tick); }
  auto picture(const Workspace& workspace) {
    return read_picture(device, *workspace.a.targets).display.pixels;
  }
  uint64_t anew(
      const std::function<void(Scene&)>& change = [](Scene&) {}, uint32_t tick = 50) {
    Scene scene = presets_.scene("three");
    change(scene);
    Workspace workspace = WorkspaceTest::open(std::move(scene), tick);
    const uint64_t hash = seen(workspace);
    picture_anew_ = picture(workspace);
    return hash;
  }

  std::vector<std::array<uint8_t, 3>> picture_anew_;  // of the last anew()
};

TEST_F(EffectEdits, AnEditedEffectIsTheSavedFileOpenedAnew) {
  Workspace workspace = open();
  const uint64_t before = seen(workspace);
  const auto picture_before = picture(workspace);
  EXPECT_EQ(before, anew());
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("emitter[0].motion.speed", Range<float>{2, 3}).made);
  ASSERT_TRUE(document.add("emitter[0].motion.curl").made);
  ASSERT_TRUE(document.set("emitter[0].look.radius_m", Curve({{0.0f, 0.1f}, {1.0f, 0.4f}})).made);
  EXPECT_TRUE(workspace.advance(0)) << "the picture is out of date";
  const uint64_t edited = seen(workspace);
  const auto picture_edited = picture(workspace);
  EXPECT_NE(edited, before);
  EXPECT_EQ(before, anew()) << "nothing is saved yet";
  workspace.documents.save("small", PresetDocument::OverChanges::kRefuse);
  EXPECT_EQ(edited, anew());
  EXPECT_EQ(picture_edited, picture_anew_);
  while (document.undo()) continue;
  EXPECT_EQ(before, seen(workspace));
  EXPECT_EQ(picture_before, picture(workspace));
}

TEST_F(EffectEdits, MutedAndNotSoloAreAsIfNotInTheScene) {
  Workspace workspace = open();
  const uint64_t both = seen(workspace);
  const uint64_t left = anew([](Scene& scene) { scene.instances.erase(scene.instances.begin() + 1); });
  const auto picture_left = picture_anew_;
  const uint64_t right = anew([](Scene& scene) { scene.instances.erase(scene.instances.begin()); });
  EXPECT_NE(left, right);
  workspace.switches.muted = {1};
  EXPECT_EQ(left, seen(workspace));
  EXPECT_EQ(picture_left, picture(workspace));
  EXPECT_EQ("muted", workspace.stage().demand()[1].why);
  EXPECT_EQ("not called", workspace.stage().demand()[2].why);
  EXPECT_FALSE(workspace.stage().call_of(1));
  workspace.switches.muted = {};
  workspace.switches.solo = {1};
  EXPECT_EQ(right, seen(workspace));
  EXPECT_EQ("muted", workspace.stage().demand()[0].why);
  EXPECT_EQ(0u, workspace.stage().call_of(1));
  workspace.switches.solo = {};
  EXPECT_EQ(both, seen(workspace));
}

TEST_F(EffectEdits, AFrozenInstanceStaysAsItWasAndTheOthersGoOn) {
  const auto frozen = [](Scene& scene) { scene.instances[0].freezes = {{40, 100}}; };
  Workspace workspace = open(40);
  seen(workspace);
  workspace.switches.frozen[0] = 40;
  workspace.playback.go_to(55);
  EXPECT_EQ(anew(frozen, 55), seen(workspace));
  EXPECT_EQ("frozen at its tick 40", workspace.stage().demand()[0].why);
  workspace.switches.frozen.clear();
  EXPECT_EQ(anew([](Scene&) {}, 55), seen(workspace));
}

TEST_F(EffectEdits, ABrokenFileKeepsTheLastGoodEffectAndSaysWhere) {
  Workspace workspace = open();
  workspace.advance(0);
  const uint64_t before = seen(workspace);
  const std::string broken = with(kEffect, "[0.5, 1.0]", "[0.5, oops]");
  write("effects/small.toml", broken);
  workspace.advance(1);
  EXPECT_EQ(before, seen(workspace));
  const auto& diagnostics = workspace.documents.open("small").diagnostics();
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(to_string(diagnostics[0]).rfind((root_ / "effects/small.toml").string() + ":17:17: ", 0), 0u)
      << to_string(diagnostics[0]);
  write("effects/small.toml", with(kEffect, "[0.5, 1.0]", "[2.5, 3.0]"));
  workspace.advance(1.1);
  EXPECT_EQ(before, seen(workspace)) << "it looks four times a second";
  EXPECT_TRUE(workspace.advance(2));
  const uint64_t mended = seen(workspace);
  EXPECT_NE(before, mended);
  EXPECT_EQ(anew(), mended);
}

TEST_F(EffectEdits, WhatIsNotSavedIsNotLostToAChangeOnDisk) {
  Workspace workspace = open();
  workspace.advance(0);
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("emitter[0].shape.radius_m", 1.5f).made);
  const std::string mine = document.text();
  const uint64_t edited = seen(workspace);
  write("effects/small.toml", with(kEffect, "[0.5, 1.0]", "[2.5, 3.0]"));
  workspace.advance(1);
  using enum OpenDocuments::OnDisk;
  EXPECT_EQ(workspace.documents.on_disk("small"), kChanged);
  workspace.advance(2);
  EXPECT_EQ(workspace.documents.on_disk("small"), kChanged) << "until it is decided";
  EXPECT_EQ(edited, seen(workspace));
  EXPECT_THROW(workspace.documents.save("small", PresetDocument::OverChanges::kRefuse), ChangedOnDisk);
  workspace.documents.reload("small");
  EXPECT_EQ(workspace.documents.on_disk("small"), kSame);
  EXPECT_EQ(anew(), seen(workspace));
  EXPECT_TRUE(workspace.documents.unsaved().empty());
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(mine, document.text()) << "nothing is lost by reading";
  fs::remove(root_ / "effects/small.toml");
  workspace.advance(3);
  EXPECT_EQ(workspace.documents.on_disk("small"), kGone);
  workspace.documents.save("small", PresetDocument::OverChanges::kOverwrite);
  EXPECT_EQ(workspace.documents.on_disk("small"), kSame);
  EXPECT_EQ(anew(), seen(workspace));
}

TEST_F(EffectEdits, WhatTheSceneCannotBearIsRefusedAndTheLastGoodStays) {
  Workspace workspace = open();
  const uint64_t before = seen(workspace);
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("layer[0].name", std::string("front")).made);
  EXPECT_EQ(before, seen(workspace));
  EXPECT_NE(workspace.refused_edits().find("three.toml:"), std::string::npos) << workspace.refused_edits();
  EXPECT_FALSE(workspace.advance(1)) << "it is not tried again and again";
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(before, seen(workspace));
  EXPECT_EQ(workspace.refused_edits(), "");
}

TEST_F(EffectEdits, WhatIsNotEditedIsNotBroughtFromItsBirthAgain) {
  Workspace workspace = open();
  workspace.draw(kSize);
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("emitter[0].look.opacity", Curve(0.9f)).made);
  workspace.draw(kSize);
  EXPECT_EQ(workspace.stage().demand()[0].ticks_simulated, 0u) << "what it looks like moves nothing";
  ASSERT_TRUE(document.set("emitter[0].motion.drag", 0.5f).made);
  workspace.draw(kSize);
  const auto demand = workspace.stage().demand();
  EXPECT_GT(demand[0].ticks_simulated, 0u);
  EXPECT_EQ(demand[1].ticks_simulated, 0u);
  EXPECT_TRUE(demand[1].why.starts_with("has ")) << demand[1].why;
  workspace.switches.muted = {0};
  const uint64_t right = seen(workspace);
  EXPECT_EQ(workspace.stage().demand()[1].ticks_simulated, 0u);
  EXPECT_EQ(right, anew([](Scene& scene) { scene.instances.erase(scene.instances.begin()); }));
  ASSERT_TRUE(workspace.drop_effect("other", {0.5f, 0.9f}));
  workspace.draw(kSize);
  EXPECT_EQ(workspace.stage().demand()[1].ticks_simulated, 0u);
}

TEST_F(EffectEdits, OnlyAnEditedEmitterAndItsChildrenAreBroughtFromTheirBirth) {
  const auto emitter = [](std::string_view name) {
    std::string text(kEffect.substr(kEffect.find("[[emitter]]")));
    return "\n" + text.replace(text.find("puffs"), 5, name);
  };
  std::string child = emitter("child");
  child.replace(child.find("  rate"), child.find("  life") - child.find("  rate"), "");
  child.insert(child.find("  [emitter.spawn]"),
               "  [emitter.parent]\n  emitter = \"second\"\n  on = \"birth\"\n");
  write("effects/small.toml", std::string(kEffect) + emitter("second") + child);
  const auto ticks = [](const Workspace& workspace) {
    std::map<std::string, bool> sought;
    const Instances& all = workspace.stage().simulation().instances();
    for (uint32_t i = 0; i < all.calls[0].described().size(); ++i)
      sought[all.calls[0].described()[i].name] = all.emitter_of(0, i).ticks > 0;
    return sought;
  };
  using Sought = std::map<std::string, bool>;
  Workspace workspace = open();
  workspace.draw(kSize);
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("emitter[1].motion.drag", 0.5f).made);
  const uint64_t edited = seen(workspace);
  EXPECT_EQ(ticks(workspace), (Sought{{"puffs", false}, {"second", true}, {"child", true}}));
  ASSERT_TRUE(document.set("emitter[2].motion.drag", 0.25f).made);
  seen(workspace);
  EXPECT_EQ(ticks(workspace), (Sought{{"puffs", false}, {"second", false}, {"child", true}}));
  ASSERT_TRUE(document.undo());
  EXPECT_EQ(seen(workspace), edited);
  ASSERT_TRUE(document.remove("emitter[0]").made);  // the others move up
  const uint64_t without = seen(workspace);
  EXPECT_EQ(ticks(workspace), (Sought{{"second", false}, {"child", false}}));
  workspace.documents.save("small", PresetDocument::OverChanges::kRefuse);
  EXPECT_EQ(without, anew());
  ASSERT_TRUE(document.set("emitter[1].name", std::string("renamed")).made);  // what it is drawn from
  const uint64_t renamed = seen(workspace);
  EXPECT_EQ(ticks(workspace), (Sought{{"second", false}, {"renamed", true}}));
  workspace.documents.save("small", PresetDocument::OverChanges::kRefuse);
  EXPECT_EQ(renamed, anew());
}

TEST_F(EffectEdits, AnEditThatBendsLightMakesTheImageForIt) {
  Workspace workspace = open();
  workspace.draw(kSize);
  EXPECT_FALSE(workspace.a.targets->distortion);
  PresetDocument& document = workspace.documents.open("small");
  ASSERT_TRUE(document.set("emitter[0].look.opacity", Curve(0.0f)).made);
  ASSERT_TRUE(document.set("emitter[0].look.distortion_deg", 2.0f).made);
  workspace.draw(kSize);
  EXPECT_TRUE(workspace.a.targets->distortion);
}

TEST_F(EffectEdits, EditsOutliveAnotherScene) {
  Workspace workspace = open();
  ASSERT_TRUE(workspace.documents.open("small").set("emitter[0].motion.speed", Range<float>{2, 3}).made);
  workspace.switches.muted = {1};
  const uint64_t edited = seen(workspace);
  workspace.open_scene("three");
  EXPECT_TRUE(workspace.switches.muted.empty()) << "instances are others";
  workspace.playback.go_to(50);
  EXPECT_NE(edited, seen(workspace));
  workspace.switches.muted = {1};
  EXPECT_EQ(edited, seen(workspace));
}

TEST_F(EffectEdits, ADroppedEffectStandsWhereOneClicksAndStartsThen) {
  Workspace workspace = open();
  workspace.draw(kSize);
  EXPECT_FALSE(workspace.drop_effect("small", {0.5f, 0.1f})) << "the sky bears nothing";
  ASSERT_TRUE(workspace.drop_effect("small", {0.25f, 0.9f}));
  ASSERT_EQ(workspace.scene().instances.size(), 4u);
  const Instance& dropped = workspace.scene().instances.back();
  EXPECT_EQ(dropped.name, "small");
  EXPECT_EQ(dropped.call_tick, 50u);
  EXPECT_NEAR(dropped.position.y, 0, 1e-3);
  const auto view = make_view(workspace.scene(), workspace.camera(), kSize, 50);
  const glm::vec4 clip = view.view_projection * glm::vec4(dropped.position, 1);
  EXPECT_NEAR(clip.x / clip.w * 0.5f + 0.5f, 0.25f, 0.5f / kSize.x + 1e-4f);
  EXPECT_NEAR(clip.y / clip.w * 0.5f + 0.5f, 0.9f, 0.5f / kSize.y + 1e-4f);
  workspace.playback.go_to(80);
  workspace.draw(kSize);
  EXPECT_TRUE(workspace.stage().demand()[3].awake) << workspace.stage().demand()[3].why;
  ASSERT_TRUE(workspace.drop_effect("small", {0.25f, 0.9f}));
  EXPECT_EQ(workspace.scene().instances.back().name, "small 2");
  EXPECT_THROW(workspace.drop_effect("smal", {0.25f, 0.9f}), std::runtime_error);
  EXPECT_EQ(workspace.scene().instances.size(), 5u);
}

TEST_F(EffectEdits, ACameraOffsetMovesParticlesToOtherSlices) {
  Workspace workspace = open();
  workspace.draw(kSize);
  const auto emitters = emitter_depths(workspace.stage(), 0, workspace.camera());
  ASSERT_EQ(emitters.size(), 1u);
  EXPECT_EQ(emitters[0].offset_m, 1.0f) << "the scene says so of its layer";
  const auto& depths = emitters[0].depths_m;
  ASSERT_GT(depths.size(), 20u);
  EXPECT_LE(depths.size(), 40u);
  EXPECT_GT(depths.front(), 6 - 0.5 - 40 / 60.0 - 0.1) << "the camera is 6 m away, the ball 0.5 m wide";
  EXPECT_LT(depths.back(), 6 + 0.5 + 40 / 60.0 + 0.1);
  EXPECT_EQ(emitters[0].drawn_m(6, 0.1f), 5);
  EXPECT_EQ(emitters[0].drawn_m(1.1f, 0.1f), 0.2f) << "nothing is drawn at the camera";
  EXPECT_TRUE(emitter_depths(workspace.stage(), 2, workspace.camera()).empty()) << "not called";

  SlicedDepth slices = sliced_depth(device, workspace.a.method());
  ASSERT_TRUE(slices.curve);
  EXPECT_LT(slices.curve->slice(emitters[0].drawn_m(6, 0.1f)), slices.curve->slice(6) - 1) << "another slice";
  const uint32_t finest = slices.curve->count;
  set_parameter(*workspace.a.method().method, "slices", "32");
  workspace.change();
  workspace.draw(kSize);
  slices = sliced_depth(device, workspace.a.method());
  ASSERT_TRUE(slices.curve);
  EXPECT_LT(slices.curve->count, finest) << "as many as the frame had use for";
  const DepthCurve& curve = *slices.curve;
  EXPECT_EQ(curve.slice(0), 0);
  EXPECT_EQ(curve.slice(curve.b), float(curve.count));
  EXPECT_NEAR(curve.depth_m(curve.slice(7.5f)), 7.5f, 1e-4f);

  // Each physical slice is the part of the virtual one that the curve puts it into.
  ASSERT_GT(slices.physical.size(), 4u);
  for (size_t i = 0; i < slices.physical.size(); ++i) {
    const DepthSlice& slice = slices.physical[i];
    const float middle = 0.5f * (slice.near_m + slice.far_m);
    EXPECT_EQ(uint32_t(curve.slice(middle)), slice.virtual_slice) << i;
    EXPECT_EQ(slices.physical_at(middle), i);
  }
  EXPECT_FALSE(slices.physical_at(0.5f * slices.physical.front().near_m)) << "nothing is there";
  EXPECT_FALSE(slices.physical_at(2 * slices.physical.back().far_m));
  for (const float depth : depths)
    EXPECT_TRUE(slices.physical_at(emitters[0].drawn_m(depth, 0.1f))) << "a particle is in a slice";

  const auto wboit = std::ranges::find(workspace.a.methods, std::string("wboit"), &MethodInstance::owner);
  workspace.choose_method(workspace.a, size_t(wboit - workspace.a.methods.begin()));
  workspace.draw(kSize);
  const SlicedDepth none = sliced_depth(device, workspace.a.method());
  EXPECT_FALSE(none.curve);
  EXPECT_TRUE(none.physical.empty());
}

TEST_F(EffectEdits, AChangedMeshIsWhatItsParticlesAreBornOn) {
  const auto triangle = [](float x) {
    return fmt::format("v {0} 0 0\nv {1} 0 0\nv {0} 0.5 0\nf 1 2 3\n", x, x + 0.5f);
  };
  fs::create_directories(root_ / "meshes");
  write("meshes/tri.obj", triangle(0));
  write("effects/small.toml",
        with(kEffect, "kind = \"sphere\"\n  radius_m = 0.5", "kind = \"mesh\"\n  mesh = \"tri\""));
  Workspace workspace = open();
  const uint64_t before = seen(workspace);
  write("meshes/tri.obj", triangle(1));
  ASSERT_TRUE(workspace.advance(1));
  const uint64_t after = seen(workspace);
  EXPECT_NE(after, before);
  EXPECT_EQ(after, anew()) << "those alive were born on it too";
  write("meshes/tri.obj", "v 1 oops\n");
  workspace.advance(2);
  EXPECT_EQ(seen(workspace), after) << "the last good one";
  const auto& mistakes = workspace.documents.open("small").diagnostics();
  ASSERT_FALSE(mistakes.empty());
  EXPECT_EQ(mistakes[0].file, (root_ / "meshes/tri.obj").string());
}

TEST_F(EffectEdits, AccuracyIsMeasuredOnceAPicture) {
  Workspace workspace = open();
  workspace.compares = true;
  workspace.draw(kSize);
  const auto shown = picture(workspace);
  ASSERT_TRUE(workspace.measure_accuracy());
  ASSERT_EQ(workspace.accuracy().entries().size(), 1u);
  const AccuracyLog::Entry first = workspace.accuracy().entries()[0];
  EXPECT_EQ(first.method, "avboit");
  EXPECT_GT(first.rmse, 1e-5);
  EXPECT_LT(first.rmse, 0.05);
  EXPECT_GT(first.ms, 0);
  EXPECT_TRUE(workspace.is_outdated()) << "the reference stands where the picture was";
  workspace.draw(kSize);
  EXPECT_EQ(picture(workspace), shown);
  EXPECT_FALSE(workspace.measure_accuracy()) << "it was";

  const auto wboit = std::ranges::find(workspace.a.methods, std::string("wboit"), &MethodInstance::owner);
  workspace.choose_method(workspace.a, size_t(wboit - workspace.a.methods.begin()));
  workspace.draw(kSize);
  ASSERT_TRUE(workspace.measure_accuracy());
  EXPECT_FALSE(workspace.is_outdated()) << "the reference was drawn before";
  ASSERT_EQ(workspace.accuracy().entries().size(), 2u);
  EXPECT_GT(workspace.accuracy().entries()[1].rmse, 2 * first.rmse);
  workspace.playback.go_to(51);
  workspace.change();
  workspace.draw(kSize);
  EXPECT_TRUE(workspace.accuracy().entries().empty()) << "of another tick";
}

TEST_F(EffectEdits, ViewsBeginWithASliceInUseAndShareTheirScale) {
  Workspace workspace = open();
  const auto look = [&](Side& side, const char* view) {
    side.view.choose(*Inspector::find(*side.method().method, view));
    workspace.change();
  };
  look(workspace.a, "extinction");
  workspace.draw(kSize);
  ASSERT_TRUE(workspace.a.view.shown);
  EXPECT_EQ(workspace.a.view.shown->slice, workspace.a.view.shown->slices.size() / 2);
  EXPECT_EQ(workspace.a.view.slice, workspace.a.view.shown->slice);
  EXPECT_GT(workspace.a.view.found.count, 0u) << "something is there";

  workspace.compare(Comparison::kSplit);
  look(workspace.a, "shaded");
  look(workspace.b, "shaded");
  const auto avboit =
      std::ranges::find(workspace.b.methods, std::string("avboit (B)"), &MethodInstance::owner);
  workspace.choose_method(workspace.b, size_t(avboit - workspace.b.methods.begin()));
  set_parameter(*workspace.b.method().method, "half_particles", "true");
  set_parameter(*workspace.b.method().method, "small_cells", "0");
  workspace.draw(kSize);
  const SideView &a = workspace.a.view, &b = workspace.b.view;
  ASSERT_NE(a.found.most, b.found.most) << "they differ";
  EXPECT_EQ(a.scale.low, b.scale.low);
  EXPECT_EQ(a.scale.high, b.scale.high);
  EXPECT_EQ(a.scale.high, std::max(a.found.most, b.found.most));
  EXPECT_EQ(picture(workspace), image_of(*a.shown, a.scale).pixels) << "and are drawn so";
  workspace.b.view.range = SideView::Range::kHeld;
  workspace.b.view.held = {0, 2};
  workspace.draw(kSize);
  EXPECT_EQ(b.scale.high, 2);
  EXPECT_EQ(a.scale.high, a.found.most);
}

}  // namespace
}  // namespace plume
