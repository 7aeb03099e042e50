#include "Inputs.h"

#include <antinode_resources.h>

#include <antinode_files/DeviceFile.h>
#include <antinode_files/FocusFile.h>
#include <antinode_files/JsonText.h>
#include <antinode_files/ModeCache.h>
#include <antinode_model/InputError.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr std::string_view extension = ".json";

bool isFileName (const std::string& text)
{
    return text.ends_with (extension) || text.find ('/') != std::string::npos;
}

std::string kindOf (const std::string& folder)
{
    return folder == "Devices" ? "device" : "focus";
}

std::string sourceOf (const std::string& folder, const std::string& nameOrFile)
{
    return isFileName (nameOrFile) ? nameOrFile : kindOf (folder) + " '" + nameOrFile + "'";
}

nlohmann::json loadAssigned (const std::string& folder, const std::string& nameOrFile,
                             const std::vector<std::string>& assignments)
{
    auto document = loadDocument (folder, nameOrFile);
    const auto prefix = kindOf (folder) + ".";

    for (const auto& assignment : assignments)
        if (assignment.starts_with (prefix))
            applyAssignment (document, std::string_view (assignment).substr (prefix.size()));

    return document;
}
} // namespace

std::vector<std::string> embeddedNames (const std::string& folder)
{
    std::vector<std::string> names;

    for (const auto& file : resources::files())
    {
        const std::string_view path (file.name);

        if (path.starts_with (folder + "/"))
            names.emplace_back (path.substr (folder.size() + 1, path.size() - folder.size() - 1 - extension.size()));
    }

    std::sort (names.begin(), names.end());
    return names;
}

nlohmann::json loadDocument (const std::string& folder, const std::string& nameOrFile)
{
    if (isFileName (nameOrFile))
        return readJsonFile (nameOrFile);

    const auto path = folder + "/" + nameOrFile + std::string (extension);

    for (const auto& file : resources::files())
        if (file.name == path)
            return parseJson (file.text(), sourceOf (folder, nameOrFile));

    std::string allowed;

    for (const auto& name : embeddedNames (folder))
        allowed += (allowed.empty() ? "" : ", ") + name;

    throw InputError (sourceOf (folder, nameOrFile), "is not an embedded " + kindOf (folder) + "; allowed are "
                                                         + allowed + ", or a file whose name ends in .json");
}

nlohmann::json loadDeviceDocument (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return loadAssigned ("Devices", nameOrFile, assignments);
}

DeviceDescription loadDevice (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return readDevice (loadDeviceDocument (nameOrFile, assignments), sourceOf ("Devices", nameOrFile));
}

FocusDescription loadFocus (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return readFocus (loadAssigned ("Focuses", nameOrFile, assignments), sourceOf ("Focuses", nameOrFile));
}

ModalModel solveDevice (const DeviceDescription& device, std::optional<int> modeCount, bool usesCache)
{
    const auto folder = usesCache ? userCacheFolder() : std::nullopt;
    const auto cache = folder ? std::optional (ModeCache (*folder)) : std::nullopt;
    return solveCached (device, modeCount, cache ? &*cache : nullptr);
}

void checkAssignments (const std::vector<std::string>& assignments)
{
    for (const auto& assignment : assignments)
        if (! assignment.starts_with ("device.") && ! assignment.starts_with ("focus."))
            throw InputError ("--set " + assignment,
                              "names no document: allowed is focus.KEY=VALUE or device.KEY=VALUE, "
                              "for example focus.targets.0.x_mm=24");
}
} // namespace antinode
