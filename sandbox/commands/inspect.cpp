// plume inspect SCENE --view ID: one number a pixel of what a method did there, as a coloured picture or as
// floats.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/gpu/errors.h"
#include "renderer/methods/methods.h"
#include "sandbox/commands/command.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/inspector.h"
#include "sandbox/measure/value_map.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/stage.h"

namespace plume {
namespace {

using nlohmann::json;

struct InspectFlags : DrawFlags {
  std::string scene, view, method = "avboit";
  std::optional<uint32_t> tick;
  uint32_t slice = 0;
  std::vector<std::string> files;
  std::optional<std::pair<float, float>> range;
  bool list = false, logarithmic = false, linear = false;
};

std::string extension(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

std::unique_ptr<Method> chosen_method(const InspectFlags& flags) {
  std::vector<Replay> replays(1);  // settings are applied to the methods of replays
  replays[0].methods = method_runs({flags.method});
  if (replays[0].methods.size() != 1)
    throw UsageError(fmt::format("--method {}: expected one method", flags.method));
  apply_settings(flags.set, replays);
  auto method = make_method(flags.method);
  for (const auto& [name, value] : replays[0].methods[0].settings) set_parameter(*method, name, value);
  return method;
}

int list_views(const Method& method, bool as_json) {
  json list = json::array();
  for (const Inspection& view : Inspector::inspections(method)) {
    list.push_back({{"id", view.id},
                    {"title", view.title},
                    {"help", view.help},
                    {"unit", view.unit},
                    {"classes", view.classes},
                    {"absent", view.absent},
                    {"slices", view.slices}});
    if (!as_json)
      fmt::print("{:20} {} [{}{}]\n{:20} {}\n", view.id, view.title,
                 view.classes.empty() ? view.unit : fmt::format("{}", fmt::join(view.classes, ", ")),
                 view.slices > 0 ? fmt::format(", --slice 0 to {}", view.slices - 1) : "", "", view.help);
  }
  if (as_json) fmt::print("{}\n", list.dump(2));
  return kDone;
}

Inspection chosen_view(const InspectFlags& flags, const Method& method) {
  const auto view = Inspector::find(method, flags.view);
  if (!view) {
    std::vector<std::string> ids;
    for (const Inspection& known : Inspector::inspections(method)) ids.push_back(known.id);
    throw UsageError(fmt::format("--view {}: {} as it is set has no such view, {}", flags.view, method.id(),
                                 suggestion(flags.view, ids)));
  }
  if (flags.slice >= std::max(view->slices, 1u))
    throw UsageError(view->slices == 0
                         ? fmt::format("--slice {}: the view {} has no slices", flags.slice, view->id)
                         : fmt::format("--slice {}: expected 0 to {}", flags.slice, view->slices - 1));
  return *view;
}

void check(const InspectFlags& flags) {
  if (flags.scene.empty() || flags.view.empty())
    throw UsageError("expected a scene and --view; `plume inspect --list` tells the views");
  for (const std::string& file : flags.files)
    if (extension(file) != ".png" && extension(file) != ".exr")
      throw UsageError(
          fmt::format("--out {}: expected a name that ends in .png, which is coloured, or in "
                      ".exr, which has the numbers",
                      file));
  if (flags.range && !(flags.range->second > flags.range->first))
    throw UsageError(fmt::format("--range {} {}: expected the least number, then the most",
                                 flags.range->first, flags.range->second));
}

void write(const std::string& file, const Inspected& seen, const ValueScale& scale) {
  if (extension(file) == ".png") return write_png(file, image_of(seen, scale));
  Image image{seen.values.width, seen.values.height, {}};
  for (const float value : seen.values.pixels) image.pixels.emplace_back(value);
  write_exr(file, image);
}

json told(const Inspected& seen, const ValueRange& found, const ValueScale& scale) {
  json slices = json::array();
  for (const DepthSlice& slice : seen.slices)
    slices.push_back(
        {{"near_m", slice.near_m}, {"far_m", slice.far_m}, {"virtual_slice", slice.virtual_slice}});
  json result{{"view", seen.what.id},
              {"title", seen.what.title},
              {"unit", seen.what.unit},
              {"size", {seen.values.width, seen.values.height}},
              {"pixels", found.count},
              {"least", nullptr},
              {"most", nullptr},
              {"mean", nullptr},
              {"sum", found.sum},
              {"scale", {{"low", scale.low}, {"high", scale.high}, {"logarithmic", scale.logarithmic}}},
              {"classes", seen.what.classes},
              {"absent", seen.what.absent},
              {"slices", slices}};
  if (found.count > 0) {
    result["least"] = found.least;
    result["most"] = found.most;
    result["mean"] = found.sum / double(found.count);
  }
  if (seen.what.slices > 0) result["slice"] = seen.slice;
  return result;
}

int run_inspect(const InspectFlags& flags) {
  auto method = chosen_method(flags);
  if (flags.list) return list_views(*method, flags.json);
  check(flags);
  const Inspection view = chosen_view(flags, *method);
  const SteadyTexts texts;
  const PresetLibrary library(preset_root());
  Scene scene = library.scene(flags.scene);
  if (auto unknown = check_references(scene, library); !unknown.empty()) throw FileErrors(std::move(unknown));
  if (flags.seed) scene.seed = *flags.seed;

  GpuSession gpu(flags);
  MethodInstance instance{.method = std::move(method), .owner = flags.method, .resources = {}};
  if (const auto missing = instance.method->missing(gpu.device); !missing.empty())
    throw gpu::NoUsableDevice(fmt::format("--method {}: unavailable: needs {}; device '{}' lacks it",
                                          flags.method, fmt::join(missing, ", "), gpu.device.info().name));
  const uint32_t tick = flags.tick.value_or(scene.default_tick);
  const glm::uvec2 size = flags.size.value_or(Replay{}.size);
  Stage stage(gpu.device, gpu.pipelines, library, std::move(scene));
  const Targets targets(gpu.device, size, stage.post());
  stage.go_to(tick, size);
  const Prelude prelude = stage.prelude();
  const Inspected seen = Inspector().inspect(
      {gpu.device, gpu.pipelines, targets, prelude, stage.transparents()}, instance, view, flags.slice);

  const ValueRange found = range_of(seen.values);
  ViewChoice choice{.id = view.id, .slice = flags.slice};
  choice.logarithmic = flags.logarithmic || (view.logarithmic && !flags.linear);
  if (flags.range) choice.range = glm::vec2(flags.range->first, flags.range->second);
  const ValueScale scale = scale_of(choice, view, found);
  for (const std::string& file : flags.files) write(file, seen, scale);
  json result = told(seen, found, scale);
  result["scene"] = stage.scene().id;
  result["tick"] = tick;
  result["method"] = flags.method;
  result["settings"] = parameter_values(*instance.method);
  result["files"] = flags.files;
  fmt::print("{}\n", result.dump(2));
  return report_validation(gpu.device);
}

}  // namespace

void add_inspect(CLI::App& program, Run& run) {
  auto flags = std::make_shared<InspectFlags>();
  CLI::App* command =
      program.add_subcommand("inspect", "a view of what a method did: one number a pixel, and their range");
  command->add_option("SCENE", flags->scene, "id of `plume list scenes`, or a file");
  command->add_option("--view", flags->view, "what is looked at; see --list")->type_name("VIEW");
  command->add_option("--method", flags->method, "id of `plume list methods`")
      ->type_name("METHOD")
      ->capture_default_str();
  command->add_option("--slice", flags->slice, "of the views that have slices, from 0")->type_name("N");
  command->add_option("--at", flags->tick, "tick, 1/60 s; otherwise the scene's own")
      ->type_name("TICK")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--out", flags->files, "FILE.png, coloured, or FILE.exr, the numbers; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  command
      ->add_option("--range", flags->range,
                   "of the colours; otherwise what the view can be, or what is found")
      ->type_name("X");
  auto* logarithmic = command->add_flag("--log", flags->logarithmic, "colours by ratios");
  command->add_flag("--linear", flags->linear, "colours by steps")->excludes(logarithmic);
  command->add_flag("--list", flags->list, "the views of a method as it is set, and no picture");
  command->add_flag("--json", flags->json, "with --list: as JSON");
  add_picture_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_inspect(*flags); }; });
}

}  // namespace plume
