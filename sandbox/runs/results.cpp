#include "sandbox/runs/results.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/methods/methods.h"
#include "sandbox/measure/file_bytes.h"

namespace plume {
namespace {

using nlohmann::json;

json number_or_null(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

double number_or_infinity(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

json text_or_null(const std::string& text) {
  return text.empty() ? json(nullptr) : json(text);
}

std::string text_of(const json& value) {
  return value.is_null() ? "" : value.get<std::string>();
}

/// What is counted from 1, so that 0 is none.
json none_or_number(uint32_t number) {
  return number == 0 ? json(nullptr) : json(number);
}

uint32_t number_or_none(const json& value) {
  return value.is_null() ? 0 : value.get<uint32_t>();
}

/// A CSV field whatever is in it (RFC 4180).
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

/// The median under `name`, and what else is known of these times beside it.
void add_times(json& to, const std::string& name, const Summary& times) {
  to[name] = times.median;
  to[name + "_p95"] = times.p95;
  to[name + "_interval"] = {times.low, times.high};
}

Summary times_from(const json& from, const std::string& name) {
  return {.median = from.at(name),
          .p95 = from.at(name + "_p95"),
          .low = from.at(name + "_interval").at(0),
          .high = from.at(name + "_interval").at(1),
          .samples = from.at("samples")};
}

FrameResult frame_from_json(const json& from) {
  FrameResult frame;
  frame.job = from.at("job");
  frame.scene = from.at("scene");
  frame.tick = from.at("tick");
  frame.shot = number_or_none(from.at("shot"));
  frame.seed = from.at("seed");
  frame.width = from.at("size").at(0);
  frame.height = from.at("size").at(1);
  frame.method = from.at("method");
  frame.settings = from.at("settings");
  frame.status = from.at("status");
  for (const json& pass : from.at("passes"))
    frame.passes.push_back({pass.at("name"),
                            {.median = pass.at("median_ms"),
                             .p95 = pass.at("p95_ms"),
                             .min = pass.at("min_ms"),
                             .low = pass.at("interval_ms").at(0),
                             .high = pass.at("interval_ms").at(1),
                             .samples = pass.at("samples")},
                            {}});
  for (size_t i = 0; i < frame.passes.size(); ++i)
    if (const json& count = from.at("passes")[i].at("fragments"); !count.is_null())
      frame.passes[i].fragments = count.get<uint64_t>();
  frame.gpu_ms = times_from(from, "gpu_ms");
  frame.transparency_ms = times_from(from, "transparency_ms");
  frame.memory_bytes = from.at("memory_bytes");
  frame.left_out = from.at("left_out");
  if (const json& error = from.at("error"); !error.is_null())
    frame.error = {.rmse = number_or_infinity(error.at("rmse")),
                   .psnr_db = number_or_infinity(error.at("psnr_db")),
                   .ssim = error.at("ssim"),
                   .flip = error.at("flip"),
                   .max = number_or_infinity(error.at("max")),
                   .max_x = error.at("max_at").at(0),
                   .max_y = error.at("max_at").at(1)};
  frame.statistics = from.at("statistics");
  frame.shortfalls = from.at("shortfalls");
  frame.bad_particles = from.value("bad_particles", FrameResult().bad_particles);
  frame.probes = from.at("probes");
  frame.image = text_of(from.at("image"));
  frame.error_map = text_of(from.at("error_map"));
  frame.hdr = text_of(from.at("hdr"));
  return frame;
}

MomentResult moment_from_json(const json& from) {
  return {.job = from.at("job"),
          .scene = from.at("scene"),
          .tick = from.at("tick"),
          .shot = number_or_none(from.at("shot")),
          .seed = from.at("seed"),
          .width = from.at("size").at(0),
          .height = from.at("size").at(1),
          .demand = from.at("demand")};
}

json to_json(const MomentResult& moment) {
  return {{"job", moment.job},      {"scene", moment.scene},
          {"tick", moment.tick},    {"shot", none_or_number(moment.shot)},
          {"seed", moment.seed},    {"size", {moment.width, moment.height}},
          {"demand", moment.demand}};
}

}  // namespace

bool is_settled(const FrameResult& frame) {
  return !frame.status.starts_with("failed");
}

std::vector<Note> joined(std::vector<Note> notes, std::vector<Note> more) {
  for (Note& note : more)
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  return notes;
}

json changed_settings(const FrameResult& frame) {
  const auto method = make_method(frame.method);
  const json defaults = method ? parameter_values(*method) : json::object();
  json changed = json::object();
  for (const auto& [name, value] : frame.settings.items())
    if (defaults.value(name, json()) != value) changed[name] = value;
  return changed;
}

json to_json(const FrameResult& frame) {
  json passes = json::array();
  for (const PassSummary& pass : frame.passes)
    passes.push_back({{"name", pass.name},
                      {"median_ms", pass.ms.median},
                      {"p95_ms", pass.ms.p95},
                      {"min_ms", pass.ms.min},
                      {"interval_ms", {pass.ms.low, pass.ms.high}},
                      {"samples", pass.ms.samples},
                      {"fragments", pass.fragments ? json(*pass.fragments) : json(nullptr)}});
  json error = nullptr;
  if (frame.error)
    error = {{"rmse", number_or_null(frame.error->rmse)},
             {"psnr_db", number_or_null(frame.error->psnr_db)},
             {"ssim", frame.error->ssim},
             {"flip", frame.error->flip},
             {"max", number_or_null(frame.error->max)},
             {"max_at", {frame.error->max_x, frame.error->max_y}}};
  json result{{"job", frame.job},
              {"scene", frame.scene},
              {"tick", frame.tick},
              {"shot", none_or_number(frame.shot)},
              {"seed", frame.seed},
              {"size", {frame.width, frame.height}},
              {"method", frame.method},
              {"settings", frame.settings},
              {"status", frame.status},
              {"passes", passes},
              {"samples", frame.gpu_ms.samples},
              {"memory_bytes", frame.memory_bytes},
              {"left_out", frame.left_out},
              {"error", error},
              {"statistics", frame.statistics},
              {"shortfalls", frame.shortfalls},
              {"bad_particles", frame.bad_particles},
              {"probes", frame.probes},
              {"image", text_or_null(frame.image)},
              {"error_map", text_or_null(frame.error_map)},
              {"hdr", text_or_null(frame.hdr)}};
  add_times(result, "gpu_ms", frame.gpu_ms);
  add_times(result, "transparency_ms", frame.transparency_ms);
  return result;
}

json to_json(const Results& results) {
  json frames = json::array(), moments = json::array();
  for (const FrameResult& frame : results.frames) frames.push_back(to_json(frame));
  json notes = json::array();
  for (const Note& note : results.notes) notes.push_back({{"what", note.what}, {"text", note.text}});
  for (const MomentResult& moment : results.moments) moments.push_back(to_json(moment));
  json all{{"command", results.command},
           {"plan", {{"id", results.plan}, {"jobs", results.order.size()}, {"order", results.order}}},
           {"environment", results.environment},
           {"frames", std::move(frames)},
           {"moments", std::move(moments)},
           {"notes", std::move(notes)}};
  if (!results.sensitivity.is_null()) all["sensitivity"] = results.sensitivity;
  return all;
}

Results read_results(const std::filesystem::path& path) try {
  const auto bytes = read_file(path);
  const json from = json::parse(bytes.begin(), bytes.end());
  Results results{.command = from.at("command"),
                  .plan = from.at("plan").at("id"),
                  .order = from.at("plan").at("order"),
                  .environment = from.at("environment"),
                  .frames = {},
                  .moments = {}};
  for (const json& frame : from.at("frames")) results.frames.push_back(frame_from_json(frame));
  for (const json& moment : from.at("moments")) results.moments.push_back(moment_from_json(moment));
  for (const json& note : from.at("notes")) results.notes.push_back({note.at("what"), note.at("text")});
  results.sensitivity = from.value("sensitivity", json());
  return results;
} catch (const json::exception& error) {
  throw std::runtime_error(fmt::format("{} is not a results.json: {}", path.string(), error.what()));
}

std::vector<std::string> bad_particle_warnings(const Results& results) {
  struct Bad {
    const FrameResult* first = nullptr;
    uint32_t pictures = 0;
  };
  std::map<std::string, Bad> by_owner;
  for (const FrameResult& frame : results.frames) {
    json owner = frame.bad_particles.at("first");
    if (owner.is_null()) continue;
    owner.erase("birth");
    Bad& bad = by_owner[frame.scene + owner.dump()];
    if (!bad.first) bad.first = &frame;
    ++bad.pictures;
  }
  std::vector<std::string> warnings;
  for (const auto& [owner, bad] : by_owner)
    warnings.push_back(fmt::format("{} tick {}: {} ({} of {} pictures, `bad_particles` in results.json)",
                                   bad.first->scene, bad.first->tick, bad.first->shortfalls.back(),
                                   bad.pictures, results.frames.size()));
  return warnings;
}

std::string to_csv(const Results& results) {
  std::vector<std::string> pass_names;
  for (const FrameResult& frame : results.frames)
    for (const PassSummary& pass : frame.passes)
      if (std::find(pass_names.begin(), pass_names.end(), pass.name) == pass_names.end())
        pass_names.push_back(pass.name);

  std::string csv =
      "job,scene,tick,shot,seed,width,height,method,settings,status,gpu_ms,transparency_ms,memory_bytes,"
      "left_out,rmse,psnr_db,ssim,flip,max";
  for (const std::string& name : pass_names) csv += fmt::format(",{}_ms", name);
  csv += "\n";
  for (const FrameResult& frame : results.frames) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_field(frame.job),
                       csv_field(frame.scene), frame.tick, frame.shot ? std::to_string(frame.shot) : "",
                       frame.seed, frame.width, frame.height, frame.method, csv_field(frame.settings.dump()),
                       csv_field(frame.status), frame.gpu_ms.median, frame.transparency_ms.median,
                       frame.memory_bytes, fmt::join(frame.left_out, " "));
    if (frame.error)
      csv += fmt::format(",{},{},{},{},{}", frame.error->rmse, frame.error->psnr_db, frame.error->ssim,
                         frame.error->flip, frame.error->max);
    else
      csv += ",,,,,";
    for (const std::string& name : pass_names) {
      const auto pass = std::find_if(frame.passes.begin(), frame.passes.end(),
                                     [&](const PassSummary& p) { return p.name == name; });
      csv += pass == frame.passes.end() ? std::string(",") : fmt::format(",{}", pass->ms.median);
    }
    csv += "\n";
  }
  return csv;
}

std::string to_table(const Results& results) {
  const auto differ = [&](auto part) {
    return std::ranges::any_of(results.frames, [&](const FrameResult& frame) {
      return part(frame) != part(results.frames.front());
    });
  };
  const bool sizes = differ([](const FrameResult& f) { return std::pair(f.width, f.height); });
  const bool seeds = differ([](const FrameResult& f) { return f.seed; });
  std::string table = fmt::format(
      "{:<16} {:>5}  {:<16} {:>9} {:>8} {:>7} {:>7} {:>9} {:>9} {:<6} {:>9}  {}\n", "scene", "tick", "method",
      "RMSE", "PSNR dB", "SSIM", "FLIP", "GPU ms", "own ms", "±", "MiB", "settings");
  for (const FrameResult& frame : results.frames) {
    std::string scene = frame.scene;
    if (sizes) scene += fmt::format(" {}x{}", frame.width, frame.height);
    if (seeds) scene += fmt::format(" seed {}", frame.seed);
    table += fmt::format("{:<16} {:>5}  {:<16} ", scene, frame.tick, frame.method);
    if (frame.status != "ok") {
      table += frame.status + "\n";
      continue;
    }
    if (frame.error)
      table += fmt::format("{:>9.5f} {:>8.2f} {:>7.4f} {:>7.4f} ", frame.error->rmse, frame.error->psnr_db,
                           frame.error->ssim, frame.error->flip);
    else
      table += fmt::format("{:>9} {:>8} {:>7} {:>7} ", "-", "-", "-", "-");
    const Summary& own = frame.transparency_ms;
    const double reach = std::max(own.high - own.median, own.median - own.low);
    table += fmt::format("{:>9.2f} {:>9.2f} {:<6} {:>9.2f}  ", frame.gpu_ms.median, own.median,
                         own.samples > 1 ? fmt::format("{:.2f}", reach) : "-",
                         double(frame.memory_bytes) / 1048576.0);
    for (const std::string& output : frame.left_out) table += fmt::format("no {}; ", output);
    if (const uint32_t bad = frame.bad_particles.at("count")) table += fmt::format("{} bad particles; ", bad);
    const json changed = changed_settings(frame);
    table += changed.empty() ? "\n" : changed.dump() + "\n";
  }
  return table;
}

}  // namespace plume
