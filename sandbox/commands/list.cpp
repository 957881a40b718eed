// plume list: what methods, effects, scenes, replays and devices there are.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/gpu/errors.h"
#include "renderer/methods/methods.h"
#include "sandbox/commands/command.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/stage.h"

namespace plume {
namespace {

using nlohmann::json;

struct ListFlags : DrawFlags {
  std::string what;
  std::string scene;             ///< of effects: what its instances cost
  std::optional<uint32_t> tick;  ///< of that scene
  glm::uvec2 picture() const { return size.value_or(glm::uvec2(640, 360)); }
};

/// Of a method at a size, with nothing to draw, and for each card more; lists of fragments grow beyond it.
json memory_of(const Method& method, glm::uvec2 size) {
  Transparents cards;
  const uint64_t empty = bytes_of(method.needs(size, cards), size);
  cards.count = cards.counts[size_t(Source::kScalar)] = 100'000;
  const uint64_t full = bytes_of(method.needs(size, cards), size);
  return {{"size", {size.x, size.y}}, {"bytes", empty}, {"bytes_a_card", double(full - empty) / 100'000}};
}

/// The device that methods are asked about; none where none can be opened, which a list does without.
std::unique_ptr<gpu::Device> device_to_ask(const ListFlags& flags) try {
  return std::make_unique<gpu::Device>(device_options(flags));
} catch (const gpu::NoUsableDevice&) {
  if (!flags.device.empty()) throw;
  return nullptr;
}

json list_methods(const ListFlags& flags) {
  const glm::uvec2 size = flags.picture();
  const auto device = device_to_ask(flags);
  json list = json::array();
  for (const std::string& id : method_ids()) {
    const auto method = make_method(id);
    const Traits traits = method->traits();
    list.push_back({{"id", id},
                    {"title", traits.title},
                    {"source", traits.source},
                    {"transmission", traits.transmission},
                    {"emission", traits.emission},
                    {"outputs", to_text(method->outputs())},
                    {"limits", traits.limits},
                    {"exact", traits.exact},
                    {"street_rmse", traits.exact ? json(nullptr) : json(traits.street_rmse)},
                    {"memory", memory_of(*method, size)},
                    {"missing", device ? json(method->missing(*device)) : json(nullptr)},
                    {"parameters", parameter_list(*method)}});
  }
  return list;
}

json list_effects(const PresetLibrary& library) {
  json list = json::array();
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    const Effect effect = library.effect(id);
    json emitters = json::array();
    uint64_t capacity = 0, last_tick = 0;
    for (const Emitter& emitter : effect.emitters) {
      const SpawnSchedule schedule(emitter.spawn);
      capacity += schedule.capacity();
      last_tick = std::max<uint64_t>(last_tick, schedule.last_tick());
      emitters.push_back(
          {{"name", emitter.name}, {"births", schedule.births_total()}, {"capacity", schedule.capacity()}});
    }
    list.push_back({{"id", id},
                    {"title", effect.name},
                    {"description", effect.description},
                    {"seconds", double(last_tick) / kTicksPerSecond},
                    {"capacity", capacity},
                    {"emitters", emitters}});
  }
  return list;
}

json list_scenes(const PresetLibrary& library) {
  json list = json::array();
  for (const std::string& id : library.ids(PresetKind::kScene)) {
    const Scene scene = library.scene(id);
    json instances = json::array();
    for (const Instance& i : scene.instances)
      instances.push_back({{"name", i.name},
                           {"effect", i.effect},
                           {"call_tick", i.call_tick ? json(*i.call_tick) : json(nullptr)}});
    list.push_back({{"id", id},
                    {"title", scene.name},
                    {"description", scene.description},
                    {"duration_ticks", scene.duration_ticks},
                    {"default_tick", scene.default_tick},
                    {"instances", instances}});
  }
  return list;
}

std::string description_of(const Replay& replay) {
  if (!replay.shots.empty()) return fmt::format("{} pictures", replay.shots.size());
  if (replay.sweeps.empty())
    return fmt::format("{} on {} ticks of {}", replay.methods.size(), replay.ticks.size(), replay.scene);
  double jobs = 0;
  for (const Sweep& sweep : replay.sweeps) jobs += jobs_of(sweep);
  return fmt::format("sweep of {} jobs", jobs);
}

json list_replays(const PresetLibrary& library) {
  json list = json::array();
  for (const std::string& id : library.ids(PresetKind::kReplay)) {
    const Replay replay = library.replay(id);
    json methods = json::array();
    for (const MethodRun& run : replay.methods)
      methods.push_back({{"id", run.id}, {"settings", run.settings}});
    list.push_back({{"id", id},
                    {"title", replay.name},
                    {"description", description_of(replay)},
                    {"scene", replay.scene},
                    {"ticks", replay.ticks},
                    {"size", {replay.size.x, replay.size.y}},
                    {"methods", methods}});
  }
  return list;
}

json list_devices() {
  json list = json::array();
  for (const gpu::DeviceInfo& d : gpu::list_devices())
    list.push_back({{"id", std::to_string(list.size())},
                    {"title", d.name},
                    {"description",
                     fmt::format("{}, Vulkan {}{}", d.driver, d.api, d.is_cpu ? ", runs on the CPU" : "")}});
  return list;
}

/// Which instances of a scene are awake at a tick, and why, when one goes there directly.
int list_demand(const ListFlags& flags) {
  const SteadyTexts texts;
  const PresetLibrary library(preset_root());
  Scene scene = library.scene(flags.scene);
  if (auto unknown = check_references(scene, library); !unknown.empty()) throw FileErrors(std::move(unknown));
  GpuSession gpu(flags);
  const uint32_t tick = flags.tick.value_or(scene.default_tick);
  Stage stage(gpu.device, gpu.pipelines, library, std::move(scene));
  stage.go_to(tick, flags.picture());
  const std::vector<InstanceDemand> demand = stage.demand();
  if (flags.json) {
    json result = demand_json(demand);
    result.update({{"scene", stage.scene().id}, {"tick", tick}});
    fmt::print("{}\n", result.dump(2));
    return report_validation(gpu.device);
  }
  const auto line = [](const InstanceDemand& d, std::string_view state) {
    fmt::print("{:<20} {:<7} {:>9} {:>9} {:>12} {:>12}  {}\n", d.name, state, d.ticks_simulated,
               d.ticks_saved, d.bytes, d.bytes_saved, d.why);
  };
  fmt::print("{:<20} {:<7} {:>9} {:>9} {:>12} {:>12}  {}\n", "instance", "", "ticks", "saved", "bytes",
             "saved", fmt::format("why, at tick {}", tick));
  for (const InstanceDemand& instance : demand) line(instance, instance.awake ? "awake" : "asleep");
  line(total(demand), "");
  return report_validation(gpu.device);
}

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "0.001 .. 1000 1/m" or "eq7 | eq8".
std::string range_of(const json& parameter) {
  if (parameter.contains("options")) {
    std::vector<std::string> options = parameter["options"];
    return fmt::format("{}", fmt::join(options, " | "));
  }
  if (!parameter.contains("min")) return "true | false";
  const std::string unit = parameter.value("unit", "");
  return fmt::format("{} .. {}{}{}", text_of(parameter["min"]), text_of(parameter["max"]),
                     unit.empty() ? "" : " ", unit);
}

void print_for_people(const json& list) {
  for (const json& entry : list) {
    fmt::print("{:<16} {}\n", text_of(entry["id"]), text_of(entry["title"]));
    for (const char* key : {"description", "source", "transmission", "emission", "outputs", "limits"})
      if (entry.contains(key)) fmt::print("    {}: {}\n", key, text_of(entry[key]));
    if (const json missing = entry.value("missing", json()); !missing.empty())
      fmt::print("    unavailable: needs {}\n", fmt::join(missing.get<std::vector<std::string>>(), ", "));
    if (entry.contains("memory")) {
      const json& memory = entry["memory"];
      fmt::print("    error: {}\n",
                 entry["exact"] ? "none while nothing overflows"
                                : fmt::format("RMSE on street below {}", text_of(entry["street_rmse"])));
      fmt::print("    memory at {}x{}: {:.1f} MiB, {:.0f} bytes a card\n", text_of(memory["size"][0]),
                 text_of(memory["size"][1]), memory["bytes"].get<double>() / 1048576.0,
                 memory["bytes_a_card"].get<double>());
    }
    for (const json& p : entry.value("parameters", json::array()))
      fmt::print("    --set {}.{}={}   [{}]  {}\n", text_of(entry["id"]), text_of(p["name"]),
                 text_of(p["value"]), range_of(p), text_of(p["help"]));
  }
}

int run_list(const ListFlags& flags) {
  if ((!flags.scene.empty() || flags.tick) && flags.what != "effects")
    throw UsageError(
        "--scene and --at tell what the instances of a scene cost: they go with `plume list effects`");
  if (flags.scene.empty() && flags.tick) throw UsageError("--at needs a scene: --scene SCENE");
  if (!flags.scene.empty()) return list_demand(flags);
  json list;
  if (flags.what == "methods") list = list_methods(flags);
  if (flags.what == "devices") list = list_devices();
  if (list.is_null()) {
    const PresetLibrary library(preset_root());
    list = flags.what == "effects"  ? list_effects(library)
           : flags.what == "scenes" ? list_scenes(library)
                                    : list_replays(library);
  }
  if (flags.json)
    fmt::print("{}\n", list.dump(2));
  else
    print_for_people(list);
  return kDone;
}

}  // namespace

void add_list(CLI::App& program, Run& run) {
  auto flags = std::make_shared<ListFlags>();
  CLI::App* command =
      program.add_subcommand("list", "what methods, effects, scenes, replays and devices there are");
  command->add_option("WHAT", flags->what, "methods, effects, scenes, replays or devices")
      ->required()
      ->check([](const std::string& what) {
        const std::vector<std::string> known{"methods", "effects", "scenes", "replays", "devices"};
        const bool found = std::find(known.begin(), known.end(), what) != known.end();
        return found ? "" : fmt::format("unknown list `{}`, {}", what, suggestion(what, known));
      });
  command
      ->add_option("--scene", flags->scene,
                   "with effects: which instances of this scene are awake, why, and what they cost")
      ->type_name("SCENE");
  command->add_option("--at", flags->tick, "with --scene: tick, 1/60 s; otherwise the scene's own")
      ->type_name("TICK")
      ->check(CLI::Range(0u, kMaxTick));
  command
      ->add_option("--device", flags->device,
                   "part of a device's name, or its index in `plume list devices`: with --scene, and with "
                   "methods, which "
                   "of them it cannot run")
      ->type_name("DEVICE");
  command
      ->add_option_function<std::string>(
          "--size", [flags](const std::string& text) { flags->size = parse_size(text); },
          "picture size: of the methods' memory, or of what a scene's camera sees")
      ->type_name("WxH");
  command->add_flag("--json", flags->json, "everything, for programs");
  command->callback([flags, &run] { run = [flags] { return run_list(*flags); }; });
}

}  // namespace plume
