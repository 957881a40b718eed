// plume compare: what it writes, what it prints, and that both are the same tomorrow.
#include <cmath>
#include <set>
#include <sstream>

#include "renderer/methods/methods.h"
#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

using Names = std::vector<std::string>;

class CompareTest : public ProgramTest {
 protected:
  /// `plume compare street` with small pictures, two timed repetitions and the arguments that are given.
  Outcome compare_street(const Arguments& more = {}) {
    Arguments arguments{"compare", "street", "--size", "96x54", "--frames", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(CompareTest, WritesResultsForEveryMethod) {
  const Outcome outcome = compare_street();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = results();
  EXPECT_EQ(keys(all), (Names{"command", "environment", "frames", "moments", "notes", "plan"}));
  EXPECT_EQ(keys(all["environment"]),
            (Names{"api", "build", "commit", "cores", "cpu", "device", "driver", "threads"}));
  for (const char* name : {"api", "build", "commit", "cpu", "device", "driver"})
    EXPECT_FALSE(all["environment"][name].get<std::string>().empty()) << name;
  EXPECT_GT(all["environment"]["threads"], 0);
  EXPECT_GT(all["environment"]["cores"], 0);

  Names methods;
  for (const json& frame : all["frames"]) {
    SCOPED_TRACE(frame.dump());
    methods.push_back(frame["method"]);
    EXPECT_EQ(keys(frame), (Names{"bad_particles",
                                  "error",
                                  "error_map",
                                  "gpu_ms",
                                  "gpu_ms_interval",
                                  "gpu_ms_p95",
                                  "hdr",
                                  "image",
                                  "job",
                                  "left_out",
                                  "memory_bytes",
                                  "method",
                                  "passes",
                                  "probes",
                                  "samples",
                                  "scene",
                                  "seed",
                                  "settings",
                                  "shortfalls",
                                  "shot",
                                  "size",
                                  "statistics",
                                  "status",
                                  "tick",
                                  "transparency_ms",
                                  "transparency_ms_interval",
                                  "transparency_ms_p95"}));
    EXPECT_EQ(frame["scene"], "street");
    EXPECT_EQ(frame["tick"], 400);
    EXPECT_EQ(frame["size"], json::parse("[96, 54]"));
    EXPECT_TRUE(frame["settings"].is_object());
    if (frame["status"] != "ok") {
      EXPECT_TRUE(frame["status"].get<std::string>().starts_with("unavailable: needs "));
      EXPECT_TRUE(frame["passes"].empty() && frame["error"].is_null() && frame["image"].is_null());
      continue;
    }
    EXPECT_GT(frame["memory_bytes"], 0);
    EXPECT_FALSE(frame["passes"].empty());
    EXPECT_EQ(keys(frame["error"]), (Names{"flip", "max", "max_at", "psnr_db", "rmse", "ssim"}));
    EXPECT_LT(frame["error"]["max_at"][0], 96);
    EXPECT_LT(frame["error"]["max_at"][1], 54);
  }
  EXPECT_EQ(methods, method_ids());
}

TEST_F(CompareTest, ASlashInASettingMakesNoFolder) {
  const Outcome outcome = compare_street({"--methods", "avboit", "--set", "avboit.resolution=1/4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string image = results()["frames"][0]["image"];
  EXPECT_EQ(image, "street_000400_avboit-resolution-1_4.png");
  EXPECT_TRUE(std::filesystem::exists(at(std::filesystem::path("out") / image)));
}

TEST_F(CompareTest, ReferenceHasNoErrorAndMethodsThatAreNotExactHave) {
  std::set<std::string> exact;
  for (const json& method : json::parse(run({"list", "methods", "--json"}).out))
    if (method["exact"]) exact.insert(method["id"]);
  ASSERT_EQ(compare_street().exit_code, 0);
  for (const json& frame : frames()) {
    SCOPED_TRACE(frame.dump());
    if (frame["method"] == "reference") {
      EXPECT_EQ(frame["error"]["rmse"], 0.0);
      EXPECT_EQ(frame["error"]["max"], 0.0);
      EXPECT_EQ(frame["error"]["flip"], 0.0);
      EXPECT_EQ(frame["error"]["ssim"], 1.0);
      EXPECT_TRUE(frame["error"]["psnr_db"].is_null());  // infinite
    } else if (exact.contains(frame["method"])) {
      EXPECT_LE(frame["error"]["rmse"], 1e-3);
    } else if (frame["status"] == "ok") {
      EXPECT_GT(frame["error"]["rmse"], 0.0);
      EXPECT_GT(frame["error"]["psnr_db"], 10.0);
    }
  }
}

TEST_F(CompareTest, CountsAsManySamplesAsTimedFrames) {
  ASSERT_EQ(run({"compare", "quads_mcguire", "--size", "16x9", "--frames", "7"}).exit_code, 0);
  const json all = results();
  for (const json& frame : all["frames"]) {
    for (const json& pass : frame["passes"]) {
      SCOPED_TRACE(pass.dump());
      EXPECT_EQ(keys(pass),
                (Names{"fragments", "interval_ms", "median_ms", "min_ms", "name", "p95_ms", "samples"}));
      EXPECT_EQ(pass["samples"], 7);  // the warm-up is not one of them
      EXPECT_GT(pass["min_ms"], 0.0);
      EXPECT_LE(pass["min_ms"], pass["median_ms"]);
      EXPECT_LE(pass["median_ms"], pass["p95_ms"]);
      EXPECT_LE(pass["interval_ms"][0], pass["median_ms"]);
      EXPECT_GE(pass["interval_ms"][1], pass["median_ms"]);
    }
    if (frame["status"] != "ok") continue;
    EXPECT_EQ(frame["samples"], 7);
    for (const std::string of : {"gpu_ms", "transparency_ms"}) {
      EXPECT_LE(frame[of + "_interval"][0], frame[of]);
      EXPECT_GE(frame[of + "_interval"][1], frame[of]);
      EXPECT_LE(frame[of], frame[of + "_p95"]);
    }
  }
}

TEST_F(CompareTest, GpuTimeIsThatOfAllPasses) {
  ASSERT_EQ(run(compare_quickly("quads_mcguire")).exit_code, 0);
  const json all = results();
  for (const json& frame : all["frames"]) {
    double sum = 0, own = 0;
    for (const json& pass : frame["passes"]) {
      sum += pass["median_ms"].get<double>();
      if (!std::set<std::string>{"cards", "seen cards", "depth", "opaque", "display"}.contains(pass["name"]))
        own += pass["median_ms"].get<double>();
    }
    EXPECT_NEAR(frame["gpu_ms"].get<double>(), sum, 1e-9) << frame;
    EXPECT_NEAR(frame["transparency_ms"].get<double>(), own, 1e-9) << frame;
  }
}

TEST_F(CompareTest, ShowsWhatEveryInstanceCosts) {
  ASSERT_EQ(compare_street({"--methods", "wboit"}).exit_code, 0);
  const json demand = demand_of_first();
  EXPECT_EQ(keys(demand), (Names{"instances", "state_hash", "total"}));
  EXPECT_EQ(demand["state_hash"].get<std::string>().size(), 16u);
  Names names;
  for (const json& instance : demand["instances"]) {
    SCOPED_TRACE(instance.dump());
    names.push_back(instance["name"]);
    EXPECT_EQ(keys(instance), (Names{"awake", "bytes", "bytes_saved", "called", "dispatches", "name",
                                     "ticks_saved", "ticks_simulated", "why"}));
    EXPECT_FALSE(instance["why"].get<std::string>().empty());
    const bool awake = instance["awake"];
    EXPECT_EQ(awake, instance["name"] != "dust");
    EXPECT_EQ(awake, instance["bytes"] > 0);
    EXPECT_EQ(awake, instance["dispatches"] > 0);
    EXPECT_EQ(awake, instance["ticks_simulated"] > 0);
  }
  EXPECT_EQ(names, (Names{"grenade_left", "grenade_right", "fireball", "dust"}));
}

TEST_F(CompareTest, ImagesItNamesArePngsOfThatSize) {
  ASSERT_EQ(compare_street().exit_code, 0);
  Names named{"report.html", "results.csv", "results.json"};
  const json all = results();
  for (const json& frame : all["frames"])
    for (const char* key : {"image", "error_map"}) {
      if (frame["status"] != "ok") continue;
      named.push_back(frame[key]);
      const DisplayImage image = read_png(at("out") / named.back());
      EXPECT_EQ(image.width, 96) << named.back();
      EXPECT_EQ(image.height, 54) << named.back();
    }
  std::ranges::sort(named);
  EXPECT_EQ(files(), named);  // and nothing else is left behind
}

TEST_F(CompareTest, WritesOneCsvLinePerFrame) {
  ASSERT_EQ(compare_street().exit_code, 0);
  std::istringstream csv(read("out/results.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_TRUE(
      line.starts_with("job,scene,tick,shot,seed,width,height,method,settings,status,gpu_ms,"
                       "transparency_ms,memory_bytes,left_out,rmse,"));
  // A comma within quotes belongs to its field.
  const auto fields = [](const std::string& text) {
    size_t count = 1;
    bool quoted = false;
    for (const char c : text) {
      if (c == '"') quoted = !quoted;
      count += c == ',' && !quoted;
    }
    return count;
  };
  const size_t columns = fields(line);
  const json all = results();
  for (const json& frame : all["frames"]) {
    ASSERT_TRUE(std::getline(csv, line));
    const std::string method = frame["method"];
    EXPECT_TRUE(line.starts_with("street_000400_" + method + ",street,400,,1,96,54," + method + ",")) << line;
    EXPECT_EQ(fields(line), columns) << line;
  }
  EXPECT_FALSE(std::getline(csv, line)) << line;
}

TEST_F(CompareTest, ReportNeedsNoOtherFile) {
  ASSERT_EQ(compare_street().exit_code, 0);
  const std::string report = read("out/report.html");
  EXPECT_TRUE(says(report, {"<!doctype html>", "</html>"}));
  for (const auto& [name, bytes] : pictures())
    EXPECT_TRUE(says(report, {"data-picture=\"" + name + "\">iVBORw0KGgo"})) << "a PNG in base64";
  for (const char* outside : {"src=\"", "href=\"http", "@import", "url(", "<iframe", "fetch("})
    EXPECT_EQ(report.find(outside), std::string::npos) << outside;
  for (const std::string& id : method_ids()) EXPECT_TRUE(says(report, {"\"method\":\"" + id + "\""}));
}

TEST_F(CompareTest, PrintsATableAndKeepsProgressApart) {
  const Outcome outcome = compare_street();
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(says(outcome.err, {"[1/1] street tick 400"}));
  EXPECT_EQ(outcome.out.find("[1/1]"), std::string::npos);
  EXPECT_TRUE(says(outcome.out, {"RMSE", "PSNR", "SSIM", "FLIP", "GPU ms", "report: out/report.html"}));
  EXPECT_TRUE(says(outcome.out, method_ids()));
}

TEST_F(CompareTest, PrintsTheSameJsonAsItWrites) {
  const Outcome outcome = compare_street({"--json", "--out", "a folder/of mine"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, read("a folder/of mine/results.json"));
}

TEST_F(CompareTest, TwoRunsGiveTheSamePicturesAndState) {
  ASSERT_EQ(compare_street({"--out", "a"}).exit_code, 0);
  ASSERT_EQ(compare_street({"--out", "b"}).exit_code, 0);
  EXPECT_EQ(pictures("a"), pictures("b"));
  EXPECT_EQ(demand_of_first("a"), demand_of_first("b"));
}

TEST_F(CompareTest, AnotherSeedGivesOtherPicturesAndState) {
  ASSERT_EQ(compare_street({"--methods", "sorted", "--out", "a"}).exit_code, 0);
  ASSERT_EQ(compare_street({"--methods", "sorted", "--out", "b", "--seed", "7"}).exit_code, 0);
  EXPECT_NE(pictures("a"), pictures("b"));
  EXPECT_NE(demand_of_first("a")["state_hash"], demand_of_first("b")["state_hash"]);
}

TEST_F(CompareTest, DrawsTheTickItIsTold) {
  ASSERT_EQ(run(compare_quickly("street", {"--methods", "sorted", "--at", "20"})).exit_code, 0);
  EXPECT_EQ(results()["frames"][0]["tick"], 20);
  EXPECT_TRUE(fs::exists(at("out/street_000020_sorted.png")));
  EXPECT_EQ(demand_of_first()["instances"][0]["ticks_simulated"], 20);
}

TEST_F(CompareTest, TakesSettingsFromTheCommandLine) {
  ASSERT_EQ(run(compare_quickly("street", {"--methods", "wboit", "--out", "a"})).exit_code, 0);
  ASSERT_EQ(run(compare_quickly("street", {"--methods", "wboit", "--out", "b", "--set", "wboit.weight=eq10"}))
                .exit_code,
            0);
  const json a = results("a")["frames"][0], b = results("b")["frames"][0];
  EXPECT_EQ(a["settings"]["weight"], "eq7");
  EXPECT_EQ(b["settings"]["weight"], "eq10");
  EXPECT_NE(a["error"]["rmse"], b["error"]["rmse"]);
}

TEST_F(CompareTest, ComparesSeveralScenesInOneTable) {
  const Outcome outcome = run({"compare", "quads_mcguire", "quads_learnopengl", "--size", "16x9", "--frames",
                               "1", "--methods", "sorted,wboit"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 4u);
  EXPECT_EQ(all["frames"][0]["scene"], "quads_mcguire");
  EXPECT_EQ(all["frames"][3]["scene"], "quads_learnopengl");
}

TEST_F(CompareTest, SceneByPathGivesCleanFileNames) {
  fs::create_directories(at("my scenes"));
  fs::copy_file(fs::path(PLUME_SOURCE_PRESETS) / "scenes/quads_mcguire.toml", at("my scenes/cards.toml"));
  const Outcome outcome = run(compare_quickly("my scenes/cards.toml", {"--methods", "sorted"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results()["frames"][0]["scene"], "cards");
  EXPECT_EQ(files(), (Names{"cards_000000_sorted.png", "cards_000000_sorted_error.png", "report.html",
                            "results.csv", "results.json"}));
}

TEST_F(CompareTest, SameFrameTwiceIsRefusedAndNotOverwritten) {
  const Outcome outcome = run(compare_quickly("street", {"--methods", "sorted,sorted"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"street at tick 400 with sorted is asked for twice", "--out"}));
}

TEST_F(CompareTest, UnwritableFolderIsNamedWithTheReason) {
  write("file", "not a folder");
  for (const char* folder : {"file", "file/below"}) {
    const Outcome outcome = run(compare_quickly("quads_mcguire", {"--out", folder}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, std::string("plume: ") + folder + ": Not a directory\n");
  }
  EXPECT_EQ(read("file"), "not a folder");
}

TEST_F(CompareTest, KeepsTransmittanceAtMarkedPixels) {
  const Outcome outcome = run({"compare", "three_cards", "--size", "96x54", "--frames", "1", "--methods",
                               "reference,avboit", "--pixel", "48,27", "--pixel", "0,0", "--validate"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json frames = results()["frames"];
  ASSERT_EQ(frames.size(), 2u);
  for (const json& frame : frames) {
    const json& probes = frame["probes"];
    ASSERT_EQ(probes.size(), 2u);
    EXPECT_EQ(probes[0]["pixel"], json::parse("[48, 27]"));
    EXPECT_EQ(probes[1]["pixel"], json::parse("[0, 0]"));
    for (const json& probe : probes) {
      EXPECT_EQ(keys(probe),
                (Names{"depth_m", "exact", "opaque_depth_m", "pixel", "transmittance", "zero_depth_m"}));
      EXPECT_LE(probe["depth_m"].size(), 256u);
      EXPECT_EQ(probe["exact"].size(), probe["depth_m"].size());
      EXPECT_EQ(probe["transmittance"].size(), probe["depth_m"].size());
    }
    EXPECT_LT(probes[0]["exact"].back(), 0.9);
  }
  const json& exact = frames[0]["probes"][0];
  for (size_t i = 0; i < exact["exact"].size(); ++i)
    EXPECT_NEAR(exact["exact"][i].get<double>(), exact["transmittance"][i].get<double>(), 1e-5);
  EXPECT_NE(frames[1]["probes"][0]["transmittance"], exact["transmittance"]);
}

TEST_F(CompareTest, WhatWasMarkedIsKeptByResume) {
  const Arguments arguments = compare_quickly("three_cards", {"--methods", "avboit", "--pixel", "24,13"});
  ASSERT_EQ(run(arguments).exit_code, 0);
  const json before = results();
  Arguments again = arguments;
  again.push_back("--resume");
  const Outcome outcome = run(again, {{"PLUME_FAULT", "device_lost@draw"}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results(), before);
  EXPECT_EQ(before["frames"][0]["probes"].size(), 1u);
}

TEST_F(CompareTest, APixelOutsideThePictureIsRefused) {
  const Outcome outcome = run(compare_quickly("quads_mcguire", {"--pixel", "48,3"}));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"pixel 48,3 is marked", "48x27 ends at 47,26"}));
  EXPECT_EQ(run(compare_quickly("quads_mcguire", {"--pixel", "48"})).exit_code, 2);
}

TEST_F(CompareTest, ValidationLayersHaveNothingToSay) {
  const Outcome outcome = run(compare_quickly("street", {"--validate"}));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err.find("validation:"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace plume
