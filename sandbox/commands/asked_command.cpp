#include "sandbox/commands/asked_command.h"

#include <string_view>

namespace plume {
namespace {

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

std::vector<std::string> asked_arguments(const CLI::App& command) {
  std::vector<std::string> arguments{command.get_name()}, flags;
  for (const CLI::Option* option : command.get_options()) {
    const std::string& group = option->get_group();  // "": hidden
    if (option->count() == 0 || group == kThisRun || group.empty()) continue;
    if (option->get_positional()) {
      for (const std::string& value : option->results()) arguments.push_back(value);
      continue;
    }
    const std::string name = "--" + option->get_lnames().front();
    if (option->get_items_expected_max() == 0) {
      flags.push_back(name);
    } else if (const char delimiter = option->get_delimiter()) {
      flags.insert(flags.end(), {name, CLI::detail::join(option->results(), std::string(1, delimiter))});
    } else {
      for (const std::string& value : option->results()) flags.insert(flags.end(), {name, value});
    }
  }
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  return arguments;
}

std::string shell_text(const std::vector<std::string>& arguments) {
  std::string text = "plume";
  for (const std::string& argument : arguments) text += " " + quoted(argument);
  return text;
}

}  // namespace plume
