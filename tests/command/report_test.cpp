// report.html as a browser shows it: headless Chromium, from disk, without a network.
#include <algorithm>
#include <functional>

#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

/// What is to be seen of a page.
std::string seen_of(std::string page) {
  for (const std::string tag : {"script", "style"})
    for (size_t begin; (begin = page.find("<" + tag)) != std::string::npos;)
      page.erase(begin, page.find("</" + tag + ">", begin) - begin + tag.size() + 3);
  return page;
}

/// Pictures that tests keep for people to look at, beside the program.
fs::path kept_pictures() {
  const fs::path folder = fs::path(PLUME_PROGRAM).parent_path() / "test_pictures";
  fs::create_directories(folder);
  return folder;
}

class ReportTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v chromium > /dev/null") != 0)
      GTEST_SKIP() << "no chromium: scripts/install.sh installs it";
  }

  /// A small comparison; its report is moved to where there is nothing else that it could load.
  void compare(const Arguments& arguments) {
    const Outcome outcome = run(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    fs::create_directories(at("alone"));
    fs::rename(at("out/report.html"), at("alone/report.html"));
  }

  /// Opens the report at what stands behind the # of its address, and expects that it has nothing to
  /// complain of. Gives the page as it is then.
  std::string open(const std::string& address, const Arguments& more = {"--dump-dom"}) {
    Arguments arguments{"chromium",
                        "--headless",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--disable-dev-shm-usage",
                        "--hide-scrollbars",
                        "--host-resolver-rules=MAP * ~NOTFOUND",
                        "--enable-logging=stderr",
                        "--user-data-dir=" + at("browser").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::string url = "file://" + at("alone/report.html").string() + "#" + address;
    for (size_t i; (i = url.find(' ')) != std::string::npos;) url.replace(i, 1, "%20");
    arguments.push_back(url);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int out = creat(at("stdout").c_str(), 0666), err = creat(at("stderr").c_str(), 0666);
    const pid_t child = fork();
    if (child == 0) {
      setenv("HOME", at("").c_str(), 1);
      if (dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0) execvp(argv[0], argv.data());
      _exit(127);
    }
    close(out);
    close(err);
    const Outcome outcome = wait(child);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("CONSOLE"), std::string::npos) << outcome.err;
    return seen_of(outcome.out);
  }

  /// Changes what the report tells of, as runs that measure more would.
  void edit_data(const std::function<void(json&)>& edit) {
    std::string page = read("alone/report.html");
    const std::string opening = "<script type=\"application/json\" id=\"data\">";
    const size_t begin = page.find(opening) + opening.size(), end = page.find("</script>", begin);
    json data = json::parse(page.substr(begin, end - begin));
    edit(data);
    std::string text = data.dump();
    for (size_t i; (i = text.find('<')) != std::string::npos;) text.replace(i, 1, "\\u003c");
    write("alone/report.html", page.replace(begin, end - begin, text));
  }
};

/// The page's own account, kept in attributes of <html>: data-rows="4" and so on.
testing::AssertionResult tells(const std::string& dom, const std::vector<std::string>& parts) {
  const size_t begin = dom.find("<html"), end = dom.find('>', begin);
  if (begin == std::string::npos) return testing::AssertionFailure() << "no page";
  return says(dom.substr(begin, end - begin), parts);
}

TEST_F(ReportTest, ShowsEveryFrameWithoutNetworkOrErrors) {
  ASSERT_NO_FATAL_FAILURE(compare({"compare", "quads_mcguire", "grenade", "--size", "64x36", "--frames", "1",
                                   "--methods", "reference,sorted,wboit,avboit"}));
  // Over all scenes first, since there are several: a mark and a bar a method, and a row a frame.
  const std::string all = open("");
  EXPECT_TRUE(tells(all, {"data-ready=\"yes\"", "data-errors=\"0\"", "data-points=\"4\"", "data-bars=\"4\"",
                          "data-rows=\"8\"", "data-shown=\"avboit | reference\""}));
  EXPECT_TRUE(says(all, {"reference", "worth their time", "exact", "● awake", "has the method's default"}));

  const std::string picture = (kept_pictures() / "report.png").string();
  open("moment=grenade@430&y=flip&x=own&sort=rmse&down=1",
       {"--window-size=1280,3200", "--screenshot=" + picture});
  const DisplayImage seen = read_png(picture);
  EXPECT_EQ(seen.width, 1280);
  // The colours of methods, each in its mark, its range, the key and the table, and of passes in the bars.
  for (const std::array<uint8_t, 3> colour : {std::array<uint8_t, 3>{0x00, 0x72, 0xb2},
                                              {0xd5, 0x5e, 0x00},
                                              {0x00, 0x85, 0x5f},
                                              {0xb4, 0x47, 0x8c},
                                              {0xe2, 0x89, 0x4a}})
    EXPECT_GT(std::ranges::count(seen.pixels, colour), 100) << int(colour[0]) << " " << int(colour[1]);
}

