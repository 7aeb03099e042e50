#include "CommonOptions.h"

#include "FocusOnDevice.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_library/Inputs.h>
#include <antinode_library/SkinThresholds.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iterator>

namespace antinode
{
namespace
{
constexpr double usualRate = 192000; // Hz
constexpr const char* bandLimited = "band_limited";
constexpr const char* zeroOrderHold = "zero_order_hold";

[[noreturn]] void failFinger (const std::string& text)
{
    throw InputError ("--finger " + text,
                      "is not a finger; allowed: X,Y[,KIND[,FORCE]] in mm and N (0 to 100), for example 60,48,firm");
}

/** "X,Y", "X,Y,KIND" or "X,Y,KIND,FORCE", mm and N. */
Finger parseFinger (const std::string& text)
{
    std::array<double, 2> place {};
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (auto& value : place)
    {
        const auto [next, error] = std::from_chars (at, end, value);
        const auto isLast = &value == &place.back();

        if (error != std::errc() || (next == end ? ! isLast : *next != ','))
            failFinger (text);

        at = next == end ? end : next + 1;
    }

    const auto* const comma = std::find (at, end, ',');
    auto finger = builtInFinger (at == end ? "medium" : std::string (at, comma), place[0] / milli, place[1] / milli);

    if (comma == end)
        return finger;

    constexpr double largestForce = 100; // N, as in files
    double force = 0;

    if (const auto [next, error] = std::from_chars (comma + 1, end, force);
        error != std::errc() || next != end || ! (force >= 0 && force <= largestForce))
        failFinger (text);

    finger.pressingForce = force;
    return finger;
}

[[noreturn]] void failDevices (const std::string& focus, const std::string& device, const std::string& otherFocus,
                               const std::string& otherDevice)
{
    throw InputError (focus, "is for the device '" + device + "', and " + otherFocus + " for '" + otherDevice
                                 + "'; allowed: one device for all, or --device");
}

/** With the fingers of the options beside its own. */
FocusDescription withFingers (FocusDescription focus, const std::vector<std::string>& fingers)
{
    std::transform (fingers.begin(), fingers.end(), std::back_inserter (focus.fingers), parseFinger);
    return focus;
}
} // namespace

Playback CommonOptions::playback() const
{
    return { reconstruction.value_or (bandLimited) == bandLimited ? Reconstruction::bandLimited
                                                                  : Reconstruction::zeroOrderHold,
             rate.value_or (usualRate) };
}

std::string deviceFor (LibraryKind kind, const std::vector<std::string>& documents, const std::string& given,
                       const std::string& usual, const std::vector<std::string>& assignments)
{
    if (! given.empty())
        return given;

    std::string device, first;

    for (const auto& document : documents)
    {
        const auto named = namedDevice (kind, document, assignments);

        if (! named.empty() && ! device.empty() && named != device)
            failDevices (documentSource (kind, document), named, first, device);

        if (device.empty() && ! named.empty())
        {
            device = named;
            first = documentSource (kind, document);
        }
    }

    return device.empty() ? usual : device;
}

void addCommonOptions (CLI::App& command, CommonOptions& options)
{
    command.add_option ("--device", options.device,
                        "Device: an embedded name or a .json file (default: the one that the focus names, else "
                        "staple)");
    command.add_option ("--out", options.folder, "Output folder")->capture_default_str();
    command.add_option ("--rate", options.rate, "Sample rate, Hz (default: 192000)")->type_name ("FLOAT");
    command
        .add_option ("--reconstruction", options.reconstruction,
                     "Reconstruction of voltages from samples: by an audio interface (band_limited, the default) or a "
                     "generator that holds samples")
        ->check (CLI::IsMember ({ bandLimited, zeroOrderHold }));
    command
        .add_option ("--set", options.assignments, "Overrides a key, for example focus.targets.0.x_mm=24 (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("KEY=VALUE");
    command
        .add_option ("--finger", options.fingers,
                     "X,Y[,KIND[,FORCE]]: a finger on the surface, mm; light, medium (default) or firm; with a "
                     "pressing force in N it may "
                     "lift off (repeatable)")
        ->allow_extra_args (false)
        ->type_name ("X,Y[,KIND]");
    command.add_option ("--repeat-hz", options.repetitions, "Foci per second for which power and currents are told")
        ->check (CLI::Range (1e-6, 1e6))
        ->type_name ("FLOAT")
        ->capture_default_str();
    addCacheFlag (command, options.usesCache);
    command.add_flag ("--quiet", options.isQuiet, "Prints only errors");
}

void addCacheFlag (CLI::App& command, bool& usesCache)
{
    command.add_flag ("!--no-cache", usesCache, "Solves the device without reading or writing the cache");
}

void printPower (const ModalModel& model, const FocusPower& power)
{
    const std::array headings { "current", "power", "amplifier" };
    const auto sentences = powerInWords (model, power);

    for (std::size_t i = 0; i < sentences.size(); ++i)
        std::printf ("  %-14s %s\n", sentences.size() == 1 ? "power" : headings[i], sentences[i].c_str());
}

ModalModel modelFrom (const CommonOptions& options)
{
    checkAssignments (options.assignments);
    checkSampleRate (options.playback().sampleRate);
    return solveDevice (loadDevice (options.device, options.assignments), {}, options.usesCache);
}

std::pair<ModalModel, FocusDescription> inputsFrom (const CommonOptions& options)
{
    checkAssignments (options.assignments);
    const auto focus = loadFocus (options.focus, options.assignments);
    auto model = modelFrom (options);
    checkKindOfPlaces (model, focus);
    return { std::move (model), focus };
}

WideModel wideFrom (const CommonOptions& options, const ModalModel& known)
{
    return wideOf (loadDevice (options.device, options.assignments), known, options.playback(), options.usesCache);
}

WideDesign designFrom (const CommonOptions& options)
{
    const auto [model, focus] = inputsFrom (options);
    return designFrom (options, wideFrom (options, model), focus);
}

WideDesign designFrom (const CommonOptions& options, const WideModel& wide, const FocusDescription& focus)
{
    return designOn (loadDevice (options.device, options.assignments), wide, completed (options, focus),
                     options.playback(), options.usesCache);
}

WidenModel widenBy (const CommonOptions& options)
{
    return [&options] (const ModalModel& known, double frequency)
    { return solveWide (loadDevice (options.device, options.assignments), known, frequency, options.usesCache); };
}

FocusDescription completed (const CommonOptions& options, FocusDescription focus)
{
    auto complete = withFingers (std::move (focus), options.fingers);

    if (complete.felt && ! options.thresholdFile.empty())
        complete.felt->threshold = findSkinThreshold (options.thresholdFile);

    return complete;
}
} // namespace antinode
