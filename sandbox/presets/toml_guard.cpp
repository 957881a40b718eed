#include "sandbox/presets/toml_guard.h"

#include <algorithm>

namespace plume {
namespace {

constexpr uint32_t kMaxDotsInLine = 512;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

}  // namespace

size_t opaque_length(std::string_view text) {
  if (text.front() == '#') return std::min(text.find('\n'), text.size());
  if (text.front() != '"' && text.front() != '\'') return 0;
  const char quote = text.front();
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool spans_lines = text.starts_with(triple);
  for (size_t i = spans_lines ? 3 : 1; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (!spans_lines && (text[i] == quote || text[i] == '\n')) {
      return i + (text[i] == quote);
    } else if (spans_lines && text.substr(i).starts_with(triple)) {
      i += 3;
      // Up to two quotes may stand directly before the three that close.
      for (int more = 0; more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
      return i;
    }
  }
  return text.size();
}

std::optional<Refusal> refuse_toml(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  uint32_t line = 1, column = 1, dots = 0;
  for (size_t i = 0; i < text.size();) {
    const size_t opaque = opaque_length(text.substr(i));
    if (opaque == 0 && static_cast<unsigned char>(text[i]) >= 0x80)
      return Refusal{
          line, column,
          "a character beyond ASCII outside quotes, expected texts in quotes and plain ASCII elsewhere"};
    if (opaque == 0 && text[i] == '.' && ++dots > kMaxDotsInLine)
      return Refusal{line, column, "more than 512 dots in one line, expected fewer: break the line"};
    for (const size_t end = i + (opaque == 0 ? 1 : opaque); i < end; ++i) {
      if (text[i] == '\n')
        ++line, column = 1, dots = 0;
      else if (!continues_character(text[i]))
        ++column;
    }
  }
  return {};
}

}  // namespace plume
