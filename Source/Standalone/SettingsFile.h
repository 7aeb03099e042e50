#pragma once

#include "StandaloneSettings.h"

#include <filesystem>
#include <string>

namespace antinode
{
/** $XDG_CONFIG_HOME/antinode/standalone.json, else that in $HOME/.config; empty where neither is set. [any] */
std::filesystem::path usualSettingsFile();

/** Where settings are kept. A file that cannot be read is put aside, never overwritten. */
class SettingsFile
{
public:
    /** @param fileToUse  empty: nothing is read or written [any] */
    explicit SettingsFile (std::filesystem::path fileToUse) : file (std::move (fileToUse)) {}

    /** What is kept, or the defaults; warning() says where a broken file was put aside. [worker] */
    StandaloneSettings load();

    /** Replaces the file in one step, where anything is different.
        @throws InputError  when it cannot be written [worker] */
    void save (const StandaloneSettings&);

    /** What went wrong on loading, in a sentence, or empty. [worker] */
    const std::string& warning() const { return loadWarning; }

private:
    void putAside (const std::string& reason);

    std::filesystem::path file;
    std::string written, loadWarning;
};
} // namespace antinode
