#include "sandbox/commands/help.h"

#include <sstream>

namespace plume {
namespace {

constexpr size_t kNames = 28, kWidth = 100;  // columns

/// Of "TICK:INT in [0 - 20000000]", as the parser names what a flag takes: "0 to 20000000". Empty without.
std::string limits_of(const std::string& type) {
  const size_t open = type.find(" in ["), dash = type.find(" - ", open), close = type.find(']', open);
  if (open == std::string::npos || dash == std::string::npos || close == std::string::npos) return "";
  return type.substr(open + 5, dash - open - 5) + " to " + type.substr(dash + 3, close - dash - 3);
}

std::string wrapped(const std::string& text, size_t width) {
  std::istringstream words(text);
  std::string all, word;
  size_t used = 0;
  while (words >> word) {
    const bool fits = used + 1 + word.size() <= width;
    if (used > 0) all += fits ? ' ' : '\n';
    used = used > 0 && fits ? used + 1 + word.size() : word.size();
    all += word;
  }
  return all;
}

}  // namespace

Help::Help() {
  column_width(kNames);
}

std::string Help::make_option_opts(const CLI::Option* option) const {
  if (option->get_positional() || option->get_type_size() == 0) return "";
  const std::string type = option->get_type_name();
  std::string value = " " + type.substr(0, type.find(':'));
  for (int more = 1; more < option->get_expected_min(); ++more) value += value.substr(0, value.find(' ', 1));
  return option->get_required() ? value + ", needed" : value;
}

std::string Help::make_option_desc(const CLI::Option* option) const {
  std::string text = option->get_description();
  if (const std::string limits = limits_of(option->get_type_name()); !limits.empty())
    text += " (" + limits + ")";
  if (!option->get_default_str().empty()) text += " [" + option->get_default_str() + "]";
  return wrapped(text, kWidth - kNames);
}

}  // namespace plume
