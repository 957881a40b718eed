// The passes of the methods on the street: sort, splat and draw, in fragments per second, against a copy of
// what blending moves.
#include <map>

#include "renderer/radix_sort.h"
#include "sandbox/measure/statistics.h"
#include "shaders/methods/parts/fragment_list/fragment_list.h"
#include "tests/bench/gpu_bench.h"

namespace plume {
namespace {

constexpr double kBlendBytes = 16;  // RGBA16F, read and written

struct Street {
  explicit Street(uint32_t hidden_cards = 0) {
    Scene scene = bench.library.scene("street");
    scene.panes.insert(scene.panes.begin(), hidden_cards, Pane{.coverage = 0.0f});
    stage.emplace(bench.device, bench.pipelines, bench.library, std::move(scene));
    stage->go_to(stage->scene().default_tick, targets.size);
  }
  BenchDevice& bench = bench_device();
  std::optional<Stage> stage;
  Targets targets{bench.device, {640, 360}};

  MethodInstance method(std::string_view id) {
    MethodInstance made{.method = make_method(id), .owner = std::string(id), .resources = {}};
    draw(made);
    return made;
  }
  std::vector<gpu::PassTime> draw(MethodInstance& method) {
    return render_frame(bench.device, bench.pipelines, targets, stage->prelude(), stage->transparents(),
                        method)
        .passes;
  }
  /// Fragments that cover or emit anything, as the reference counts them.
  double fragments() {
    MethodInstance reference = method("reference");
    return gpu::read<shared::FragmentPool>(bench.device, reference.resources.buffer("pool"))[0].count;
  }
};

void BM_Pass(benchmark::State& state, const char* id, const char* pass) {
  Street street;
  const double fragments = street.fragments();
  MethodInstance method = street.method(id);
  AgainstCopy result(state, "fragments/s", fragments, kBlendBytes);
  for (auto _ : state) result.add(seconds_of(street.draw(method), pass));
}

void BM_Sort(benchmark::State& state) {
  BenchDevice& bench = bench_device();
  const uint32_t count = uint32_t(state.range(0));
  std::vector<glm::uvec2> pairs(count);
  uint32_t random = 1;
  for (glm::uvec2& pair : pairs) pair = {random = random * 1664525u + 1013904223u, 0};
  const gpu::Buffer unsorted = gpu::make_buffer(bench.device, "bench", "unsorted", pairs);
  const gpu::Buffer keys(bench.device, {.owner = "bench", .label = "keys", .bytes = unsorted.bytes()});
  const gpu::Buffer scratch(bench.device, {.owner = "bench", .label = "scratch", .bytes = unsorted.bytes()});
  const gpu::Buffer counts(bench.device,
                           {.owner = "bench", .label = "counts", .bytes = radix_counts_bytes(count)});
  const gpu::Buffer work =
      gpu::make_buffer(bench.device, "bench", "work", std::vector{shared::workload_of(count)});
  AgainstCopy result(state, "cards/s", count, 2 * sizeof(glm::uvec2));
  for (auto _ : state) {
    gpu::Frame frame(bench.device, bench.pipelines);
    frame.pass("reset", [&](gpu::Pass& pass) {
      pass.commands().copyBuffer(unsorted.vk(), keys.vk(), vk::BufferCopy{.size = keys.bytes()});
    });
    frame.pass("sort", [&](gpu::Pass& pass) { radix_sort(pass, keys, scratch, counts, work); });
    result.add(seconds_of(frame.finish(), "sort"));
  }
}

/// The street with so many more cards that show nothing, against the street, in turns.
void BM_Hidden(benchmark::State& state) {
  Street street, hiding(uint32_t(state.range(0)));
  MethodInstance method = street.method("sorted");
  hiding.draw(method);
  const std::array kPasses{"seen cards", "light", "sort", "draw"};
  std::map<std::string, std::vector<double>> added;
  for (auto _ : state) {
    const auto few = street.draw(method), many = hiding.draw(method);
    double all = 0;
    for (const char* pass : kPasses) {
      added[pass].push_back(1e3 * (seconds_of(many, pass) - seconds_of(few, pass)));
      all += seconds_of(many, pass);
    }
    state.SetIterationTime(all);
  }
  for (const char* pass : kPasses) state.counters[std::string(pass) + " +ms"] = summarise(added[pass]).median;
}

BENCHMARK(BM_Hidden)->Arg(1'000)->Arg(100'000)->Apply(timed);
BENCHMARK(BM_Sort)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, avboit_splat, "avboit", "splat")->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, avboit_draw, "avboit", "draw")->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, wboit_draw, "wboit", "draw")->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, sorted_draw, "sorted", "draw")->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, reference_capture, "reference", "capture")->Apply(timed);
BENCHMARK_CAPTURE(BM_Pass, reference_composite, "reference", "composite")->Apply(timed);

}  // namespace
}  // namespace plume
