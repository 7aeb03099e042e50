#pragma once

#include "StandaloneSettings.h"

#include <filesystem>
#include <string>

namespace antinode
{
/** $XDG_CONFIG_HOME/antinode/standalone.json, else that in $HOME/.config; empty if neither is set. [any] */
std::filesystem::path usualSettingsFile();

/** The settings file. A file that cannot be read is renamed, never overwritten. */
class SettingsFile
{
public:
    /** @param fileToUse  empty: nothing is read or written [any] */
    explicit SettingsFile (std::filesystem::path fileToUse) : file (std::move (fileToUse)) {}

    /** The saved settings, or the defaults; warning() says where a broken file was moved. [worker] */
    StandaloneSettings load();

    /** Replaces the file in one step, where anything is different.
        @throws InputError  when it cannot be written [worker] */
    void save (const StandaloneSettings&);

    /** The warning of loading, as a sentence, or empty. [worker] */
    const std::string& warning() const { return loadWarning; }

private:
    void putAside (const std::string& reason);

    std::filesystem::path file;
    std::string written, loadWarning;
};
} // namespace antinode
