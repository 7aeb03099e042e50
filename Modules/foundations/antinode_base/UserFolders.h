#pragma once

#include <filesystem>
#include <optional>

namespace antinode
{
/** Where programs keep a user's data: $XDG_DATA_HOME, else $HOME/.local/share; on Windows %APPDATA%. None where neither
   is set to an absolute path. XDG base directory specification. [any] */
std::optional<std::filesystem::path> userDataHome();

/** Where programs keep a user's settings: $XDG_CONFIG_HOME, else $HOME/.config; on Windows %APPDATA%. [any] */
std::optional<std::filesystem::path> userConfigHome();

/** Where programs keep what they can compute again: $XDG_CACHE_HOME, else $HOME/.cache; on Windows %LOCALAPPDATA%.
 * [any] */
std::optional<std::filesystem::path> userCacheHome();
} // namespace antinode
