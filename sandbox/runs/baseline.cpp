#include "sandbox/runs/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sandbox/runs/times_alike.h"

namespace plume {
namespace {

using Frames = std::vector<FrameResult>;

constexpr std::string_view kRuler = "reference";

bool same_moment(const FrameResult& a, const FrameResult& b) {
  return a.scene == b.scene && a.tick == b.tick && a.shot == b.shot && a.width == b.width &&
         a.height == b.height && a.seed == b.seed;
}

bool same_settings(const FrameResult& before, const FrameResult& now) {
  const nlohmann::json changed = changed_settings(now);
  for (const auto& [name, value] : before.settings.items())
    if (now.settings.value(name, nlohmann::json()) != value) return false;
  for (const auto& [name, value] : changed.items())
    if (!before.settings.contains(name)) return false;
  return true;
}

const FrameResult* find(const Frames& frames, const auto& is_it) {
  const auto found = std::ranges::find_if(frames, is_it);
  return found == frames.end() ? nullptr : &*found;
}

const FrameResult* ruler_of(const Frames& frames, const FrameResult& frame) {
  return find(frames, [&](const FrameResult& f) {
    return f.method == kRuler && f.status == "ok" && same_moment(f, frame) && f.transparency_ms.low > 0.0;
  });
}

std::string moment_name(const FrameResult& frame) {
  return fmt::format("{} tick {}{} {}x{} seed {}", frame.scene, frame.tick,
                     frame.shot ? fmt::format(" shot {}", frame.shot) : "", frame.width, frame.height,
                     frame.seed);
}
std::string job_name(const FrameResult& frame) {
  return moment_name(frame) + " " + name_of(frame);
}

std::optional<Summary> ratio_of(const Frames& frames, const FrameResult& frame) {
  const FrameResult* ruler = ruler_of(frames, frame);
  if (!ruler) return std::nullopt;
  const Summary &own = frame.transparency_ms, &unit = ruler->transparency_ms;
  return Summary{.median = own.median / unit.median,
                 .low = own.low / unit.high,
                 .high = own.high / unit.low,
                 .samples = std::min(own.samples, unit.samples)};
}

std::string ratio_text(const Summary& ratio) {
  return fmt::format("{:.4f} of {}'s ({:.4f} to {:.4f})", ratio.median, kRuler, ratio.low, ratio.high);
}

class Comparison {
 public:
  Comparison(const Results& baseline, const Results& run, Tolerances tolerances)
      : baseline_(baseline), run_(run), tolerances_(tolerances) {
    const auto differs = [&](const char* name) {
      return baseline.environment.value(name, nlohmann::json()) !=
             run.environment.value(name, nlohmann::json());
    };
    const auto both = [&](const char* name) {
      return fmt::format("{}, this is {}", baseline.environment.value(name, nlohmann::json()).dump(),
                         run.environment.value(name, nlohmann::json()).dump());
    };
    if (differs("device")) {
      tolerances_.time.reset();
      verdict_.notes.push_back("the baseline's device is " + both("device") + ": times are not compared");
    } else if (differs("cpu") && tolerances_.time) {
      verdict_.notes.push_back("the baseline's processor is " + both("cpu") +
                               ": ratios of times may differ for that alone");
    }
  }

  BaselineVerdict verdict() && {
    size_t too_few = 0;
    for (const FrameResult& before : baseline_.frames) {
      const FrameResult* now = find(run_.frames, [&](const FrameResult& f) { return same_job(before, f); });
      if (!now) {
        verdict_.missing.push_back(job_name(before));
        continue;
      }
      ++verdict_.compared;
      compare_status(before, *now);
      if (before.status != "ok" || now->status != "ok") continue;
      compare_error("RMSE", before, *now, &ErrorSummary::rmse);
      compare_error("FLIP", before, *now, &ErrorSummary::flip);
      if (tolerances_.time && before.method != kRuler) too_few += !compare_time(before, *now);
    }
    if (too_few)
      verdict_.notes.push_back(
          fmt::format("times of {} job{} have fewer than {} repetitions, which tell nothing", too_few,
                      too_few == 1 ? "" : "s", kSamplesToTellApart));
    for (const FrameResult& now : run_.frames)
      if (!find(baseline_.frames, [&](const FrameResult& f) { return same_job(f, now); }))
        verdict_.added.push_back(job_name(now));
    return std::move(verdict_);
  }

