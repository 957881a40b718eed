#include "sandbox/commands/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace plume {
namespace {

constexpr std::chrono::milliseconds kOnATerminal(200), kInAPipe(30'000);  // between lines about one thing

/// "12s", "3m 20s", "2h 05m".
std::string duration(double seconds) {
  const auto whole = uint64_t(std::lround(seconds));
  if (whole < 60) return fmt::format("{}s", whole);
  if (whole < 3600) return fmt::format("{}m {:02}s", whole / 60, whole % 60);
  return fmt::format("{}h {:02}m", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::~Progress() {
  if (line_is_open_) fmt::print(stderr, "\n");
}

void Progress::operator()(const Headway& headway) {
  const bool terminal = isatty(STDERR_FILENO), ends = headway.done == headway.total;
  const Clock::time_point now = Clock::now();
  if (headway.within > 0.0 && now - told_ < (terminal ? kOnATerminal : kInAPipe)) return;
  told_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double drawn = double(headway.drawn) + headway.within;
  std::string time;
  if (ends)
    time = " · done in " + duration(elapsed);
  else if (drawn > 0.0)
    time = fmt::format(" · {} left", duration(elapsed / drawn * (double(headway.to_draw) - drawn)));
  if (headway.within > 0.0) time = fmt::format(", {:.0f} % of it{}", 100.0 * headway.within, time);
  line_is_open_ = terminal && !ends;
  fmt::print(stderr, "{}[{}/{}] {}{}{}", terminal ? "\r\x1b[K" : "", headway.done, headway.total,
             headway.what, time, line_is_open_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace plume
