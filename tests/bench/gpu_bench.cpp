#include "tests/bench/gpu_bench.h"

#include <ctime>

#include "sandbox/measure/statistics.h"

namespace plume {

BenchDevice& bench_device() {
  static BenchDevice device;
  return device;
}

double seconds_of(const std::vector<gpu::PassTime>& passes, std::string_view name) {
  for (const gpu::PassTime& pass : passes)
    if (pass.name == name) return pass.ms * 1e-3;
  throw std::logic_error("no pass " + std::string(name));
}

double copy_seconds(uint64_t bytes_moved) {
  BenchDevice& bench = bench_device();
  static gpu::Buffer from, to;
  const uint64_t bytes = std::max<uint64_t>(bytes_moved / 2, 4);
  if (from.bytes() != bytes) {
    from = gpu::Buffer(bench.device, {.owner = "bench", .label = "from", .bytes = bytes});
    to = gpu::Buffer(bench.device, {.owner = "bench", .label = "to", .bytes = bytes});
    copy_seconds(bytes_moved);  // touches the pages
  }
  gpu::Frame frame(bench.device, bench.pipelines);
  frame.pass("copy", [&](gpu::Pass& pass) {
    pass.commands().copyBuffer(from.vk(), to.vk(), vk::BufferCopy{.size = bytes});
  });
  return seconds_of(frame.finish(), "copy");
}

double cpu_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void AgainstCopy::add(double seconds) {
  state_.SetIterationTime(seconds);
  seconds_.push_back(seconds);
  const double before = cpu_seconds();
  copies_.push_back(copy_seconds(uint64_t(items_ * bytes_per_item_)));
  cpu_copies_.push_back(cpu_seconds() - before);
}

void AgainstCopy::measure(const std::function<double()>& work) {
  const double before = cpu_seconds(), seconds = work();
  cpu_seconds_.push_back(cpu_seconds() - before);
  add(seconds);
}

AgainstCopy::~AgainstCopy() {
  if (seconds_.empty()) return;
  const double median = summarise(seconds_).median;
  state_.counters[unit_] = items_ / median;
  state_.counters["bytes_per_item"] = bytes_per_item_;
  state_.counters["ratio_to_copy"] = median / summarise(copies_).median;
  if (cpu_seconds_.empty()) return;
  const double cpu = summarise(cpu_seconds_).median;
  state_.counters["cpu_ns"] = cpu / items_ * 1e9;
  state_.counters["cpu_ratio_to_copy"] = cpu / summarise(cpu_copies_).median;
}

}  // namespace plume

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::AddCustomContext("device", plume::bench_device().device.info().name);
  benchmark::AddCustomContext("driver", plume::bench_device().device.info().driver);
  benchmark::RunSpecifiedBenchmarks();
}
