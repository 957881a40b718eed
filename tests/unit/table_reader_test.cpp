#include "sandbox/presets/table_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace plume {
namespace {

/// What a reader says about `text`, as "line:column: message" lines; empty when it says nothing.
std::string said(std::string_view text, const TableReader::Read& read) {
  try {
    read_document(text, "f", read);
  } catch (const FileErrors& errors) {
    std::string lines;
    for (const Diagnostic& d : errors.diagnostics()) lines += to_string(d).substr(2) + "\n";
    return lines;
  }
  return "";
}

constexpr Limits kMetres{0, 10, "m"};

TEST(TableReader, ReadsEveryKindOfValue) {
  float number = 0;
  uint32_t integer = 0, index = 0;
  bool toggle = false;
  std::string text;
  glm::vec2 two(0);
  glm::vec3 three(0);
  Range<float> range{0, 0};
  Range<uint32_t> ticks{0, 0};
  Curve curve{0.0f};
  Gradient gradient{glm::vec3(0)};
  std::vector<uint32_t> list;
  int inner = 0;
  const std::string_view names[] = {"a", "b"};
  EXPECT_EQ(said(R"(
    number = 3
    integer = 4
    toggle = true
    text = "ä"
    choice = "b"
    two = [1, 2.5]
    three = [1, 2, 3]
    range = [1, 2]
    ticks = 5
    curve = [[0, 1], [0.5, 2]]
    gradient = [[0, [1, 0, 0]], [1, [0, 1, 0]]]
    list = [1, 5]
    [table]
    [[tables]]
    [[tables]]
  )",
                 [&](TableReader& top) {
                   EXPECT_TRUE(top.number("number", number, kMetres));
                   EXPECT_TRUE(top.integer("integer", integer, kMetres));
                   EXPECT_TRUE(top.toggle("toggle", toggle));
                   EXPECT_TRUE(top.text("text", text));
                   EXPECT_TRUE(top.choice("choice", index, names));
                   EXPECT_TRUE(top.vector("two", two, kMetres));
                   EXPECT_TRUE(top.vector("three", three, kMetres));
                   EXPECT_TRUE(top.range("range", range, kMetres));
                   EXPECT_TRUE(top.range("ticks", ticks, kMetres));
                   EXPECT_TRUE(top.curve("curve", curve, kMetres));
                   EXPECT_TRUE(top.gradient("gradient", gradient, kMetres));
                   EXPECT_TRUE(top.ascending("list", list, kMetres));
                   top.table("table", [&](TableReader&) { inner += 1; });
                   top.tables("tables", 2, [&](TableReader&) { inner += 10; });
                   EXPECT_FALSE(top.number("absent", number, kMetres));
                 }),
            "");
  EXPECT_EQ(number, 3.0f);
  EXPECT_EQ(integer, 4u);
  EXPECT_TRUE(toggle);
  EXPECT_EQ(text, "ä");
  EXPECT_EQ(index, 1u);
  EXPECT_EQ(two, glm::vec2(1, 2.5));
  EXPECT_EQ(three, glm::vec3(1, 2, 3));
  EXPECT_EQ(range.min, 1.0f);
  EXPECT_EQ(range.max, 2.0f);
  EXPECT_EQ(ticks.min, 5u);
  EXPECT_EQ(ticks.max, 5u);
  EXPECT_EQ(curve.at(0.25f), 1.5f);
  EXPECT_EQ(gradient.at(0.5f), glm::vec3(0.5f, 0.5f, 0));
  EXPECT_EQ(list, (std::vector<uint32_t>{1, 5}));
  EXPECT_EQ(inner, 21);
}

