// What --help prints of a flag: the name of its value, its limits, what it is if not given; cut into lines.
#ifndef PLUME_COMMANDS_HELP_H
#define PLUME_COMMANDS_HELP_H

#include <CLI/CLI.hpp>

namespace plume {

class Help : public CLI::Formatter {
 public:
  Help();
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace plume
#endif