 private:
  static bool same_job(const FrameResult& before, const FrameResult& now) {
    return before.method == now.method && same_moment(before, now) && same_settings(before, now);
  }

  void compare_status(const FrameResult& before, const FrameResult& now) {
    if ((before.status == "ok") == (now.status == "ok")) return;
    (before.status == "ok" ? verdict_.worse : verdict_.better)
        .push_back({job_name(now), "status", before.status, now.status});
  }

  void compare_error(const char* what, const FrameResult& before, const FrameResult& now,
                     double ErrorSummary::*value) {
    if (!before.error || !now.error) return;
    const double a = before.error.value().*value, b = now.error.value().*value;
    // An infinity is of a picture with a NaN; two of them are equal.
    const auto grew = [&](double from, double to) {
      return to > from && to - from > kErrorFloor && to > from * tolerances_.error;
    };
    if (!grew(a, b) && !grew(b, a)) return;
    (grew(a, b) ? verdict_.worse : verdict_.better)
        .push_back({job_name(now), what, fmt::format("{:.5f}", a), fmt::format("{:.5f}", b)});
  }

  /// False where there are too few repetitions to tell.
  bool compare_time(const FrameResult& before, const FrameResult& now) {
    const auto a = ratio_of(baseline_.frames, before), b = ratio_of(run_.frames, now);
    if (!a || !b) {
      verdict_.notes.push_back(
          fmt::format("{}: {} was not drawn beside it, so its time is not compared", job_name(now), kRuler));
      return true;
    }
    if (std::min(a->samples, b->samples) < kSamplesToTellApart) return false;
    if (!tells_apart(*a, *b)) return true;
    const bool slower = b->median > a->median * *tolerances_.time;
    if (slower || a->median > b->median * *tolerances_.time)
      (slower ? verdict_.worse : verdict_.better)
          .push_back({job_name(now), "own time", ratio_text(*a), ratio_text(*b)});
    return true;
  }

  const Results &baseline_, &run_;
  Tolerances tolerances_;
  BaselineVerdict verdict_;
};

}  // namespace

void require_ratios(const Results& baseline, const Tolerances& tolerances) {
  if (!tolerances.time) return;
  for (const FrameResult& frame : baseline.frames)
    if (frame.status == "ok" && !ruler_of(baseline.frames, frame))
      throw std::runtime_error(fmt::format(
          "the baseline has no time of `{0}` at {1}, which those of the others are taken as ratios "
          "to: draw the baseline again with {0} among its methods, or give --tolerance-time off",
          kRuler, moment_name(frame)));
}

BaselineVerdict against_baseline(const Results& baseline, const Results& run, const Tolerances& tolerances) {
  return Comparison(baseline, run, tolerances).verdict();
}

std::string to_text(const BaselineVerdict& v, const std::string& baseline_name) {
  std::string text =
      fmt::format("against {}: {} jobs compared, {} worse, {} better, {} missing, {} new\n", baseline_name,
                  v.compared, v.worse.size(), v.better.size(), v.missing.size(), v.added.size());
  for (const auto& [title, list] : {std::pair("worse  ", &v.worse), {"better ", &v.better}})
    for (const BaselineVerdict::Finding& f : *list)
      text += fmt::format("  {} {}: {} {} -> {}\n", title, f.job, f.what, f.before, f.after);
  for (const std::string& job : v.missing) text += fmt::format("  missing {}\n", job);
  for (const std::string& job : v.added) text += fmt::format("  new     {}\n", job);
  for (const std::string& note : v.notes) text += fmt::format("  note: {}\n", note);
  return text;
}

}  // namespace plume
