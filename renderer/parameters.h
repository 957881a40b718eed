// One walk over a method's parameters serves the command line, scripts, the window, the report and the docs.
#ifndef PLUME_RENDERER_PARAMETERS_H
#define PLUME_RENDERER_PARAMETERS_H

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace plume {

/// What one parameter is: filled by a method's visit().
struct NumberInfo {
  double min, max;
  std::string_view unit;  ///< "" where it has none
  std::string_view help;  ///< what it trades, one sentence
};

struct Mode {
  std::string_view name, help;
};

/// A method calls exactly one of these per parameter, always in the same order.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;
  virtual void number(std::string_view name, float& value, const NumberInfo& info) = 0;
  virtual void integer(std::string_view name, int& value, const NumberInfo& info) = 0;
  virtual void toggle(std::string_view name, bool& value, std::string_view help) = 0;
  /// `value` is an index into `options`.
  virtual void choice(std::string_view name, int& value, std::span<const std::string_view> options,
                      std::string_view help) = 0;
  /// A choice between few things that each deserve a sentence.
  virtual void modes(std::string_view name, int& value, std::span<const Mode> modes, std::string_view help) {
    std::vector<std::string_view> options;
    for (const Mode& mode : modes) options.push_back(mode.name);
    choice(name, value, options, help);
  }
};

struct ParameterError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Method;

/// Current values, name -> JSON value.
nlohmann::json parameter_values(Method& method);
/// The same as texts that give set_parameter() the same values, to the bit.
std::map<std::string, std::string> parameter_texts(Method& method);
/// Name, type, range or options, unit, help and current value, in the order of the visit.
nlohmann::json parameter_list(Method& method);
/// Sets one parameter from text. Throws ParameterError that names the nearest valid name, the range or the
/// options.
void set_parameter(Method& method, std::string_view name, std::string_view value);

/// The candidate with the least edit distance to `word` (insertions, deletions, replacements and swaps of
/// neighbours, all of cost 1; the first of equals). Empty when even that one is a poor match: more edits than
/// half the longer of the two.
std::string nearest(std::string_view word, std::span<const std::string> candidates);
/// How a message about an unknown word ends: "did you mean `x`?", else "expected one of `a`, `b`".
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace plume
#endif
