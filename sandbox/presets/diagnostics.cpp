#include "sandbox/presets/diagnostics.h"

#include <fmt/format.h>

#include <utility>

namespace plume {
namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_string(diagnostic);
  }
  return text;
}

}  // namespace

std::string to_string(const Diagnostic& d) {
  return fmt::format("{}:{}:{}: {}", d.file, d.line, d.column, d.message);
}

FileErrors::FileErrors(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace plume