TEST(TableReader, SaysWhatWouldBeRight) {
  float f = 0;
  const auto number = [&](TableReader& top) { top.number("x", f, kMetres); };
  EXPECT_EQ(said("x = 11", number), "1:5: `x` is 11, expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("x = nan", number), "1:5: `x` is nan, expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("x = -inf", number), "1:5: `x` is -inf, expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("x = '5'", number), "1:5: `x` is \"5\", expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("x = [1]", number), "1:5: `x` is a list of 1 value, expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("x = 2020-01-01", number), "1:5: `x` is a date or time, expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("\n xx = 1", number), "2:2: unknown key `xx`, did you mean `x`?\n");
  EXPECT_EQ(said("\n zebra = 1", number), "2:2: unknown key `zebra`, expected one of `x`\n");
  EXPECT_EQ(f, 0.0f) << "a wrong value must leave the default";

  uint32_t n = 0;
  EXPECT_EQ(said("x = 1.0", [&](TableReader& top) { top.integer("x", n, kMetres); }),
            "1:5: `x` is 1.0, expected a whole number from 0 to 10 m\n");
  glm::vec3 v(0);
  EXPECT_EQ(said("x = [1, 2]", [&](TableReader& top) { top.vector("x", v, kMetres); }),
            "1:5: `x` is a list of 2 values, expected a list of 3 numbers from 0 to 10 m\n");
  Range<float> r{0, 0};
  EXPECT_EQ(said("x = [2, 1]", [&](TableReader& top) { top.range("x", r, kMetres); }),
            "1:5: `x` is [2, 1], expected [min, max] with min at most max: [1, 2]\n");
  Curve c{0.0f};
  EXPECT_EQ(said("x = [[0.5, 1], [0.5, 2]]", [&](TableReader& top) { top.curve("x", c, kMetres); }),
            "1:17: `at` is 0.5, expected more than 0.5, the one before it\n");
  EXPECT_EQ(
      said("x = [[0, 1, -30], [0.5, 2]]", [&](TableReader& top) { top.curve("x", c, kMetres); }),
      "1:6: `x` swings to -1.052 at 0.1517 of the life, expected from 0 to 10 m between keys too: flatter "
      "slopes\n");
  EXPECT_EQ(said("x = [[0, 1, 1, 1, 1]]", [&](TableReader& top) { top.curve("x", c, kMetres); }),
            "1:6: `x` is a list of 5 values, expected [at, value], [at, value, slope] or [at, value, slope "
            "before, slope after]\n");
  const std::string_view names[] = {"cone", "box"};
  EXPECT_EQ(said("x = 'coen'", [&](TableReader& top) { top.choice("x", n, names); }),
            "1:5: `x` is \"coen\", expected \"cone\" (one of \"cone\", \"box\")\n");
  EXPECT_EQ(said("[t]\n",
                 [&](TableReader& top) {
                   top.table("t", [&](TableReader& t) { t.number("need", f, kMetres, Need::kRequired); });
                 }),
            "1:1: missing key `need` in [t], expected a number from 0 to 10 m\n");
  EXPECT_EQ(said("[[t]]\n[[t]]\n[[t]]\n", [&](TableReader& top) { top.tables("t", 2, [](TableReader&) {}); }),
            "1:1: `t` is a list of 3 values, expected at most 2 tables [[t]]\n");
}

TEST(TableReader, ReportsEveryMistakeInTheOrderOfTheFile) {
  float f = 0;
  EXPECT_EQ(said("b = 'x'\na = 'y'\nc = 1\n",
                 [&](TableReader& top) {
                   top.number("a", f, kMetres);
                   top.number("b", f, kMetres);
                 }),
            "1:5: `b` is \"x\", expected a number from 0 to 10 m\n"
            "2:5: `a` is \"y\", expected a number from 0 to 10 m\n"
            "3:1: unknown key `c`, expected one of `a`, `b`\n");
}

TEST(TableReader, ShowsHostileTextOnOneLine) {
  float f = 0;
  const std::string text = "\"a\\nb\" = 1\nx = \"" + std::string(1000, 'z') + "\"\n";
  const std::string lines = said(text, [&](TableReader& top) { top.number("x", f, kMetres); });
  EXPECT_EQ(std::ranges::count(lines, '\n'), 2);
  EXPECT_LT(lines.size(), 400u);
}

TEST(ReadDocument, ReportsSyntaxErrorsWhereTheyAre) {
  const auto nothing = [](TableReader&) {};
  EXPECT_EQ(said("a = 1\nb 2\n", nothing).substr(0, 14), "2:3: not TOML:");
  EXPECT_EQ(said("a = 1\na = 2\n", nothing).substr(0, 14), "2:5: not TOML:");
  EXPECT_EQ(said("a = \"\xff\"\n", nothing).substr(0, 14), "1:5: not TOML:");
}

TEST(ReadDocument, RejectsEmptyText) {
  for (const char* text : {"", "\n", "  \r\n\t"})
    EXPECT_EQ(said(text, [](TableReader&) {}),
              "1:1: the file is empty, expected the keys of an effect, a scene or a replay\n");
}

TEST(ReadDocument, RejectsHugeText) {
  EXPECT_EQ(said(std::string((4 << 20) + 1, '#'), [](TableReader&) {}),
            "1:1: the file is larger than 4 MiB, expected at most 4 MiB\n");
  EXPECT_EQ(said(std::string(4 << 20, '#'), [](TableReader&) {}), "");
}

TEST(ReadDocument, SurvivesDeepNesting) {
  std::string keys = "a";
  for (int i = 0; i < 1'000'000; ++i) keys += ".a";
  EXPECT_NE(said("[" + keys + "]\n", [](TableReader&) {}).find("more than 512 dots"), std::string::npos);
  const std::string brackets(100'000, '[');
  EXPECT_NE(said("a = " + brackets, [](TableReader&) {}).find("not TOML"), std::string::npos);
}

TEST(ReadDocument, TakesAnyCharacterInTextsAndCommentsOnly) {
  const auto keys = [](TableReader& top) {
    std::string text;
    for (const char* key : {"a", "b", "c", "d", "ä"}) top.text(key, text);
  };
  EXPECT_EQ(said("\xEF\xBB\xBF"
                 R"toml(# ä
a = "ä\"ä" # ä
b = 'ä\'
c = """ä
"ä""\"""""
d = '''ä
'ä'''''
"ä" = "ä"
)toml",
                 keys),
            "");
  const std::string refused =
      ": a character beyond ASCII outside quotes, expected texts in quotes and plain ASCII elsewhere\n";
  EXPECT_EQ(said("a = 'ä'\nb = ä\n", keys), "2:5" + refused);
  EXPECT_EQ(said("# ä\n[[ä]]\n", keys), "2:3" + refused);
  EXPECT_EQ(said("a = 'ä' ä\n", keys), "1:9" + refused);
  EXPECT_EQ(said("a = '''b''''' ä\n", keys), "1:15" + refused);
}

TEST(ReadDocument, SurvivesABracketBeforeAComment) {
  EXPECT_NE(said("[[#x]]\n", [](TableReader&) {}).find("1:3: not TOML"), std::string::npos);
}

TEST(LoadText, SaysWhatIsThereInsteadOfAFile) {
  const auto error_of = [](const std::filesystem::path& path) {
    try {
      load_text(path);
    } catch (const FileErrors& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error_of("/nowhere/x.toml"), "/nowhere/x.toml:1:1: there is no such file, expected a TOML file");
  EXPECT_EQ(error_of("/proc"), "/proc:1:1: this is a folder, expected a TOML file");
}

TEST(LoadText, KeepsOneByteMoreThanIsAllowed) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "plume_huge.toml";
  std::ofstream(path) << std::string(5 << 20, '#');
  EXPECT_EQ(load_text(path).size(), (size_t{4} << 20) + 1);
  std::filesystem::remove(path);
}

TEST(LoadText, TakesNoMoreMemoryThanTheFileHasBytes) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "plume_small.toml";
  std::ofstream(path) << std::string(100, '#');
  EXPECT_LT(load_text(path).capacity(), 200u);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace plume
