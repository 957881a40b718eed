// What the commands share: their flags, their exit codes, and the GPU they open.
#ifndef PLUME_COMMANDS_COMMAND_H
#define PLUME_COMMANDS_COMMAND_H

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>

#include "renderer/gpu/pipelines.h"
#include "sandbox/commands/kept_pipelines.h"
#include "sandbox/commands/regression.h"
#include "sandbox/presets/library.h"
#include "sandbox/runs/measurement.h"

namespace plume {

enum ExitCode {
  kDone = 0,
  kToleranceExceeded = 1,  ///< also: a validation message under --validate
  kBadUsage = 2,           ///< arguments, an input file, or a file that cannot be written
  kNoDevice = 3,
  kDeviceFailed = 4,
  kInterrupted = 130
};

/// Wrong arguments that the parser cannot see. Exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where results go, and in what shape.
struct OutputFlags {
  std::string out = "out";
  bool json = false;
  uint64_t report_limit_mib = 64;
};

/// The flags that all drawing commands take.
struct DrawFlags : OutputFlags {
  std::string device, shaders;
  std::optional<glm::uvec2> size;
  std::optional<uint32_t> seed;
  Shard shard;
  std::vector<std::string> set, only;
  BaselineFlags baseline;
  std::vector<glm::uvec2> pixels;  ///< beside those that replays mark
  bool sensitivity = false;        ///< each parameter of each method is moved
  bool list = false, isolate = false, as_job = false, resume = false, validate = false;
  uint64_t memory_limit_mib = 0;
  const CLI::App* command = nullptr;  ///< whose flags these are
};
/// "640x360". Throws UsageError.
glm::uvec2 parse_size(const std::string& text);

void add_output_flags(CLI::App& command, OutputFlags& flags, const std::string& group);
/// Those that say on what methods run, and how they are set.
void add_device_flags(CLI::App& command, DrawFlags& flags);
/// Those, and the ones that say what is drawn.
void add_picture_flags(CLI::App& command, DrawFlags& flags);
/// Those, and the ones that say which frames and where they go.
void add_draw_flags(CLI::App& command, DrawFlags& flags);

/// Of `--methods`: ids, or "all". Throws UsageError.
std::vector<MethodRun> method_runs(const std::vector<std::string>& names);

/// Applies every `--set method.parameter=value` to the methods of that id that do not name the parameter
/// themselves.
void apply_settings(const std::vector<std::string>& settings, std::vector<Replay>& replays);

gpu::DeviceOptions device_options(const DrawFlags& flags);

/// A device with what drawing needs, opened as the flags say. The driver's pipelines are kept for the next.
struct GpuSession {
  explicit GpuSession(const DrawFlags& flags) : GpuSession(device_options(flags), flags.shaders) {}
  GpuSession(const gpu::DeviceOptions& options, const std::string& shader_folder);
  ~GpuSession();
  GpuSession(const GpuSession&) = delete;
  gpu::Device device;
  gpu::Shaders shaders;
  KeptPipelines kept;
  gpu::Pipelines pipelines;
};

/// A line on standard error about what went wrong and was done without.
void warn(const std::string& text);

/// Prints what the validation layers said, and gives the exit code of it.
int report_validation(const gpu::Device& device);

/// Writes report.html into the folder that has the pictures; prints the table, or JSON.
void print_results(const Results& results, const OutputFlags& flags);

/// Measures, writes the report, prints the table or JSON; the common end of `compare` and `replay`.
int measure_and_report(std::vector<Replay> replays, const PresetLibrary& library, const DrawFlags& flags);

/// Every command adds its sub-command and hands over what runs it.
using Run = std::function<int()>;
void add_open(CLI::App& program, Run& run);
void add_compare(CLI::App& program, Run& run);
void add_replay(CLI::App& program, Run& run);
void add_probe(CLI::App& program, Run& run);
void add_inspect(CLI::App& program, Run& run);
void add_diff(CLI::App& program, Run& run);
void add_check(CLI::App& program, Run& run);
void add_list(CLI::App& program, Run& run);
void add_merge(CLI::App& program, Run& run);
void add_stress(CLI::App& program, Run& run);

/// The arguments with the command `open` where it was left out: with none at all, and before the name of a
/// scene.
std::vector<std::string> with_open(const CLI::App& program, std::vector<std::string> arguments);

}  // namespace plume
#endif
