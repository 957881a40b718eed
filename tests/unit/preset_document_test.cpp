#include "sandbox/presets/preset_document.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/preset_file.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSmall = R"(# about
name = "Small"   # its name

[[layer]]
name = "near"
camera_offset_m = 1.0

[[emitter]]
name = "smoke"
  [emitter.spawn]
  rate = 20.0
  duration = 60
  life = [30, 60]
  [emitter.shape]
  kind = "sphere"   # round
  radius_m = 0.50
  thickness = 0.2
  [emitter.motion]
  speed = [1.0, 2.0]
    [[emitter.motion.attractor]]
    position = [0.0, 1.0, 0.0]
    strength = 2.0
  [emitter.look]
  layer = "near"
  radius_m = [[0.0, 0.1], [1.0, 0.5]]
  cross_section_m2 = 0.2

[[emitter]]
name = "trail"
  [emitter.parent]
  emitter = "smoke"
  on = "life"
  every_ticks = 5
  [emitter.spawn]
  life = 20
  [emitter.look]
  opacity = 0.5
)";

/// A folder of presets with one effect.
class PresetDocumentTest : public testing::Test {
 protected:
  PresetDocumentTest() {
    fs::remove_all(root_);
    fs::create_directories(root_ / "effects");
    fs::create_directories(root_ / "meshes");
    fs::copy(fs::path(PLUME_SOURCE_PRESETS) / "meshes", root_ / "meshes", fs::copy_options::recursive);
    write(kSmall);
  }
  ~PresetDocumentTest() override { fs::remove_all(root_); }

  void write(std::string_view text) const { std::ofstream(file_, std::ios::binary) << text; }
  PresetDocument open() const { return {file_, PresetKind::kEffect, PresetLibrary(root_)}; }

  const fs::path root_ = fs::path(testing::TempDir()) / fmt::format("plume_document_{}", ::getpid());
  const fs::path file_ = root_ / "effects" / "small.toml";
};

std::string said(const PresetDocument::Outcome& outcome) {
  std::string lines = outcome.made ? "" : "refused\n";
  for (const Diagnostic& d : outcome.diagnostics)
    lines += fmt::format("{}:{}: {}\n", d.line, d.column, d.message);
  return lines;
}

std::string with(std::string text, std::string_view old, std::string_view by) {
  const size_t at = text.find(old);
  EXPECT_NE(at, text.npos) << old;
  return text.replace(at, old.size(), by);
}

TEST_F(PresetDocumentTest, SetsOneValueAndLeavesTheRest) {
  PresetDocument document = open();
  ASSERT_TRUE(document.effect());
  EXPECT_EQ(said(document.set("emitter[0].shape.thickness", 0.3f)), "");
  EXPECT_EQ(document.text(), with(std::string(kSmall), "thickness = 0.2", "thickness = 0.3"));
  EXPECT_EQ(document.effect()->emitters[0].shape.thickness, 0.3f);
  EXPECT_EQ(document.undo_name(), "Set smoke: shape.thickness");
  EXPECT_TRUE(document.is_changed());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.text(), kSmall);
  EXPECT_EQ(document.effect()->emitters[0].shape.thickness, 0.2f);
  EXPECT_FALSE(document.is_changed());
  EXPECT_FALSE(document.undo());
  EXPECT_EQ(document.redo_name(), "Set smoke: shape.thickness");
  EXPECT_TRUE(document.redo());
  EXPECT_EQ(document.effect()->emitters[0].shape.thickness, 0.3f);
}

TEST_F(PresetDocumentTest, RefusesWhatWouldBeWrong) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].shape.thickness", 1.5f)),
            "refused\n17:15: `thickness` is 1.5, expected a number from 0 to 1\n");
  EXPECT_EQ(said(document.remove("emitter[0].look")),
            "refused\n8:1: missing key `look` in [[emitter]], expected a table [look]\n");
  EXPECT_FALSE(document.remove("emitter[0]").made) << "the trail needs it";
  EXPECT_EQ(said(document.set("emitter[0].spawn.rate", 1e6)).substr(0, 8), "refused\n") << "too many";
  EXPECT_EQ(document.text(), kSmall);
  EXPECT_EQ(document.undo_name(), "");
  EXPECT_THROW(document.set("emitter[0].shape.size_m", glm::vec3(1)), std::invalid_argument);
  EXPECT_THROW(document.set("emitter[0].shape.thickness", true), std::invalid_argument);
}

