#include "SettingsFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Processes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_library/Library.h>

#include <fstream>
#include <system_error>

namespace antinode
{
namespace
{
namespace fs = std::filesystem;

/** An unused name in the folder of the file. */
fs::path freeName (const fs::path& file)
{
    auto name = file;
    name += ".broken";
    int i = 2;

    for (std::error_code unknown; fs::exists (name, unknown); ++i)
        (name = file) += ".broken-" + std::to_string (i);

    return name;
}
} // namespace

fs::path usualSettingsFile()
{
    const auto folder = userConfigFolder();
    return folder ? *folder / "standalone.json" : fs::path();
}

StandaloneSettings SettingsFile::load()
{
    std::error_code ignored;

    if (file.empty() || ! fs::exists (file, ignored))
        return {};

    try
    {
        auto text = readWholeFile (file, {});
        auto settings = readSettings (text);
        written = std::move (text);
        return settings;
    }
    catch (const InputError& failure)
    {
        putAside (failure.what());
        return {};
    }
}

void SettingsFile::putAside (const std::string& reason)
{
    const auto aside = freeName (file);
    std::error_code failure;
    fs::rename (file, aside, failure);
    loadWarning = "The settings could not be read (" + reason + "), so they ";

    if (failure)
    {
        loadWarning += "remain in " + file.string() + ", and no settings are saved this time.";
        file.clear();
        return;
    }

    loadWarning += "were moved to " + aside.string() + ", and the defaults apply.";
}

void SettingsFile::save (const StandaloneSettings& settings)
{
    auto text = settingsToText (settings);

    if (file.empty() || text == written)
        return;

    // A name of this process, in the same folder: so the step at the end is one rename.
    auto temporary = file;
    temporary += "." + std::to_string (ownProcess());
    std::error_code failure;
    fs::create_directories (file.parent_path(), failure);
    std::ofstream stream (temporary, std::ios::binary);
    stream << text << std::flush;
    const auto isWritten = stream.good();
    stream.close();

    if (isWritten)
        fs::rename (temporary, file, failure);

    if (! isWritten || failure)
    {
        fs::remove (temporary, failure);
        throw InputError (file.string(), "the settings cannot be written");
    }

    written = std::move (text);
}
} // namespace antinode
