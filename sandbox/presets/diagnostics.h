// What is wrong in a file a user wrote, in the form every reader reports it.
#ifndef PLUME_PRESETS_DIAGNOSTICS_H
#define PLUME_PRESETS_DIAGNOSTICS_H

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace plume {

/// One mistake. `message` says what is wrong, then what would be right ("…, expected …" or "…, did you mean
/// …?").
struct Diagnostic {
  std::string file;
  uint32_t line = 1;    ///< from 1
  uint32_t column = 1;  ///< from 1, in characters
  std::string message;
};

/// `file:line:column: message`, the form editors jump to.
std::string to_string(const Diagnostic& diagnostic);

/// Everything that is wrong in one file; what() is one diagnostic a line.
class FileErrors : public std::runtime_error {
 public:
  explicit FileErrors(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace plume
#endif
