#include "sandbox/runs/machine_load.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>

namespace plume {
namespace {

namespace fs = std::filesystem;

/// "" where there is no such file.
std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Calls `entry` for every "key : value" of /proc/cpuinfo.
template <class Entry>
void visit_cpuinfo(const fs::path& root, const Entry& entry) {
  std::istringstream lines(text_of(root / "proc/cpuinfo"));
  for (std::string line; std::getline(lines, line);) {
    const size_t colon = line.find(':');
    if (colon == line.npos) continue;
    const size_t end = line.find_last_not_of(" \t", colon - 1),
                 begin = line.find_first_not_of(" \t", colon + 1);
    if (colon == 0 || end == line.npos || begin == line.npos) continue;
    entry(line.substr(0, end + 1), line.substr(begin));
  }
}

std::optional<double> number_of(const std::string& text) {
  std::istringstream in(text);
  double value = 0;
  return in >> value ? std::optional(value) : std::nullopt;
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

std::optional<double> clock_mhz(const fs::path& root) {
  std::vector<double> mhz;
  for (unsigned cpu = 0;; ++cpu) {
    const auto khz =
        number_of(text_of(root / fmt::format("sys/devices/system/cpu/cpu{}/cpufreq/scaling_cur_freq", cpu)));
    if (!khz) break;
    mhz.push_back(*khz / 1000.0);
  }
  if (mhz.empty())
    visit_cpuinfo(root, [&](const std::string& key, const std::string& value) {
      if (const auto number = number_of(value); key == "cpu MHz" && number) mhz.push_back(*number);
    });
  return mean(mhz);
}

/// See proc(5).
std::optional<MachineLoad::Ticks> read_ticks(const fs::path& root) {
  std::istringstream all(text_of(root / "proc/stat"));
  std::string name;
  uint64_t user, nice, system, idle, wait, irq, softirq, stolen;
  if (!(all >> name >> user >> nice >> system >> idle >> wait >> irq >> softirq >> stolen))
    return std::nullopt;
  // The second field is the program's name in brackets, which may hold anything.
  const std::string self = text_of(root / "proc/self/stat");
  const size_t bracket = self.rfind(')');
  if (bracket == self.npos) return std::nullopt;
  std::istringstream own(self.substr(bracket + 1));
  for (int field = 3; field < 14; ++field) own >> name;
  uint64_t mine, mine_in_system, children, children_in_system;
  if (!(own >> mine >> mine_in_system >> children >> children_in_system)) return std::nullopt;
  const uint64_t busy = user + nice + system + irq + softirq;
  return MachineLoad::Ticks{.own = mine + mine_in_system + children + children_in_system,
                            .busy = busy,
                            .stolen = stolen,
                            .total = busy + idle + wait + stolen};
}

}  // namespace

Processor read_processor(const fs::path& root) {
  Processor processor{.threads = 0};
  std::string package;
  std::set<std::pair<std::string, std::string>> cores;
  visit_cpuinfo(root, [&](const std::string& key, const std::string& value) {
    if (key == "processor") ++processor.threads;
    if (key == "model name") processor.name = value;
    if (key == "physical id") package = value;
    if (key == "core id") cores.emplace(package, value);
  });
  processor.threads = std::max(processor.threads, 1u);
  processor.cores = cores.empty() ? processor.threads : unsigned(cores.size());
  return processor;
}

MachineLoad read_machine_load(const fs::path& root) {
  std::string governor;
  std::istringstream(text_of(root / "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")) >> governor;
  return {.load_average = number_of(text_of(root / "proc/loadavg")),
          .governor = governor,
          .mhz = clock_mhz(root),
          .ticks = read_ticks(root)};
}

std::vector<Note> load_notes(const MachineLoad& before, const MachineLoad& after, unsigned threads) {
  std::vector<Note> notes;
  // Afterwards it counts this program too, of which each thread that draws and one that waits want to run.
  if (before.load_average && after.load_average &&
      (*before.load_average > threads || *after.load_average > threads + 1))
    notes.push_back(
        {"load", fmt::format("The load average was {:.1f} before and {:.1f} after on {} processor thread{}: "
                             "more wanted to run than could.",
                             *before.load_average, *after.load_average, threads, threads == 1 ? "" : "s")});
  if (before.ticks && after.ticks && after.ticks->total > before.ticks->total) {
    const auto share = [total = double(after.ticks->total - before.ticks->total)](uint64_t from,
                                                                                  uint64_t to) {
      return to > from ? double(to - from) / total : 0.0;
    };
    const double own = share(before.ticks->own, after.ticks->own),
                 others = share(before.ticks->busy, after.ticks->busy) - own,
                 stolen = share(before.ticks->stolen, after.ticks->stolen);
    if (others > 0.05)
      notes.push_back({"processes", fmt::format("Other processes used {:.0f} % of the processors' time, this "
                                                "one {:.0f} %: on a CPU device times are longer for it.",
                                                others * 100.0, own * 100.0)});
    if (stolen > 0.02)
      notes.push_back(
          {"host",
           fmt::format("The host gave {:.0f} % of the processors' time to other machines.", stolen * 100.0)});
  }
  if (!after.governor.empty() && after.governor != "performance")
    notes.push_back({"clock", fmt::format("The processors' frequency governor is {}: clocks follow the load, "
                                          "so what runs shortly may run slower.",
                                          after.governor)});
  if (before.mhz && after.mhz && std::abs(*after.mhz / *before.mhz - 1.0) > 0.05)
    notes.push_back({"clock", fmt::format("The processors' clock was {:.0f} MHz before and {:.0f} MHz after.",
                                          *before.mhz, *after.mhz)});
  return notes;
}

}  // namespace plume
