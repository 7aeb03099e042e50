#include "Library.h"

#include "HapticContent.h"
#include "ModeCache.h"
#include "OutlineReader.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/System.h>
#include <antinode_base/WholeFile.h>
#include <antinode_model/RigidMotion.h>
#include <antinode_resources.h>
#include <antinode_structure/DeviceDescription.h>
#include <antinode_structure/StaticShare.h>
#include <antinode_text/JsonText.h>
#include <antinode_text/OutputFolder.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>
#include <variant>

namespace antinode
{
namespace
{
constexpr std::string_view extension = ".json";
constexpr std::array<std::string_view, 4> extensions { extension, ".ahap", ".hjif", ".xml" };

std::string folderName (LibraryKind kind)
{
    return kind == LibraryKind::device ? "Devices" : kind == LibraryKind::focus ? "Focuses" : "Waveforms";
}

std::string wordFor (LibraryKind kind)
{
    return kind == LibraryKind::device ? "device" : kind == LibraryKind::focus ? "focus" : "waveforms";
}

const EmbeddedFile* findFactory (LibraryKind kind, const std::string& name)
{
    const auto path = folderName (kind) + "/" + name + std::string (extension);
    const auto files = resources::files();
    const auto found = std::find_if (files.begin(), files.end(), [&] (const auto& file) { return file.name == path; });
    return found == files.end() ? nullptr : &*found;
}

bool isAllowedName (const std::string& name)
{
    const auto isAllowed = [] (unsigned char letter)
    { return std::isalnum (letter) != 0 || letter == ' ' || letter == '-' || letter == '_' || letter == '.'; };

    return ! name.empty() && name.size() <= 64 && name.front() != '.'
           && std::all_of (name.begin(), name.end(), isAllowed);
}

/** Ours in a folder for the files of all programs. */
std::optional<std::filesystem::path> oursIn (const std::optional<std::filesystem::path>& home)
{
    return home ? std::optional (*home / "antinode") : std::nullopt;
}

std::optional<std::filesystem::path> userFile (LibraryKind kind, const std::string& name)
{
    const auto folder = userLibraryFolder();

    if (! folder || ! isAllowedName (name))
        return std::nullopt;

    return *folder / folderName (kind) / (name + std::string (extension));
}

std::vector<std::string> userNames (LibraryKind kind)
{
    std::vector<std::string> names;
    const auto folder = userLibraryFolder();
    std::error_code ignored; // what cannot be read is not there

    if (folder)
        for (const auto& entry : std::filesystem::directory_iterator (*folder / folderName (kind), ignored))
            if (const auto name = entry.path().stem().string();
                entry.path().extension() == extension && isAllowedName (name) && findFactory (kind, name) == nullptr)
                names.push_back (name);

    std::sort (names.begin(), names.end());
    return names;
}

/** How a solver is asked for modes: up to a frequency, or as many as it gives. */
struct Reach
{
    std::optional<int> count;
    std::optional<double> frequency; ///< Hz
};

/** The same device with other modes asked for. None where its modes are given. */
std::optional<DeviceDescription> reaching (DeviceDescription device, const Reach& reach)
{
    const auto ask = [&] (auto& body)
    {
        if constexpr (requires { body.common; })
        {
            body.common.modeCount = reach.count;
            body.common.maximumFrequency = reach.frequency;
        }
    };
    std::visit (ask, device.body);
    return isComputed (device) ? std::optional (std::move (device)) : std::nullopt;
}

ModalModel solveWithCache (const DeviceDescription& device, std::optional<int> modeCount, bool usesCache,
                           SolvedShapes shapes)
{
    const auto folder = usesCache ? userCacheFolder() : std::nullopt;
    const auto cache = folder ? std::optional (ModeCache (*folder)) : std::nullopt;
    auto model = solveCached (device, modeCount, cache ? &*cache : nullptr, shapes);
    model.warnings.insert (model.warnings.begin(), device.warnings.begin(), device.warnings.end());
    return model;
}

/** A wide model of what one solution gives; none where it cannot be solved or gives no more modes. */
std::optional<WideModel> tryWide (const DeviceDescription& device, const ModalModel& known, bool usesCache)
{
    try
    {
        // Two solutions of a plate with an outline have points of their own: here they are those of the known modes.
        if (std::holds_alternative<OutlinedPlate> (device.body))
            return withModesBeyond (known, solveWithCache (device, static_cast<int> (known.modes()), usesCache,
                                                           SolvedShapes::onPointsOfFewer));

        return withModesBeyond (known, solveDevice (device, {}, usesCache));
    }
    catch (const InputError&)
    {
        return {};
    }
}

/** A document of the user's; drawings that a device names become a part of it, haptic content becomes waveforms. */
nlohmann::json readDocumentFile (LibraryKind kind, const std::filesystem::path& file)
{
    if (kind == LibraryKind::waveforms)
        return waveformsDocument (readWholeFile (file, { "a JSON file" }), file.string());

    auto document = readJsonFile (file);

    if (kind == LibraryKind::device)
        embedOutlineFiles (document, file.parent_path(), readDrawnOutline);

    return document;
}
} // namespace

bool isFileName (const std::string& text)
{
    return text.find ('/') != std::string::npos
           || std::any_of (extensions.begin(), extensions.end(), [&] (auto each) { return text.ends_with (each); });
}

std::optional<std::filesystem::path> userLibraryFolder()
{
    return oursIn (userDataHome());
}

std::optional<std::filesystem::path> userConfigFolder()
{
    return oursIn (userConfigHome());
}

std::vector<std::string> factoryNames (LibraryKind kind)
{
    std::vector<std::string> names;
    const auto folder = folderName (kind) + "/";

    for (const auto& file : resources::files())
        if (const std::string_view path (file.name); path.starts_with (folder))
            names.emplace_back (path.substr (folder.size(), path.size() - folder.size() - extension.size()));

    std::sort (names.begin(), names.end());
    return names;
}

std::vector<LibraryEntry> libraryEntries (LibraryKind kind)
{
    std::vector<LibraryEntry> entries;

    for (const auto& name : factoryNames (kind))
        entries.push_back ({ name, true });

    for (const auto& name : userNames (kind))
        entries.push_back ({ name, false });

    return entries;
}

std::string documentSource (LibraryKind kind, const std::string& nameOrFile)
{
    return isFileName (nameOrFile) ? nameOrFile : wordFor (kind) + " '" + nameOrFile + "'";
}

nlohmann::json loadDocument (LibraryKind kind, const std::string& nameOrFile)
{
    if (isFileName (nameOrFile))
        return readDocumentFile (kind, nameOrFile);

    if (const auto* const file = findFactory (kind, nameOrFile))
        return parseJson (file->text(), documentSource (kind, nameOrFile));

    std::error_code unknown;

    if (const auto file = userFile (kind, nameOrFile); file && std::filesystem::exists (*file, unknown))
        return readDocumentFile (kind, *file);

    std::string allowed;

    for (const auto& entry : libraryEntries (kind))
        allowed += (allowed.empty() ? "" : ", ") + entry.name;

    throw InputError (documentSource (kind, nameOrFile), "is neither an embedded nor a user " + wordFor (kind)
                                                             + "; allowed: " + allowed
                                                             + ", or a file name that ends in .json");
}

void saveDocument (LibraryKind kind, const std::string& name, const nlohmann::json& document)
{
    if (findFactory (kind, name) != nullptr)
        throw InputError ("name '" + name + "'", "is reserved for a factory preset; choose another name");

    const auto file = userFile (kind, name);

    if (! file)
        throw InputError ("name '" + name + "'",
                          "is not valid; allowed: 1 to 64 letters, digits, spaces, '-', '_' and '.', "
                          "not starting with '.'");

    writeWholeFile (*file, document.dump (2) + "\n");
}

void removeDocument (LibraryKind kind, const std::string& name)
{
    const auto file = userFile (kind, name);
    std::error_code failure;

    if (! file || ! std::filesystem::remove (*file, failure))
        throw InputError ("name '" + name + "'", "is not a user preset");
}

ModalModel solveDevice (const DeviceDescription& device, std::optional<int> modeCount, bool usesCache)
{
    return solveWithCache (device, modeCount, usesCache, SolvedShapes::modes);
}

WideModel solveWide (const DeviceDescription& device, const ModalModel& known, double frequency, bool usesCache)
{
    const auto wider = reaching (device, { {}, frequency });

    if (! wider)
        return { known, known.modes(),
                 "The device's file gives its modes: what spills over into others is not known." };

    if (auto wide = tryWide (*wider, known, usesCache))
        return *std::move (wide);

    const auto most = reaching (device, { maximumModes (device), {} });

    if (auto wide = tryWide (*most, known, usesCache))
    {
        wide->obstacle = "No more than " + std::to_string (wide->model.modes()) + " modes are solved, to "
                         + inWords (wide->highestFrequency()) + " Hz, where " + inWords (frequency)
                         + " Hz were wanted: what spills over beyond is not known.";
        return *std::move (wide);
    }

    return { known, known.modes(), "No more modes can be solved: what spills over into others is not known." };
}

ModalModel solveDeviceWithStaticShare (const DeviceDescription& device, std::optional<int> modeCount, bool usesCache)
{
    return withRigidMotion (solveWithCache (device, modeCount, usesCache, SolvedShapes::withStaticShare));
}

Setup setUp (const DeviceDescription& device, Playback playback, bool usesCache)
{
    auto known = solveDevice (device, {}, usesCache);
    auto wide = widened (device, known, playback.sampleRate, usesCache);
    const WidenModel widen = [device, usesCache] (const ModalModel& model, double frequency)
    { return solveWide (device, model, frequency, usesCache); };
    return { std::move (known), std::move (wide), widen, playback };
}

WideModel widened (const DeviceDescription& device, const ModalModel& known, double sampleRate, bool usesCache)
{
    return solveWide (device, known, frequencyBeyond (known, sampleRate), usesCache);
}

namespace
{
/** Half as many modes again as the design knows, where the device is solved; a measured one has no more. */
std::optional<int> judgedModes (const DeviceDescription& description, const ModalModel& known)
{
    if (! isComputed (description))
        return {};

    const auto modes = known.modes() - (hasStaticShare (description) ? known.actuators() : 0);
    return std::min (maximumModes (description), static_cast<int> (3 * modes / 2));
}
} // namespace

TrackModels trackModels (const DeviceDescription& device, bool usesCache)
{
    auto known = solveDeviceWithStaticShare (device, {}, usesCache);
    auto judge = solveDeviceWithStaticShare (device, judgedModes (device, known), usesCache);
    return { std::move (known), std::move (judge) };
}
} // namespace antinode
