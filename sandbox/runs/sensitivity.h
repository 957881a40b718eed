// Which parameter of a method buys most accuracy per millisecond: each is moved alone from where it stands,
// and the method so changed is drawn in turns with the unchanged one.
//
// Numbers are halved and doubled within their limits, or stepped by one where the limits are at most 8 apart;
// a number that is 0 goes a tenth of the way to its limits. Toggles are flipped, choices take each other
// option. Error is RMSE, time the method's own; a difference is sure when the error differs by more than
// float noise and the intervals of the times do not meet.
//
// Limits: one step to each side, one parameter at a time, one picture. What two parameters do together, or
// a longer way, is not seen, and another scene may say the contrary.
#ifndef PLUME_RUNS_SENSITIVITY_H
#define PLUME_RUNS_SENSITIVITY_H

#include <array>

#include "sandbox/runs/results.h"
#include "sandbox/scene/replay.h"

namespace plume {

class Method;

/// Parameter and value, as set_parameter() takes them: every way to move one parameter of the method.
std::vector<std::pair<std::string, std::string>> moved_parameters(Method& method);

/// Each method of the replay is followed by itself with one parameter moved.
void add_moved_parameters(Replay& replay);

/// RMSE that differs by less, relatively, or by less than 1e-6, is float noise.
constexpr double kErrorNoise = 1e-3;

struct ParameterChange {
  FrameResult unchanged, changed;
  std::string parameter;

  double error_lost() const { return unchanged.error->rmse - changed.error->rmse; }
  double ms_added() const { return changed.transparency_ms.median - unchanged.transparency_ms.median; }
  bool error_moves() const;
  bool time_moves() const { return tells_apart(unchanged.transparency_ms, changed.transparency_ms); }
  /// Beyond doubt in what its kind says.
  bool sure() const;

  enum class Kind {
    kFree,     ///< less error in less time
    kBuys,     ///< less error for more time
    kSaves,    ///< less time for more error, or for none
    kWorse,    ///< neither
    kNothing,  ///< that can be told
  };
  Kind kind() const;
  /// Error lost per millisecond added (kBuys) or added per millisecond saved (kSaves).
  std::optional<double> accuracy_per_ms() const;
};
constexpr std::array<std::string_view, 5> kParameterChangeKinds{"free", "buys", "saves", "worse", "nothing"};

/// Of each moment and method: the first frame against those after it that differ from it in one parameter.
/// In their order, which no time changes.
std::vector<ParameterChange> parameter_changes(const Results& results);
/// Each method's by itself: free by error lost, then what buys most per millisecond, then what saves at the
/// least error; what is sure before what is not.
std::vector<ParameterChange> best_first(std::vector<ParameterChange> changes);

/// In the order given, a list of {"scene", "tick", "size", "seed", "method", "parameter", "from", "to",
/// "error_before", "error_after", "ms_before", "ms_after", "accuracy_per_ms", "kind", "sure"}.
nlohmann::json to_json(const std::vector<ParameterChange>& changes);
/// For people, best first.
std::string to_table(const std::vector<ParameterChange>& changes);

}  // namespace plume
#endif