TEST_F(PresetDocumentTest, TurnsASphereIntoAConeInOneStep) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].shape.kind", std::string("cone"))), "");
  EXPECT_EQ(document.text(), with(with(std::string(kSmall), "\"sphere\"", "\"cone\""), "thickness = 0.2\n",
                                  "thickness = 0.2\n  angle_deg = 20.0\n"));
  EXPECT_EQ(said(document.set("emitter[0].shape.kind", std::string("point"))), "");
  EXPECT_EQ(document.text(), with(with(std::string(kSmall), "\"sphere\"", "\"point\""),
                                  "  radius_m = 0.50\n  thickness = 0.2\n", ""));
  const std::vector<std::string> kinds = document.field("emitter[0].shape.kind")->options;
  for (const std::string& kind : kinds)
    EXPECT_EQ(said(document.set("emitter[0].shape.kind", kind)), "") << kind;
}

TEST_F(PresetDocumentTest, LetsGoWhatCannotStandBesideWhatWasSet) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].look.opacity", Curve(0.25f))), "");
  EXPECT_EQ(document.text(), with(std::string(kSmall), "cross_section_m2 = 0.2", "opacity = 0.25"));
  EXPECT_EQ(said(document.set("emitter[0].motion.attractor[0].to", glm::vec3(0, 2, 0))), "");
  EXPECT_FALSE(document.field("emitter[0].motion.attractor[0].position")->present());
  EXPECT_EQ(document.effect()->emitters[0].motion.attractors[0].to_m, glm::vec3(0, 2, 0));
  EXPECT_EQ(said(document.remove("emitter[0].look.opacity")).substr(0, 8), "refused\n");
}

TEST_F(PresetDocumentTest, TurnsAConstantRateIntoKeysAndBack) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].spawn.rate", Pairs{{0, 20}, {40, 7.5}})), "");
  EXPECT_EQ(document.text(),
            with(std::string(kSmall), "rate = 20.0\n  duration = 60\n", "rate = [[0, 20.0], [40, 7.5]]\n"));
  EXPECT_EQ(said(document.set("emitter[0].spawn.rate", 5.0)), "");
  EXPECT_EQ(document.effect()->emitters[0].spawn.rate.back().tick, 120u);
  EXPECT_THROW(document.set("emitter[0].spawn.per_metre", Pairs{{0, 20}, {40, 7.5}}), std::invalid_argument);
}

TEST_F(PresetDocumentTest, MakesPiecesSolidAndBack) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].look.mesh", Texts{"shard_a", "shard_b"})), "");
  EXPECT_EQ(said(document.set("emitter[0].look.opaque", true)), "");
  EXPECT_FALSE(document.field("emitter[0].look.cross_section_m2"));
  EXPECT_EQ(said(document.set("emitter[0].look.opaque", false)), "");
  EXPECT_EQ(document.field("emitter[0].look.opacity")->value, FieldValue(Curve(0.8f)));
  EXPECT_EQ(said(document.set("emitter[0].look.mesh", Texts{"no such"})).substr(0, 8), "refused\n");
}

TEST_F(PresetDocumentTest, AddsTablesWithWhatTheyNeed) {
  PresetDocument document = open();
  for (const char* path :
       {"emitter[0].motion.curl", "emitter[0].motion.collision", "emitter[1].motion.vortex",
        "emitter[0].motion.attractor", "emitter[0].motion.kill", "emitter[0].motion.kill", "emitter[1].shape",
        "bounds", "layer", "emitter", "emitter[2].parent"})
    EXPECT_EQ(said(document.add(path)), "") << path << "\n" << document.text();
  const Effect& effect = *document.effect();
  ASSERT_EQ(effect.emitters.size(), 3u);
  EXPECT_EQ(effect.emitters[2].name, "emitter");
  EXPECT_EQ(effect.emitters[2].parent->emitter, "smoke");
  EXPECT_TRUE(effect.emitters[2].spawn.rate.empty()) << "children have no rate";
  EXPECT_EQ(effect.emitters[0].motion.attractors.size(), 2u);
  EXPECT_EQ(effect.layers[1].name, "layer");
  EXPECT_EQ(said(document.add("emitter")), "");
  EXPECT_EQ(document.effect()->emitters[3].name, "emitter 2");
  EXPECT_EQ(document.effect()->emitters[3].spawn.rate.size(), 2u);
  EXPECT_EQ(said(document.set("emitter[3].motion.curl.strength", 3.0f)), "") << "tables on the way are made";
  EXPECT_EQ(said(document.remove("emitter[3]")), "");
  EXPECT_EQ(said(document.remove("emitter[0].motion.kill[0]")), "");
  while (document.undo()) continue;
  EXPECT_EQ(document.text(), kSmall);
}

