#include "FocusOnDevice.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DesignFile.h>
#include <antinode_library/Library.h>

#include <nlohmann/json.hpp>

namespace antinode
{
namespace
{
constexpr double lowestRate = 8000, highestRate = 2e6; // Hz

void checkKindOfPlace (const ModalModel& model, double y, const std::string& where)
{
    if (y != 0 && model.surface.kind == SurfaceKind::line)
        throw InputError (where, "is " + inWords (y * milli) + " mm, but the surface of '" + model.name
                                     + "' is a line; allowed: 0, or a plate as --device");
}
} // namespace

void checkSampleRate (double rate)
{
    if (! (rate >= lowestRate && rate <= highestRate))
        throw InputError ("--rate", "is " + numberText (rate) + " Hz; allowed: 8000 to 2000000 Hz");
}

void checkKindOfPlaces (const ModalModel& model, const FocusDescription& focus)
{
    for (std::size_t i = 0; i < focus.targets.size(); ++i)
        checkKindOfPlace (model, focus.targets[i].y, "focus: target " + std::to_string (i + 1) + " y");

    for (std::size_t i = 0; i < focus.probes.size(); ++i)
        checkKindOfPlace (model, focus.probes[i].second, "focus: probe " + std::to_string (i + 1) + " y");

    for (std::size_t i = 0; i < focus.fingers.size(); ++i)
        checkKindOfPlace (model, focus.fingers[i].y, "focus: finger " + std::to_string (i + 1) + " y");
}

void checkKindOfPlaces (const ModalModel& model, const Eigen::MatrixX2d& places, const std::string& what)
{
    for (Eigen::Index p = 0; p < places.rows(); ++p)
        checkKindOfPlace (model, places (p, 1), what + " " + std::to_string (p + 1) + " y");
}

WideModel wideOf (const DeviceDescription& device, const ModalModel& known, Playback playback, bool usesCache)
{
    return solveWide (device, known, frequencyBeyond (known, playback.sampleRate), usesCache);
}

WideDesign designOn (const DeviceDescription& device, const WideModel& wide, const FocusDescription& focus,
                     Playback playback, bool usesCache)
{
    return designWide (wide, focus, playback,
                       [&] (const ModalModel& known, double frequency)
                       { return solveWide (device, known, frequency, usesCache); });
}

FocusPower designedPower (const WideDesign& made, Playback playback, double repetitions)
{
    RenderOptions render;
    render.playback = playback;
    render.repetitions = repetitions;

    try
    {
        return renderFocus (made.wide, made.design, render).power.value();
    }
    catch (const InputError& error)
    {
        return { error.what(), {}, {} };
    }
}

ModalModel designedModel (const WideModel& wide)
{
    return wide.designed ? *wide.designed : firstModes (wide.model, wide.known);
}

nlohmann::ordered_json designDocument (const WideDesign& made, const FocusPower& power)
{
    auto document = designToJson (made.design, designedModel (made.wide));
    document["power"] = powerToJson (firstModes (made.wide.model, made.wide.known), power);
    return document;
}
} // namespace antinode
