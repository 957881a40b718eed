// What a comparison or a replay found: results.json and results.csv. Written after every frame, so that an
// interrupted run keeps what it had and --resume goes on from there.
#ifndef PLUME_RUNS_RESULTS_H
#define PLUME_RUNS_RESULTS_H

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sandbox/measure/statistics.h"

namespace plume {

struct PassSummary {
  std::string name;
  Summary ms;
  std::optional<uint64_t> fragments;  ///< that passed the depth test, where the pass counts them
};

struct ErrorSummary {
  double rmse = 0, psnr_db = 0, ssim = 1, flip = 0;
  double max = 0;
  int max_x = 0, max_y = 0;
};

/// One method with one set of settings on one tick of one scene.
struct FrameResult {
  std::string job;  ///< its id, one of a kind in the plan (runs/plan.h)
  std::string scene;
  uint32_t tick = 0;
  uint32_t shot = 0;  ///< of a recording, counted from 1; 0: of none
  uint32_t seed = 0;  ///< that the scene was played with
  uint32_t width = 0, height = 0;
  std::string method;
  nlohmann::json settings = nlohmann::json::object();  ///< every parameter with its value
  std::string status = "ok";                           ///< or "unavailable: needs X", "failed: why"
  std::vector<PassSummary> passes;
  Summary gpu_ms;                     ///< of the repetitions' sums of passes; `min` is not kept in files
  Summary transparency_ms;            ///< of that, the method's own passes: what is not the same for all
  uint64_t memory_bytes = 0;          ///< of the method's own images and buffers
  std::vector<std::string> left_out;  ///< outputs the picture wants that the method does not write
  std::optional<ErrorSummary> error;  ///< against the exact reference
  nlohmann::json statistics = nlohmann::json::object();  ///< what the method tells of itself
  std::vector<std::string> shortfalls;  ///< what the picture lacks, in sentences: see shortfalls.h
  nlohmann::json bad_particles{{"count", 0}, {"first", nullptr}};  ///< left out: see bad_particles.h
  /// Transmittance over depth at the pixels that were marked: see frame_probe.h.
  nlohmann::json probes = nlohmann::json::array();
  std::string image, error_map, hdr;  ///< file names beside results.json; "" = not written
};

/// What the jobs that are drawn together have in common.
struct MomentResult {
  std::string job;  ///< the first in the plan of those that are drawn then
  std::string scene;
  uint32_t tick = 0, shot = 0, seed = 0;
  uint32_t width = 0, height = 0;
  nlohmann::json demand;  ///< what every instance costs when one goes there directly, and why
};

/// Something that makes the times of a run doubtful.
struct Note {
  std::string what, text;  ///< "load", "clock", …, and a sentence
  bool operator==(const Note&) const = default;
};

/// Both, each note once.
std::vector<Note> joined(std::vector<Note> notes, std::vector<Note> more);

struct Results {
  std::string command;  ///< that draws all of the plan, for a shell; `--only JOB` behind it draws one job
  std::string plan;     ///< its id
  std::vector<std::string> order;  ///< the id of every job of the plan, drawn or not
  nlohmann::json environment;
  std::vector<FrameResult> frames;  ///< in that order, and the moments too
  std::vector<MomentResult> moments;
  std::vector<Note> notes{};
  nlohmann::json sensitivity{};  ///< of parameters, where it was asked for: see sensitivity.h
};

/// Whether there is nothing left to draw of the frame: a failed one is drawn again.
bool is_settled(const FrameResult& frame);

/// Those settings that are not the method's defaults: what tells two rows of one method apart.
nlohmann::json changed_settings(const FrameResult& frame);
nlohmann::json to_json(const FrameResult& frame);
nlohmann::json to_json(const Results& results);
/// Throws std::runtime_error that names the file when it is not a results.json.
Results read_results(const std::filesystem::path& path);
/// For people: which emitters' particles were left out of pictures, a sentence each.
std::vector<std::string> bad_particle_warnings(const Results& results);
/// One line per frame; the passes' medians in columns of their own.
std::string to_csv(const Results& results);
/// A table for people: scene (with size and seed where frames differ in them), tick, method, error, time,
/// memory.
std::string to_table(const Results& results);

}  // namespace plume
#endif