TEST_F(PresetDocumentTest, RenamesWhatIsNamedElsewhere) {
  PresetDocument document = open();
  EXPECT_EQ(said(document.set("emitter[0].name", std::string("fume"))), "");
  EXPECT_EQ(document.effect()->emitters[1].parent->emitter, "fume");
  EXPECT_EQ(said(document.set("layer[0].name", std::string("close"))), "");
  EXPECT_EQ(document.effect()->emitters[0].look.layer, "close");
  EXPECT_EQ(document.field("emitter[0].look.layer")->options, std::vector<std::string>{"close"});
  EXPECT_EQ(said(document.set("emitter[1].name", std::string("fume"))).substr(0, 8), "refused\n");
}

TEST_F(PresetDocumentTest, MergesADragIntoOneStep) {
  PresetDocument document = open();
  using enum PresetDocument::Gesture;
  for (const float radius : {0.6f, 0.7f, 0.8f}) document.set("emitter[0].shape.radius_m", radius, kGoesOn);
  document.end_gesture();
  for (const float radius : {0.9f, 1.0f}) document.set("emitter[0].shape.radius_m", radius, kGoesOn);
  document.set("emitter[0].shape.thickness", 0.5f, kGoesOn);
  EXPECT_TRUE(document.undo());
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.effect()->emitters[0].shape.radius_m, 0.8f);
  EXPECT_TRUE(document.undo());
  EXPECT_EQ(document.text(), kSmall);
}

TEST_F(PresetDocumentTest, SavesOverWhatItReadAndNothingElse) {
  ASSERT_EQ(::chmod(file_.c_str(), 0640), 0);
  PresetDocument document = open();
  document.set("emitter[0].shape.thickness", 0.3f);
  document.save();
  EXPECT_EQ(load_text(file_), document.text());
  EXPECT_EQ(fs::status(file_).permissions(), fs::perms(0640));
  EXPECT_FALSE(document.is_changed());
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kSame) << "our own writing is no news";

  write(with(std::string(kSmall), "0.50", "0.75"));
  document.set("emitter[0].shape.thickness", 0.4f);
  EXPECT_THROW(document.save(), ChangedOnDisk);
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kConflict);
  EXPECT_THROW(document.save(), ChangedOnDisk) << "told is not decided";
  document.save(PresetDocument::OverChanges::kOverwrite);
  EXPECT_EQ(load_text(file_), document.text());
  fs::remove(file_);
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kGone);
  EXPECT_THROW(document.save(), ChangedOnDisk);
  document.save(PresetDocument::OverChanges::kOverwrite);
  EXPECT_EQ(load_text(file_), document.text());
}

TEST_F(PresetDocumentTest, SavesThroughALink) {
  const fs::path link = root_ / "effects" / "link.toml";
  fs::create_symlink(file_, link);
  PresetDocument document(link, PresetKind::kEffect, PresetLibrary(root_));
  document.set("emitter[0].shape.thickness", 0.3f);
  document.save();
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(load_text(file_), document.text());
}

