#include "Inputs.h"

#include "SkinThresholds.h"

#include "DeviceFile.h"
#include "FocusFile.h"
#include "HapticContent.h"
#include "SharedFields.h"
#include "WaveformsFile.h"
#include <antinode_base/InputError.h>
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
    const std::string prefix = kind == LibraryKind::device  ? "device."
                               : kind == LibraryKind::focus ? "focus."
                                                            : "waveforms.";

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
    return focusFromDocument (loadAssigned (LibraryKind::focus, nameOrFile, assignments),
                              documentSource (LibraryKind::focus, nameOrFile),
                              std::filesystem::path (nameOrFile).stem().string());
}

FocusDescription focusFromDocument (const nlohmann::json& document, const std::string& source,
                                    const std::string& fallbackName)
{
    auto focus = readFocus (document, source);

    if (focus.name.empty())
        focus.name = fallbackName;

    return focus;
}

WaveformsDescription loadWaveforms (const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    return waveformsFromDocument (loadAssigned (LibraryKind::waveforms, nameOrFile, assignments),
                                  documentSource (LibraryKind::waveforms, nameOrFile), nameOrFile);
}

WaveformsDescription waveformsFromDocument (const nlohmann::json& document, const std::string& source,
                                            const std::string& file)
{
    const std::filesystem::path path (file);
    auto waveforms = readWaveforms (withHapticFiles (document, path.parent_path()), source, path.parent_path());

    if (waveforms.name.empty())
        waveforms.name = path.stem().string();

    return waveforms;
}

std::string namedDevice (LibraryKind kind, const std::string& nameOrFile, const std::vector<std::string>& assignments)
{
    const auto document = loadAssigned (kind, nameOrFile, assignments);
    const JsonValue value (document, documentSource (kind, nameOrFile));
    const auto device = value.isObject() ? readNamedDevice (value.find ("device")) : std::string();
    const auto folder = std::filesystem::path (nameOrFile).parent_path();
    return isFileName (device) ? (folder / device).string() : device;
}

void checkAssignments (const std::vector<std::string>& assignments)
{
    for (const auto& assignment : assignments)
        if (! assignment.starts_with ("device.") && ! assignment.starts_with ("focus.")
            && ! assignment.starts_with ("waveforms."))
            throw InputError (
                "--set " + assignment,
                "does not start with a document; allowed: focus.KEY=VALUE, device.KEY=VALUE or waveforms.KEY=VALUE, "
                "for example focus.targets.0.x_mm=24");
}
} // namespace antinode
