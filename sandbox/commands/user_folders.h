// Where what is the user's own is kept between runs, as the XDG base directory specification says.
#ifndef PLUME_COMMANDS_USER_FOLDERS_H
#define PLUME_COMMANDS_USER_FOLDERS_H

#include <filesystem>
#include <optional>

namespace plume {

/// $PLUME_CACHE, else plume in $XDG_CACHE_HOME, else in ~/.cache; what can be made again. The folder need not
/// be there yet. Nothing: there is no such place, or PLUME_CACHE is "off".
std::optional<std::filesystem::path> cache_folder();
/// $PLUME_CONFIG, else plume in $XDG_CONFIG_HOME, else in ~/.config; what the user has chosen. Nothing: as
/// before, by PLUME_CONFIG.
std::optional<std::filesystem::path> config_folder();

}  // namespace plume
#endif
