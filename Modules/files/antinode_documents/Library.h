#pragma once

#include <antinode_focus/SpillOver.h>
#include <antinode_model/ModalModel.h>
#include <antinode_model/VoltageProgram.h>
#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
enum class LibraryKind
{
    device,
    focus,
    waveforms
};

/** A device, a focus or waveforms that can be chosen by name. */
struct LibraryEntry
{
    std::string name;
    bool isFactory = true; ///< False: made by the user.
};

/** The folder of user presets: antinode in userDataHome(), where there is one. [any] */
std::optional<std::filesystem::path> userLibraryFolder();

/** The folder of user settings: antinode in userConfigHome(), where there is one. [any] */
std::optional<std::filesystem::path> userConfigFolder();

/** Factory presets by name, then user presets by name. A user preset with a factory name is left out. [worker] */
std::vector<LibraryEntry> libraryEntries (LibraryKind);

/** The names of the factory's, sorted. [any] */
std::vector<std::string> factoryNames (LibraryKind);

/** Whether a document is named by its file: what has a '/' or ends in ".json", ".ahap", ".hjif" or ".xml". [any] */
bool isFileName (const std::string&);

/** The JSON of a name, the factory's first, or of a file.
    @throws InputError  when there is no such name (with those there are) or the file cannot be read
    [worker] */
nlohmann::json loadDocument (LibraryKind, const std::string& nameOrFile);

/** How errors name the document: "device 'beam'", or the file. [any] */
std::string documentSource (LibraryKind, const std::string& nameOrFile);

/** Keeps a document as the user's own; one of that name is replaced. The file appears only when it is complete.
    @param name  1 to 64 letters, digits, blanks, '-', '_' and '.', no '.' first, not a factory name
    @throws InputError  when the name is not allowed or the file cannot be written
    [worker] */
void saveDocument (LibraryKind, const std::string& name, const nlohmann::json&);

/** Removes a user preset. @throws InputError  if there is none of that name [worker] */
void removeDocument (LibraryKind, const std::string& name);

/** The modal model of a device, with modes from the user's cache where they are there.
    @param usesCache  false: solved in any case, and not kept
    @throws InputError  as solveStructure. [worker] */
ModalModel solveDevice (const DeviceDescription&, std::optional<int> modeCount, bool usesCache);

/** A solved device with the modes beyond its own, up to a frequency or as many as can be solved, from the user's cache
    where they are there. Where there are none, the model alone and why. [worker]
    @param known      as solveDevice gave it
    @param frequency  Hz */
WideModel solveWide (const DeviceDescription&, const ModalModel& known, double frequency, bool usesCache);

/** The device as who touches it finds it: as solveDevice, before the modes the motions as a rigid body where it is
   free, behind them the static share of all modes beyond, one more shape per ceramic, where it is a plate.
    @throws InputError  as solveWithStaticShare. [worker] Docs/Theory.md, section 1.8. */
ModalModel solveDeviceWithStaticShare (const DeviceDescription&, std::optional<int> modeCount, bool usesCache);

/** A device as foci are played on it, solved once. */
struct Setup
{
    ModalModel known; ///< The device's own modes.
    WideModel wide;   ///< With modes to widePlay times its own.
    WidenModel widen; ///< How more are found.
    Playback playback;
};

/** A device solved with the modes beyond its own that voltages of a sample rate excite.
    @throws InputError  for anything that cannot be solved [worker] Docs/Theory.md, section 5.2. */
Setup setUp (const DeviceDescription&, Playback, bool usesCache);

/** The same modes of a device whose own are known. @throws InputError  as setUp [worker] */
WideModel widened (const DeviceDescription&, const ModalModel& known, double sampleRate, bool usesCache);

/** A device as tracks are designed for it and as it judges them: with half as many modes again, where it is solved. */
struct TrackModels
{
    ModalModel known, judge;
};

/** @param usesCache  of solved devices @throws InputError  where the device cannot be solved [worker] */
TrackModels trackModels (const DeviceDescription&, bool usesCache);
} // namespace antinode