TEST_F(PresetDocumentTest, KeepsTheLastGoodEffectWhenItsFileBreaks) {
  PresetDocument document = open();
  const uint64_t revision = document.revision();
  write(with(std::string(kSmall), "thickness = 0.2", "thickness = 2"));
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kReloaded);
  ASSERT_EQ(document.diagnostics().size(), 1u);
  EXPECT_EQ(to_string(document.diagnostics()[0]),
            file_.string() + ":17:15: `thickness` is 2, expected a number from 0 to 1");
  EXPECT_EQ(document.effect()->emitters[0].shape.thickness, 0.2f);
  EXPECT_EQ(document.revision(), revision);
  EXPECT_EQ(said(document.set("emitter[0].shape.radius_m", 1.0f)),
            "17:15: `thickness` is 2, expected a number from 0 to 1\n")
      << "other fields can be set meanwhile";
  EXPECT_EQ(said(document.set("emitter[0].shape.thickness", 0.2f)), "") << "and this one mended";
  EXPECT_EQ(document.effect()->emitters[0].shape.radius_m, 1.0f);

  document.save();
  write("name = \"Small\n");
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kReloaded);
  ASSERT_EQ(document.diagnostics().size(), 1u);
  EXPECT_EQ(document.diagnostics()[0].line, 1u);
  EXPECT_EQ(said(document.set("name", std::string("x"))).substr(0, 8), "refused\n");
  EXPECT_EQ(document.effect()->emitters[0].shape.radius_m, 1.0f);
  write(kSmall);
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kReloaded);
  EXPECT_TRUE(document.diagnostics().empty());
  EXPECT_EQ(document.effect()->emitters[0].shape.radius_m, 0.5f);
}

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(PresetDocumentTest, ReadsAChangedMeshAnew) {
  const fs::path mesh = root_ / "meshes" / "tri.obj";
  const auto write_mesh = [&](std::string_view text) { std::ofstream(mesh, std::ios::binary) << text; };
  write_mesh(kTriangle);
  write(with(std::string(kSmall), "kind = \"sphere\"   # round\n  radius_m = 0.50\n  thickness = 0.2",
             "kind = \"mesh\"\n  mesh = \"tri\""));
  PresetDocument document = open();
  const auto corner = [&] { return document.effect()->meshes.at(0).triangles.at(0)[1].x; };
  ASSERT_EQ(corner(), 1.0f);
  uint64_t revision = document.revision();
  EXPECT_EQ(document.poll(), PresetDocument::Disk::kSame);
  EXPECT_EQ(document.revision(), revision) << "nothing was changed";

  write_mesh(with(std::string(kTriangle), "v 1 0 0", "v 2 0 0"));
  document.poll();
  EXPECT_EQ(corner(), 2.0f);
  EXPECT_GT(document.revision(), revision);
  EXPECT_FALSE(document.is_changed()) << "its own text is as it was";
  EXPECT_FALSE(document.undo());

  revision = document.revision();
  write_mesh("v 1 0\n");
  document.poll();
  ASSERT_FALSE(document.diagnostics().empty());
  EXPECT_EQ(document.diagnostics()[0].file, mesh.string());
  EXPECT_EQ(document.diagnostics()[0].line, 1u);
  EXPECT_EQ(corner(), 2.0f) << "the last good one";
  EXPECT_EQ(document.revision(), revision);

  fs::remove(mesh);
  document.poll();
  ASSERT_FALSE(document.diagnostics().empty());
  EXPECT_EQ(document.diagnostics()[0].file, file_.string()) << "where it is named";
  write_mesh(kTriangle);
  document.poll();
  EXPECT_TRUE(document.diagnostics().empty());
  EXPECT_EQ(corner(), 1.0f);
}

TEST_F(PresetDocumentTest, ReadsAChangedVectorFieldAnew) {
  fs::create_directories(root_ / "fields");
  const fs::path field = root_ / "fields" / "flow.fga";
  const auto write_field = [&](std::string_view text) { std::ofstream(field, std::ios::binary) << text; };
  write_field("1,1,1, 0,0,0, 1,1,1, 0,1,0");
  PresetDocument document = open();
  const std::string text = with(std::string(kSmall), "  [emitter.look]\n  layer",
                                "    [emitter.motion.field]\n    file = \"flow\"\n    as = \"force\"\n"
                                "  [emitter.look]\n  layer");
  write(text);
  ASSERT_EQ(document.poll(), PresetDocument::Disk::kReloaded);
  ASSERT_TRUE(document.diagnostics().empty()) << to_string(document.diagnostics()[0]);
  const auto up = [&] { return document.effect()->emitters[0].motion.field->grid->cells[0].y; };
  ASSERT_EQ(up(), 1.0f);
  write_field("1,1,1, 0,0,0, 1,1,1, 0,3,0");
  document.poll();
  EXPECT_EQ(up(), 3.0f);
  write_field("1,1,1,\n0,0,0, 1,1,1, 0,oops,0");
  document.poll();
  ASSERT_EQ(document.diagnostics().size(), 1u);
  EXPECT_NE(document.diagnostics()[0].message.find(field.string() + ":2:"), std::string::npos)
      << document.diagnostics()[0].message;
  EXPECT_EQ(up(), 3.0f);
}

