#include "Inputs.h"

#include <antinode_base/InputError.h>
#include <antinode_documents/DeviceFile.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_text/JsonText.h>

#include <filesystem>

namespace antinode
{
namespace
{
nlohmann::json loadAssigned (LibraryKind kind, const std::string& nameOrFile,
                             const std::vector<std::string>& assignments)
{
    auto document = loadDocument (kind, nameOrFile);
    const std::string prefix = kind == LibraryKind::device ? "device." : "focus.";

    for (const auto& assignment : assignments)
        if (assignment.starts_with (prefix))
            applyAssignment (document, std::string_view (assignment).substr (prefix.size()));

    return document;
}
} // namespace

nlohmann::json loadDeviceDocument (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return loadAssigned (LibraryKind::device, nameOrFile, assignments);
}

DeviceDescription loadDevice (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return readDevice (loadDeviceDocument (nameOrFile, assignments), documentSource (LibraryKind::device, nameOrFile));
}

FocusDescription loadFocus (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    auto focus = readFocus (loadAssigned (LibraryKind::focus, nameOrFile, assignments),
                            documentSource (LibraryKind::focus, nameOrFile));

    if (focus.name.empty())
        focus.name = std::filesystem::path (nameOrFile).stem().string();

    return focus;
}

void checkAssignments (const std::vector<std::string>& assignments)
{
    for (const auto& assignment : assignments)
        if (! assignment.starts_with ("device.") && ! assignment.starts_with ("focus."))
            throw InputError ("--set " + assignment,
                              "does not start with a document; allowed: focus.KEY=VALUE or device.KEY=VALUE, "
                              "for example focus.targets.0.x_mm=24");
}
} // namespace antinode