TEST_F(ReportTest, TheAddressChoosesAxesFrameAndOrder) {
  ASSERT_NO_FATAL_FAILURE(compare({"compare", "quads_mcguire", "quads_learnopengl", "--size", "32x18",
                                   "--frames", "1", "--methods", "sorted,reference,wboit"}));
  const std::string up = open("moment=quads_mcguire@0&sort=rmse");
  EXPECT_TRUE(tells(up, {"data-errors=\"0\"", "data-rows=\"3\"", "data-points=\"3\""}));
  const std::string down = open("moment=quads_mcguire@0&sort=rmse&down=1&y=ssim&x=own&method=sorted");
  EXPECT_TRUE(tells(down, {"data-errors=\"0\"", "data-rows=\"3\"", "data-shown=\"sorted | reference\"",
                           "data-first-row=\"wboit"}));
  EXPECT_FALSE(tells(up, {"data-first-row=\"wboit"}));
  EXPECT_TRUE(
      says(down, {"data-column=\"rmse\" aria-sort=\"descending\"", "aria-pressed=\"true\">1 − SSIM</button>",
                  "aria-pressed=\"true\">transparency alone</button>"}));
}

TEST_F(ReportTest, ShowsRangesProbesNotesAndSensitivityWhereTheyWereMeasured) {
  ASSERT_NO_FATAL_FAILURE(
      compare({"compare", "quads_mcguire", "--size", "32x18", "--frames", "1", "--methods", "sorted,wboit"}));
  edit_data([](json& data) {
    json& results = data["results"];
    results["command"] = "plume compare quads_mcguire --size 32x18";
    results["notes"] = {{{"what", "load"}, {"text", "Busy </script><b>machine"}}};
    json& sorted = results["frames"][0];
    json& wboit = results["frames"][1];
    for (const char* time : {"gpu_ms", "transparency_ms"})
      for (json* frame : {&sorted, &wboit}) {
        (*frame)[time] = 2.0;
        (*frame)[std::string(time) + "_interval"] = {1.5, 2.5};
      }
    sorted["job"] = "quads_mcguire_000000_sorted";
    sorted["probes"] = {{{"pixel", {3, 4}},
                         {"depth_m", {1.0, 2.0, 3.0}},
                         {"exact", {1.0, 0.5, 0.25}},
                         {"transmittance", {{1.0, 1.0, 1.0}, {0.5, 0.4, 0.3}, {0.2, 0.2, 0.2}}},
                         {"opaque_depth_m", nullptr},
                         {"zero_depth_m", 2.5}}};
    sorted["bad_particles"]["count"] = 3;
    wboit["status"] = "failed: exit 4: device lost";
    results["sensitivity"] = {{{"scene", "quads_mcguire"},
                               {"tick", 0},
                               {"method", "wboit"},
                               {"parameter", "weight"},
                               {"from", "eq7"},
                               {"to", "eq8"},
                               {"error_before", 0.2},
                               {"error_after", 0.1},
                               {"ms_before", 1.0},
                               {"ms_after", 1.5},
                               {"accuracy_per_ms", 0.2},
                               {"kind", "buys"},
                               {"sure", true}}};
  });
  const std::string dom = open("");
  EXPECT_TRUE(tells(dom, {"data-errors=\"0\"", "data-points=\"1\"", "data-rows=\"2\"", "data-pixels=\"1\"",
                          "data-steps=\"1\""}));
  EXPECT_TRUE(says(dom, {"Busy &lt;/script&gt;&lt;b&gt;machine", "[1.50–2.50]",
                         "plume compare quads_mcguire --size 32x18 --only quads_mcguire_000000_sorted",
                         "failed: exit 4: device lost", "3 bad particles", "eq7 → eq8",
                         "0.200 less error for each ms more"}));
}

}  // namespace
}  // namespace plume