TEST_F(PresetDocumentTest, EditsScenesToo) {
  const fs::path path = root_ / "scenes" / "s.toml";
  fs::create_directories(path.parent_path());
  std::ofstream(path) << "name = \"S\"\n[camera]\nposition = [0, 1, 5]\ntarget = [0, 1, 0]\n";
  PresetDocument document(path, PresetKind::kScene, PresetLibrary(root_));
  ASSERT_TRUE(document.scene());
  EXPECT_EQ(said(document.set("wind", glm::vec3(1, 0, 0))), "");
  EXPECT_EQ(document.scene()->wind, glm::vec3(1, 0, 0));
  EXPECT_EQ(said(document.add("instance")), "");
  EXPECT_EQ(document.scene()->instances.at(0).effect, "small");
  EXPECT_EQ(said(document.set("camera[0].vertical_fov_deg", 40.0f)), "");
  EXPECT_EQ(said(document.add("camera")).substr(0, 8), "refused\n") << "it has no later tick yet";
}

/// A value of a field that its limits allow, other than now.
std::optional<FieldValue> random_value(const Field& field, std::mt19937& random) {
  const auto number = [&](Limits limits) {
    const double near = std::min(limits.max - limits.min, 10.0);
    const double low = std::max(limits.min, std::min(-5.0, limits.max - near));
    return std::clamp(low + near * std::uniform_real_distribution<double>()(random), limits.min, limits.max);
  };
  const auto f = [&] { return static_cast<float>(number(field.limits)); };
  FieldValue value = field.value;
  if (auto* v = std::get_if<bool>(&value)) return *v = !*v, value;
  if (auto* v = std::get_if<float>(&value)) return *v = f(), value;
  if (auto* v = std::get_if<double>(&value)) return *v = number(field.limits), value;
  if (auto* v = std::get_if<int64_t>(&value)) return *v = int64_t(number(field.limits)), value;
  if (auto* v = std::get_if<glm::vec3>(&value)) return *v = glm::vec3(f(), f(), f()), value;
  if (auto* v = std::get_if<Curve>(&value)) {
    // Level at the keys: it then stays between them.
    v->keys.assign({{0.0f, f()}, {0.25f, f(), 0.0f, 0.0f}, {1.0f, f()}});
    return value;
  }
  if (auto* v = std::get_if<Gradient>(&value))
    return *v = Gradient({{0.0f, {f(), f(), f()}}, {1.0f, {f(), f(), f()}}}), value;
  if (auto* v = std::get_if<Range<float>>(&value)) {
    const float a = f(), b = f();
    return *v = {std::min(a, b), std::max(a, b)}, value;
  }
  return {};
}

TEST(PresetDocument, ChangesOneFieldOfAShippedEffectAndNoOther) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  std::mt19937 random(6);
  size_t made = 0, tried = 0;
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    PresetDocument document(library.find(PresetKind::kEffect, id), PresetKind::kEffect, library);
    const std::string original = document.text();
    ASSERT_TRUE(document.effect()) << id;
    for (int i = 0; i < 8; ++i) {
      const std::vector<Field> before = document.fields();
      const Field& field = before[random() % before.size()];
      // Toggles bring and let go other fields; those have tests of their own.
      if (field.in_absent_table || !field.rivals.empty() || std::holds_alternative<bool>(field.value))
        continue;
      const std::optional<FieldValue> value = random_value(field, random);
      if (!value) continue;
      ++tried;
      const std::string text = document.text();
      if (!document.set(field.path, *value).made) {
        EXPECT_EQ(document.text(), text);
        continue;
      }
      ++made;
      std::vector<Field> expected = before;
      ASSERT_EQ(document.fields().size(), expected.size()) << id << ": " << field.path;
      for (size_t k = 0; k < expected.size(); ++k) {
        const Field& now = document.fields()[k];
        ASSERT_EQ(now.path, expected[k].path);
        EXPECT_EQ(now.value, now.path == field.path ? *value : expected[k].value) << id << ": " << now.path;
      }
    }
    while (document.undo()) continue;
    EXPECT_EQ(document.text(), original) << id;
    while (document.redo()) continue;
    while (document.undo()) continue;
    EXPECT_EQ(document.text(), original) << id;
  }
  EXPECT_GT(made, 30u) << "of " << tried;
}

