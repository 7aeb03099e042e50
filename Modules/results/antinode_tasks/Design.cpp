#include "Design.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_documents/Inputs.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_render/RenderedFocus.h>
#include <antinode_text/JsonText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace antinode
{
namespace
{
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

std::string wordOf (Reconstruction reconstruction)
{
    return reconstruction == Reconstruction::bandLimited ? bandLimited : zeroOrderHold;
}

/** Samples do what they were designed for in one way only. */
void requirePlayback (Playback asked, const std::string& file, Playback designed)
{
    if (asked.sampleRate != designed.sampleRate || asked.reconstruction != designed.reconstruction)
        throw InputError (file, "has samples of " + inWords (designed.sampleRate) + " Hz, "
                                    + wordOf (designed.reconstruction) + ", and " + inWords (asked.sampleRate) + " Hz, "
                                    + wordOf (asked.reconstruction)
                                    + " are asked for; allowed: as it was designed, or a new design");
}
} // namespace

std::vector<Field> fields (FocusRequest& request)
{
    return {
        focusField (request.focus),
        deviceOfFocusField (request.device),
        sampleRateField (request.sampleRate),
        Field ("--reconstruction", &request.reconstruction,
               "Reconstruction of voltages from samples: by an audio interface, or a generator that holds samples")
            .oneOf ({ bandLimited, zeroOrderHold }),
        Field ("--repeat-hz", &request.repetitions, "Foci per second for power and currents")
            .as ("repeat_Hz")
            .within (1e-6, 1e6),
        Field ("--threshold", &request.thresholdFile, "Threshold of skin: CSV of Hz and um").by ("the built-in table"),
        Field ("--finger",
               TextRows { [&request] (const std::string& text) { request.fingers.push_back (parseFinger (text)); } },
               "X,Y[,KIND[,FORCE]]: a finger on the surface, mm; light, medium (default) or firm; with a pressing "
               "force in "
               "N it may lift off (repeatable)")
            .as ({})
            .written ("X,Y[,KIND]"),
        cacheField (request.usesCache),
    };
}

Playback playbackOf (const FocusRequest& request)
{
    return { request.reconstruction == bandLimited ? Reconstruction::bandLimited : Reconstruction::zeroOrderHold,
             request.sampleRate };
}

FocusDescription focusOf (const FocusRequest& request)
{
    auto focus = request.focus;
    focus.fingers.insert (focus.fingers.end(), request.fingers.begin(), request.fingers.end());

    if (! request.thresholdFile.empty())
        focus.threshold = findSkinThreshold (request.thresholdFile.string());

    return focus;
}

DesignedFocus design (const FocusRequest& request, const ShowProgress&)
{
    const auto setup = setUp (request.device, playbackOf (request), request.usesCache);
    return { designOn (setup, focusOf (request)), setup.playback, request.repetitions, request.thresholdFile };
}

DesignedFocus writtenDesign (FocusRequest request, const LeftOpen& opens, const std::filesystem::path& path,
                             const std::string& device, const std::vector<std::string>& assignments)
{
    const auto file = path.string();
    const auto document = readJsonFile (file);
    const auto origin = readDesignOrigin (document, file);

    for (const auto& assignment : assignments)
        if (assignment.starts_with ("focus."))
            throw InputError ("--set " + assignment, "changes a focus that is designed already; allowed with --design: "
                                                     "device.KEY=VALUE, or a new design");

    checkAssignments (assignments);
    request.device = loadDevice (device.empty() ? origin.device : device, assignments);

    if (opens.sampleRate)
        request.sampleRate = origin.playback.sampleRate;

    if (opens.reconstruction)
        request.reconstruction = wordOf (origin.playback.reconstruction);

    const auto playback = playbackOf (request);

    if (origin.isSampled)
        requirePlayback (playback, file, origin.playback);

    auto wide = playedUnderFingers (setUp (request.device, playback, request.usesCache).wide, origin.focus.fingers);
    auto design = readDesign (document, file, designedModel (wide));
    return { { std::move (wide), std::move (design) }, playback, request.repetitions, request.thresholdFile };
}

ModalModel designedModel (const WideModel& wide)
{
    return wide.designed ? *wide.designed : firstModes (wide.model, wide.known);
}

ModalModel ownModel (const DesignedFocus& designed)
{
    return firstModes (designed.made.wide.model, designed.made.wide.known);
}

FocusPower designedPower (const DesignedFocus& designed)
{
    RenderOptions render;
    render.playback = designed.playback;
    render.repetitions = designed.repetitions;

    try
    {
        return renderFocus (designed.made.wide, designed.made.design, render).power.value();
    }
    catch (const InputError& error)
    {
        return { error.what(), {}, {} };
    }
}

std::string designFileText (const DesignedFocus& designed, const FocusPower& power)
{
    auto document = designToJson (designed.made.design, designedModel (designed.made.wide));
    document["power"] = powerToJson (ownModel (designed), power);
    return document.dump (2) + "\n";
}
} // namespace antinode
