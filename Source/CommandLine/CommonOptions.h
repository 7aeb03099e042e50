#pragma once

#include <antinode_focus/WideDesign.h>
#include <antinode_library/Library.h>
#include <antinode_render/RenderedFocus.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** The common options of design and render. */
struct CommonOptions
{
    std::string focus = "demonstrator";
    std::string device; ///< Empty: the one that the focus names, else `staple`.
    std::string folder = "antinode-out";
    std::optional<double> rate;                ///< Hz; none: 192000
    std::optional<std::string> reconstruction; ///< None: "band_limited"
    double repetitions = 10;                   ///< Per second, for the electrical power.
    std::string thresholdFile;                 ///< What skin feels; empty: the built-in table.
    std::vector<std::string> assignments, fingers;
    bool usesCache = true;
    bool isQuiet = false;

    Playback playback() const;
};

/** What a command without --device works on where its focus names no device. */
inline constexpr const char* usualDevice = "staple";

/** The device of all these focuses.
    @param given  the one that an option gives; empty: none
    @param usual  where none is named
    @throws InputError  where they name different ones [worker] */
std::string deviceFor (LibraryKind, const std::vector<std::string>& documents, const std::string& given,
                       const std::string& usual, const std::vector<std::string>& assignments);

/** The lines of a focus's electrical power, as wide as those of its scores. [any] */
void printPower (const ModalModel&, const FocusPower&);

/** Adds them to a sub-command, which adds its focus itself. The struct must live as long as the app. */
void addCommonOptions (CLI::App&, CommonOptions&);

/** The flag that bypasses the user's cache. The bool must live as long as the app. */
void addCacheFlag (CLI::App&, bool& usesCache);

/** The solved device that these options name. @throws InputError  for anything that cannot be read or solved. [worker]
 */
ModalModel modelFrom (const CommonOptions&);

/** The solved device and the focus that these options name. @throws InputError  for anything that cannot be read or
    solved. [worker] */
std::pair<ModalModel, FocusDescription> inputsFrom (const CommonOptions&);

/** The device that these options name, with modes to widePlay times its own. @throws as modelFrom. [worker] */
WideModel wideFrom (const CommonOptions&, const ModalModel& known);

/** A focus designed as these options say, with the plate that it is played on.
    @throws InputError  for anything that cannot be read, solved or met. [worker] */
WideDesign designFrom (const CommonOptions&);

/** The same of a focus and a device that are there already. [worker] */
WideDesign designFrom (const CommonOptions&, const WideModel&, const FocusDescription&);

/** How the device that these options name is widened. They outlive it. [any] */
WidenModel widenBy (const CommonOptions&);

/** A focus as these options have it: with their fingers, and their threshold of skin where it asks for one.
    @throws InputError  where one cannot be read. [worker] */
FocusDescription completed (const CommonOptions&, FocusDescription);
} // namespace antinode