TEST(PresetDocument, SetsEveryShippedValueToItselfWithoutAStep) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    PresetDocument document(library.find(PresetKind::kEffect, id), PresetKind::kEffect, library);
    for (const Field& field : std::vector<Field>(document.fields()))
      if (field.present() && !std::holds_alternative<Group>(field.value) &&
          !std::holds_alternative<Groups>(field.value)) {
        EXPECT_TRUE(document.set(field.path, field.value).made);
      }
    EXPECT_EQ(document.undo_name(), "") << id;
  }
}

TEST(TextHistory, TellsWhichOfTwoTextsWasWorkedOnLast) {
  TextHistory a("a"), b("b");
  EXPECT_EQ(a.undo_order(), 0u);
  a.step("aa", "first");
  b.step("bb", "second");
  EXPECT_GT(b.undo_order(), a.undo_order());
  a.step("aaa", "third", "drag");
  b.step("bbb", "fourth");
  a.step("aaaa", "fifth", "drag");
  EXPECT_GT(a.undo_order(), b.undo_order()) << "a drag counts as long as it goes on";
  const uint64_t last = a.undo_order();
  ASSERT_TRUE(a.undo());
  EXPECT_EQ(a.text(), "aa");
  EXPECT_EQ(a.redo_order(), last);
  EXPECT_GT(b.undo_order(), a.undo_order());
  EXPECT_EQ(b.redo_order(), 0u);
}

TEST(TextHistory, ForgetsTheOldestBeyondItsSize) {
  TextHistory history("0", 10);
  for (int i = 1; i < 30; ++i) history.step(std::string(3, static_cast<char>('a' + i)), "step");
  int steps = 0;
  while (history.undo()) ++steps;
  EXPECT_EQ(steps, 2);
  while (history.redo()) continue;
  EXPECT_EQ(history.text(), std::string(3, 'a' + 29));
  history.step(std::string(100, 'x'), "large");
  EXPECT_TRUE(history.undo()) << "the last step is kept";
  history.step("y", "other");
  EXPECT_FALSE(history.redo()) << "what was undone is gone";
}

TEST(FileWatch, TellsEachChangeOfContentsOnce) {
  using News = FileWatch::News;
  const fs::path path = fs::path(testing::TempDir()) / fmt::format("plume_watch_{}", ::getpid());
  const auto write = [&](std::string_view text) { std::ofstream(path) << text; };
  write("one");
  FileWatch watch(path, "one");
  EXPECT_EQ(watch.poll(), News::kNone);
  write("one");
  EXPECT_EQ(watch.poll(), News::kNone) << "touched only";
  const auto time = fs::last_write_time(path);
  write("two");
  fs::last_write_time(path, time);
  EXPECT_EQ(watch.poll(), News::kChanged) << "same size, same time stamp";
  EXPECT_EQ(watch.contents(), "two");
  EXPECT_EQ(watch.poll(), News::kNone);
  fs::last_write_time(path, time - std::chrono::hours(1));
  EXPECT_EQ(watch.poll(), News::kNone);
  write("four");
  EXPECT_EQ(watch.poll(), News::kChanged);
  fs::remove(path);
  EXPECT_EQ(watch.poll(), News::kGone);
  EXPECT_EQ(watch.poll(), News::kNone);
  write("four");
  EXPECT_EQ(watch.poll(), News::kNone) << "it is back as it was";
  fs::remove(path);
}

}  // namespace
}  // namespace plume
