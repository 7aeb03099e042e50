#include "OutputFolder.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_base/Watch.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <random>

namespace antinode
{
namespace
{
namespace fs = std::filesystem;

constexpr std::string_view temporaryPrefix = ".antinode-";
constexpr std::string_view lastFile = "summary.json";
constexpr std::size_t bytesAtOnce = 1 << 20; // between two looks at the watch

[[noreturn]] void fail (const fs::path& path, const std::string& wrong)
{
    throw InputError (printable (path.string(), 300), wrong);
}

/** The process that made a temporary folder of this name, or 0 where the name is another's. */
int findOwner (std::string_view name)
{
    int owner = 0;

    if (name.substr (0, temporaryPrefix.size()) != temporaryPrefix)
        return 0;

    const auto* const end = name.data() + name.size();
    const auto parsed = std::from_chars (name.data() + temporaryPrefix.size(), end, owner);
    return parsed.ec == std::errc {} && parsed.ptr != end && *parsed.ptr == '-' && owner > 0 ? owner : 0;
}

fs::path makeTemporaryFolder (const fs::path& target)
{
    std::random_device random;
    auto path =
        target / (std::string (temporaryPrefix) + std::to_string (ownProcess()) + '-' + std::to_string (random()));
    std::error_code error;

    if (! fs::create_directory (path, error))
        fail (target, "cannot be written: " + (error ? error.message() : "a temporary folder of the same name exists"));

    return path;
}
} // namespace

OutputFolder::OutputFolder (const std::filesystem::path& targetFolder)
{
    std::error_code error;
    target = fs::absolute (targetFolder, error);

    if (targetFolder.empty() || error)
        fail (targetFolder, "is not a folder name");

    if (fs::exists (target, error) && ! fs::is_directory (target, error))
        fail (targetFolder, "is a file; allowed: a folder");

    madeTarget = fs::create_directories (target, error);

    if (std::error_code unknown; ! fs::is_directory (target, unknown))
        fail (targetFolder, "cannot be created: " + error.message());

    removeAbandoned (target);
    temporary = makeTemporaryFolder (target);
}

OutputFolder::~OutputFolder()
{
    std::error_code ignored;
    fs::remove_all (temporary, ignored);

    if (madeTarget)
        fs::remove (target, ignored); // Only where nothing is in it.
}

std::filesystem::path OutputFolder::pathFor (const std::string& fileName)
{
    if (fileName.empty() || fileName.front() == '.'
        || fileName.find_first_of (std::string_view ("/\0", 2)) != std::string::npos)
        fail (target, inQuotes (fileName) + " is not a plain file name");

    if (std::find (fileNames.begin(), fileNames.end(), fileName) == fileNames.end())
        fileNames.push_back (fileName);

    return temporary / fileName;
}

void OutputFolder::write (const std::string& fileName, std::string_view content)
{
    const auto path = pathFor (fileName);
    errno = 0;
    std::ofstream file (path, std::ios::binary);

    for (std::size_t done = 0; done < content.size(); done += bytesAtOnce)
    {
        checkWatch();
        const auto part = content.substr (done, bytesAtOnce);
        file.write (part.data(), static_cast<std::streamsize> (part.size()));
    }

    file.close();

    if (! file)
        fail (target / fileName, std::string ("cannot be written: ") + std::strerror (errno));
}

void OutputFolder::commit()
{
    // Who sees summary.json may rely on all the others.
    std::stable_partition (fileNames.begin(), fileNames.end(), [] (const auto& name) { return name != lastFile; });
    std::error_code error;

    for (const auto& name : fileNames)
    {
        if (! fs::exists (temporary / name, error))
            fail (target / name, "was not written");

        if (fs::is_directory (target / name, error))
            fail (target / name, "is a folder; a file of this name cannot be written");
    }

    for (const auto& name : fileNames)
        if (fs::rename (temporary / name, target / name, error); error)
            fail (target / name, "cannot be written: " + error.message());

    fileNames.clear();
    fs::remove_all (temporary, error);
}

void removeAbandoned (const std::filesystem::path& target)
{
    std::error_code ignored;
    std::vector<fs::path> stale;

    for (const auto& entry : fs::directory_iterator (target, ignored))
        if (const auto owner = findOwner (entry.path().filename().string()); owner > 0 && ! isProcessRunning (owner))
            if (fs::is_directory (entry.symlink_status (ignored)))
                stale.push_back (entry.path());

    for (const auto& path : stale)
        fs::remove_all (path, ignored);
}

void writeWholeFile (const std::filesystem::path& path, std::string_view content)
{
    std::error_code error;
    const auto exists = fs::exists (path, error);

    if (! path.has_filename())
        fail (path, "is not a file name");

    // A rename would put a file in the place of /dev/null.
    if (exists && ! fs::is_regular_file (path, error))
        fail (path, fs::is_directory (path, error) ? "is a folder; allowed: a file"
                                                   : "is a device or pipe; allowed: a plain file");

    const auto target = exists ? fs::canonical (path, error) : path;
    OutputFolder folder (target.has_parent_path() ? target.parent_path() : fs::path ("."));
    folder.write (target.filename().string(), content);
    folder.commit();
}
} // namespace antinode
