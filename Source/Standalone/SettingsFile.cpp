#include "SettingsFile.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Processes.h>
#include <antinode_base/WholeFile.h>
#include <antinode_documents/Library.h>
#include <antinode_text/OutputFolder.h>

#include <charconv>
#include <system_error>
#include <vector>

namespace antinode
{
namespace
{
namespace fs = std::filesystem;

constexpr int largestProcess = 1 << 22; // of Linux; what is above is a date, or somebody's count

/** What earlier versions left when they were killed: files beside it that end with the number of a dead process. */
void removeAbandonedCopies (const fs::path& file)
{
    std::error_code ignored;
    const auto start = file.filename().string() + ".";
    std::vector<fs::path> abandoned;

    for (const auto& entry : fs::directory_iterator (file.parent_path(), ignored))
    {
        const auto name = entry.path().filename().string();
        int process = 0;

        if (! name.starts_with (start))
            continue;

        const auto [end, error] = std::from_chars (name.data() + start.size(), name.data() + name.size(), process);

        if (error == std::errc() && end == name.data() + name.size() && process > 0 && process <= largestProcess
            && ! isProcessRunning (process))
            abandoned.push_back (entry.path());
    }

    for (const auto& path : abandoned)
        fs::remove (path, ignored);
}

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

    if (file.empty())
        return {};

    removeAbandoned (file.parent_path());
    removeAbandonedCopies (file);

    if (! fs::exists (file, ignored))
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

    try
    {
        writeWholeFile (file, text);
    }
    catch (const InputError&)
    {
        throw InputError (file.string(), "the settings cannot be written");
    }

    written = std::move (text);
}
} // namespace antinode
