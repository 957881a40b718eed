// What the panels cost the processor in a frame: to describe all of them, everything in them opened out, and
// to record their drawing. Time of the thread, so that other programs add nothing. `drawn_ms` is the time of
// all threads while a CPU device then draws them: the device's part, on a GPU next to nothing.
#include <imgui.h>
#include <imgui_internal.h>

#include "sandbox/debugger/panels.h"
#include "sandbox/measure/statistics.h"
#include "sandbox/window/overlay.h"
#include "sandbox/workspace/cpu_clock.h"
#include "tests/bench/gpu_bench.h"

namespace plume {
namespace {

constexpr glm::uvec2 kWindow{1280, 720};

/// Panels, tables and graphs of two sides, of the crosshair and of an effect's fields; the list of keys.
struct OpenPanels {
  OpenPanels(const std::string& name, uint32_t tick)
      : workspace(bench.device, bench.pipelines, bench.library, bench.library.scene(name),
                  Playback(tick, tick + 100, false)) {
    ImGui::GetIO().DisplaySize = {float(kWindow.x), float(kWindow.y)};
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    workspace.compare(Comparison::kSplit);
    workspace.compares = true;
    interface.crosshair.place(glm::dvec2(0.0, 0.1));
    interface.crosshair.ask_of_others(workspace, {"moments", "wboit"});
    interface.help = true;
    interface.effects.name = workspace.scene().instances.front().effect;
    interface.effects.instance = workspace.scene().instances.front().name;
    interface.effects.emitter = 0;
    for (int i = 0; i < 4; ++i) frame(), open_trees();
    workspace.draw(kWindow / 8u);
    workspace.measure_accuracy();
    workspace.draw(kWindow / 8u);    // over the reference
    for (int i = 0; i < 300; ++i) {  // a full history of times
      for (Side* side : {&workspace.a, &workspace.b}) side->timings.add(side->report.passes);
    }
    for (int i = 0; i < 2; ++i) interface.crosshair.update(workspace, seconds += 1);
  }

  void frame() {
    overlay.begin(1.0f, 1.0f, {}, interface.gallery);
    describe_panels(interface);
    overlay.end();
  }
  /// Instances, the fields' tables and the depths: as if each had been clicked.
  void open_trees() {
    const ImGuiID panel = ImHashStr("Effects", 0, ImHashStr("left"));
    std::vector<ImGuiID> trees{ImHashStr("depth in the picture", 0, panel)};
    for (int i = 0; i < int(workspace.scene().instances.size()); ++i)
      trees.push_back(ImHashStr("instance", 0, ImHashData(&i, sizeof i, ImHashStr("hierarchy", 0, panel))));
    for (const Field& field : workspace.documents.open(interface.effects.name).fields())
      trees.push_back(ImHashStr(field.path.c_str(), 0, ImHashStr(interface.effects.name.c_str(), 0, panel)));
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
      for (const ImGuiID tree : trees) window->StateStorage.SetInt(tree, 1);
  }
  /// Another picture, of which all that is shown must be found out anew.
  void play() {
    workspace.playback.go_to(workspace.playback.tick() + 1);
    workspace.change();
    workspace.draw(kWindow / 8u);
    interface.crosshair.update(workspace, seconds += 1);
  }
  void record(const vk::raii::CommandBuffer& commands) {
    overlay.record(commands, {.image = image.vk(), .view = image.view(), .extent = {kWindow.x, kWindow.y}});
  }

  BenchDevice& bench = bench_device();
  gpu::Image image{bench.device,
                   {.owner = "bench",
                    .label = "window",
                    .format = vk::Format::eR8G8B8A8Unorm,
                    .extent = {kWindow.x, kWindow.y, 1},
                    .usage = vk::ImageUsageFlagBits::eColorAttachment}};
  Overlay overlay{bench.device, nullptr, image.format()};
  Workspace workspace;
  Interface interface { workspace };
  double seconds = 0;
};

void BM_Overlay(benchmark::State& state, const char* scene, uint32_t tick, bool plays) {
  OpenPanels panels(scene, tick);
  for (int i = 0; i < 10; ++i) panels.frame();
  std::vector<double> described, recorded, drawn;
  for (auto _ : state) {
    if (plays) panels.play();
    const double start = thread_cpu_ms();
    panels.frame();
    const double between = thread_cpu_ms();
    const auto commands = panels.bench.device.new_commands();
    commands.begin(vk::CommandBufferBeginInfo{});
    const double before = thread_cpu_ms();
    panels.record(commands);
    const double end = thread_cpu_ms();
    commands.end();
    described.push_back(between - start);
    recorded.push_back(end - before);
    state.SetIterationTime(1e-3 * (described.back() + recorded.back()));
    const double all = cpu_seconds();
    panels.bench.device.submit_and_wait(commands);
    drawn.push_back((cpu_seconds() - all) * 1e3);
  }
  std::vector<double> sums(described);
  for (size_t i = 0; i < sums.size(); ++i) sums[i] += recorded[i];
  state.counters["median_ms"] = summarise(sums).median;
  state.counters["p95_ms"] = summarise(sums).p95;
  state.counters["described_ms"] = summarise(described).median;
  state.counters["recorded_ms"] = summarise(recorded).median;
  state.counters["drawn_ms"] = summarise(drawn).median;
  state.counters["vertices"] = ImGui::GetDrawData()->TotalVtxCount;
}

void still(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseManualTime()->Iterations(200)->Unit(benchmark::kMillisecond);
}
void playing(benchmark::internal::Benchmark* benchmark) {
  benchmark->UseManualTime()->Iterations(20)->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(BM_Overlay, street_still, "street", 400, false)->Apply(still);
BENCHMARK_CAPTURE(BM_Overlay, everything_still, "everything", 660, false)->Apply(still);
BENCHMARK_CAPTURE(BM_Overlay, street_playing, "street", 400, true)->Apply(playing);
BENCHMARK_CAPTURE(BM_Overlay, everything_playing, "everything", 660, true)->Apply(playing);

}  // namespace
}  // namespace plume
