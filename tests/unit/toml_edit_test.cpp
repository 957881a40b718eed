#include "sandbox/presets/toml_edit.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>

#include "sandbox/presets/library.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_layout.h"

namespace plume {
namespace {

using List = std::vector<TomlValue>;

std::string set(std::string_view text, std::string_view path, const TomlValue& value) {
  return with_value(text, parse_path(path), value);
}
std::string add(std::string_view text, std::string_view path) {
  return with_table(text, parse_path(path));
}
std::string remove(std::string_view text, std::string_view path) {
  return without(text, parse_path(path));
}

TEST(ValuePath, ReadsWhatItWrites) {
  for (const char* path : {"a", "a.b-c.d_2", "emitter[2].motion.attractor[10].to", "a.\"b c\\\"d\"[3].e"})
    EXPECT_EQ(to_string(parse_path(path)), path);
  EXPECT_EQ(parse_path("a.\"b c\\\"d\"")[1].key, "b c\"d");
  EXPECT_EQ(pattern_of("emitter[2].motion.attractor[10].to"), "emitter.motion.attractor.to");
  for (const char* path :
       {"", ".", "a.", "a[", "a[]", "a[1", "a[-1]", "a b", "a[1]b", "\"a", "a[99999999999999999999]"})
    EXPECT_THROW(parse_path(path), std::invalid_argument) << path;
}

TEST(TomlText, WritesTheFewestDigitsThatReadBack) {
  const auto text = [](auto number) { return to_toml({number}); };
  EXPECT_EQ(text(0.1f), "0.1");
  EXPECT_EQ(text(2.0f), "2.0");
  EXPECT_EQ(text(-0.05f), "-0.05");
  EXPECT_EQ(text(1234567.0f), "1234567.0");
  EXPECT_EQ(text(1e-6f), "1e-06");
  EXPECT_EQ(text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(text(int64_t{-7}), "-7");
  EXPECT_EQ(to_toml({std::string("a\"b\\\n\x01ä")}), "\"a\\\"b\\\\\\n\\u0001ä\"");
  EXPECT_EQ(to_toml({List{{0.5f}, {List{{true}, {int64_t{1}}}}}}), "[0.5, [true, 1]]");
}

TEST(TomlText, FloatsReadBackThroughDouble) {
  std::mt19937 random(1);
  // The last is one of the few whose shortest digits round to another float by way of double.
  std::vector<float> numbers{0.0f, 1e-38f, 3e38f, 16777217.0f, 7.038531e-26f};
  while (numbers.size() < 20'000)
    if (const float number = std::bit_cast<float>(uint32_t(random())); std::isfinite(number))
      numbers.push_back(number);
  for (const float number : numbers) {
    const std::string text = to_toml({number});
    ASSERT_EQ(static_cast<float>(std::strtod(text.c_str(), nullptr)), number) << text;
    ASSERT_NE(text.find_first_of(".e"), text.npos) << text;
  }
}

/// Compares what the layout found with what the parser did.
void expect_same_tree(const TomlLayout& layout, const Place& place, const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    ASSERT_TRUE(place.is_table());
    ASSERT_EQ(place.members.size(), table->size());
    for (auto&& [key, value] : *table) {
      ASSERT_TRUE(place.member(key.str())) << key.str();
      expect_same_tree(layout, *place.member(key.str()), value);
    }
    return;
  }
  if (const toml::array* array = node.as_array()) {
    ASSERT_TRUE(place.is_list());
    ASSERT_EQ(place.items.size(), array->size());
    for (size_t i = 0; i < array->size(); ++i) expect_same_tree(layout, *place.items[i], (*array)[i]);
    return;
  }
  const std::string text(layout.text().substr(place.span.begin, place.span.end - place.span.begin));
  const toml::table alone = toml::parse("v = " + text);
  EXPECT_EQ(alone, (toml::table{{"v", node}})) << text;
}

constexpr std::string_view kOdd =
    "\xEF\xBB\xBF# head # comment\r\n"
    "title = 'a ] # \"b' # behind\r\n"
    "\"od.d\".'k y'.\"e\\u00e9\" = 1979-05-27 07:32:00 # a date\n"
    "s = \"\"\"\n[not.a.header]\n\"quote\" \\\"\"\"\" \n"
    "  [ a . \"b c\" ] # spaces\n"
    "\tx = [ [1, 2] , # one\n\t  # two ]\n  [3,4,],\n]\n"
    "y = { p = { q.r = 1, q.s = \"}\" }, t = [{u=1},{u=2}] }\n"
    "[[list]]\n[list.sub]\nv=+1_000\n[[list]]\n[[list.deep]]\nw = -inf\n[c.d]\nz = 1e-3\n[c]\n";

TEST(TomlLayout, FindsWhatTheParserFinds) {
  const toml::table parsed = toml::parse(kOdd);
  const TomlLayout layout(kOdd);
  expect_same_tree(layout, layout.top(), parsed);
  for (const char* path : {"od.d", "title[0]", "list[2]", "y.t[2].u", "a.\"b c\".x[3]"})
    EXPECT_EQ(layout.find(parse_path(path)), nullptr) << path;
  EXPECT_TRUE(layout.find(parse_path("list[1].deep[0].w")));
}

TEST(TomlLayout, FindsAllInEveryPreset) {
  const PresetLibrary library(PLUME_SOURCE_PRESETS);
  for (const PresetKind kind : {PresetKind::kEffect, PresetKind::kScene, PresetKind::kReplay})
    for (const std::string& id : library.ids(kind)) {
      const std::string text = load_text(library.find(kind, id));
      const TomlLayout layout(text);
      expect_same_tree(layout, layout.top(), toml::parse(text));
    }
}

TEST(TomlLayout, EndsOnAnyText) {
  std::mt19937 random(2);
  constexpr std::string_view kPieces[] = {"[", "]", "{",  "}", "=", ",", ".",  "\"",
                                          "'", "#", "\n", " ", "a", "1", "\\", "\"\"\""};
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (uint32_t length = random() % 16; length > 0; --length)
      text += kPieces[random() % std::size(kPieces)];
    try {
      TomlLayout{text};
    } catch (const std::invalid_argument&) {
    } catch (const toml::parse_error&) {
    }
  }
}

TEST(TomlEdit, ChangesNothingButTheValue) {
  EXPECT_EQ(set("# c\n a  =  1.50 # d\nb = 2\n", "a", {2.5f}), "# c\n a  =  2.5 # d\nb = 2\n");
  EXPECT_EQ(set("a = 1.50\n", "a", {1.5f}), "a = 1.50\n") << "it says so already";
  EXPECT_EQ(set("a = [0x10, 1_0]\r\n", "a", {List{{16.0f}, {11.0f}}}), "a = [0x10, 11.0]\r\n");
  EXPECT_EQ(set("a = 'x'", "a", {std::string("y")}), "a = \"y\"");
  EXPECT_EQ(set("[t]\nu = { a = 1, b = [1, { c = 2 }] }\n", "t.u.b[1].c", {int64_t{3}}),
            "[t]\nu = { a = 1, b = [1, { c = 3 }] }\n");
}

TEST(TomlEdit, KeepsTheItemsOfAListThatStay) {
  constexpr std::string_view kLines =
      "k = [\n  [0, 1.0], # birth\n  [0.5, 2], # middle\n  [1, 0] # death\n]\n";
  const auto row = [](float at, float value) { return TomlValue{List{{at}, {value}}}; };
  EXPECT_EQ(set(kLines, "k", {List{row(0, 1), row(0.5f, 3), row(1, 0)}}),
            "k = [\n  [0, 1.0], # birth\n  [0.5, 3.0], # middle\n  [1, 0] # death\n]\n");
  EXPECT_EQ(set(kLines, "k", {List{row(0, 1), row(1, 0)}}),
            "k = [\n  [0, 1.0], # birth\n  [1, 0] # death\n]\n");
  EXPECT_EQ(set(kLines, "k", {List{row(0, 1), row(0.25f, 4), row(0.5f, 2), row(1, 0)}}),
            "k = [\n  [0, 1.0], # birth\n  [0.25, 4.0],\n  [0.5, 2], # middle\n  [1, 0] # death\n]\n");
  EXPECT_EQ(set(kLines, "k", {List{row(0, 1), row(0.5f, 2)}}),
            "k = [\n  [0, 1.0], # birth\n  [0.5, 2], # middle\n]\n");
  EXPECT_EQ(set("k = [1, 2,  3]", "k", {List{{1.0f}, {2.0f}}}), "k = [1, 2]");
  EXPECT_EQ(set("k = [1, 2]", "k", {List{{1.0f}, {2.0f}, {4.0f}}}), "k = [1, 2, 4.0]");
  EXPECT_EQ(set("k = 3", "k", {List{{1.0f}}}), "k = [1.0]");
}

TEST(TomlEdit, PutsANewKeyAtTheEndOfItsTable) {
  EXPECT_EQ(set("[[e]]\nn = 1\n  [e.m]\n  a = 1 # x\n\n[[e]]\n", "e[0].m.b", {2.0f}),
            "[[e]]\nn = 1\n  [e.m]\n  a = 1 # x\n  b = 2.0\n\n[[e]]\n");
  EXPECT_EQ(set("[[e]]\r\nn = 1", "e[0].o", {true}), "[[e]]\r\nn = 1\r\no = true\r\n");
  EXPECT_EQ(set("[e]\n[f]\n  a = 1\n", "e.o", {true}), "[e]\n  o = true\n[f]\n  a = 1\n");
  EXPECT_EQ(set("m = { a = 1 }\n", "m.b", {2.0f}), "m = { a = 1, b = 2.0 }\n");
  EXPECT_EQ(set("m = {}\n", "m.b", {2.0f}), "m = { b = 2.0 }\n");
  EXPECT_EQ(set("[t]\nm.a = 1\nz = 1\n", "t.m.b", {2.0f}), "[t]\nm.a = 1\nm.b = 2.0\nz = 1\n");
  EXPECT_EQ(set("m = { a.b = 1, c = 2 }\n", "m.a.d", {2.0f}), "m = { a.b = 1, c = 2, a.d = 2.0 }\n");
  EXPECT_EQ(set("# about\n\n[t]\n", "a", {2.0f}), "# about\n\na = 2.0\n\n[t]\n");
  EXPECT_EQ(set("", "a", {2.0f}), "a = 2.0\n");
  EXPECT_EQ(set("[e]\n  # inner\n  [e.m.c]\n  a = 1\n", "e.m.b", {2.0f}),
            "[e]\n  [e.m]\n  b = 2.0\n  # inner\n  [e.m.c]\n  a = 1\n");
}

TEST(TomlEdit, PutsANewTableBehindItsNeighbours) {
  constexpr std::string_view kFile =
      "n = 1\n\n[b]\n\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n    [e.m.c]\n    a = 1\n\n[[e]]\nn = 2\n  [e.l]\n# "
      "end\n";
  EXPECT_EQ(add(kFile, "e[0].m.v"),
            "n = 1\n\n[b]\n\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n    [e.m.c]\n    a = 1\n    [e.m.v]\n\n[[e]]\nn "
            "= 2\n  "
            "[e.l]\n# end\n");
  EXPECT_EQ(
      add(kFile, "e[1].m.v[0]"),
      "n = 1\n\n[b]\n\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n    [e.m.c]\n    a = 1\n\n[[e]]\nn = 2\n  [e.l]\n  "
      "[e.m]\n    [[e.m.v]]\n# end\n");
  EXPECT_EQ(add(kFile, "e[2]"),
            "n = 1\n\n[b]\n\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n    [e.m.c]\n    a = 1\n\n[[e]]\nn = "
            "2\n  [e.l]\n\n[[e]]\n# end\n");
  EXPECT_EQ(add("[e]\na = 1\n", "e[1]"), "[[e]]\na = 1\n[[e]]\n");
  EXPECT_EQ(add("e = [{a = 1}]\n", "e[1]"), "e = [{a = 1}, {}]\n");
  EXPECT_EQ(add("e = { a = 1 }\n", "e.f[0]"), "e = { a = 1, f = [{}] }\n");
  EXPECT_EQ(add(kFile, "e[1].l"), kFile);
  EXPECT_THROW(add(kFile, "e[3]"), std::invalid_argument);
  EXPECT_THROW(add(kFile, "n.x"), std::invalid_argument);
  EXPECT_THROW(set(kFile, "e", {1.0f}), std::invalid_argument);
}

TEST(TomlEdit, RemovesAThingWithWhatIsSaidAboutIt) {
  EXPECT_EQ(remove("# on a\na = 1 # own\nb = 2\n", "a"), "# on a\nb = 2\n");
  EXPECT_EQ(remove("m = { a = 1, b = 2, c = 3 }\n", "m.b"), "m = { a = 1, c = 3 }\n");
  EXPECT_EQ(remove("m = { a = 1, b = 2 }\n", "m.b"), "m = { a = 1 }\n");
  EXPECT_EQ(remove("m = [{ a = 1 }, { a = 2 }]\n", "m[0]"), "m = [{ a = 2 }]\n");
  EXPECT_EQ(remove("m = [{ a = 1 }]\nb = 1\n", "m[0]"), "b = 1\n");
  EXPECT_EQ(remove("[t]\nm.a = 1\nm.b = 1\nz = 1\n", "t.m"), "[t]\nz = 1\n");
  constexpr std::string_view kFile =
      "# head\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n\n# second\n[[e]]\nn = 2\n  [e.l]\n\n[b]\nx = 1\n";
  EXPECT_EQ(remove(kFile, "e[0]"), "# head\n\n# second\n[[e]]\nn = 2\n  [e.l]\n\n[b]\nx = 1\n");
  EXPECT_EQ(remove(kFile, "e[1]"), "# head\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n\n[b]\nx = 1\n");
  EXPECT_EQ(remove(kFile, "e[0].m"),
            "# head\n[[e]]\nn = 1\n\n# second\n[[e]]\nn = 2\n  [e.l]\n\n[b]\nx = 1\n");
  EXPECT_EQ(remove(kFile, "e"), "# head\n\n[b]\nx = 1\n");
  EXPECT_EQ(remove(kFile, "b"),
            "# head\n[[e]]\nn = 1\n  [e.m]\n  a = 1\n\n# second\n[[e]]\nn = 2\n  [e.l]\n");
  EXPECT_THROW(remove(kFile, "e[2]"), std::invalid_argument);
}

}  // namespace
}  // namespace plume
