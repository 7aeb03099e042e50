#include "DeviceChecks.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/Inputs.h>
#include <antinode_model/Surface.h>
#include <antinode_outline/Drawing.h>

#include <utility>
#include <variant>

namespace antinode
{
namespace
{
void checkKindOfPlace (const ModalModel& model, double y, const std::string& where)
{
    if (y != 0 && model.surface.kind == SurfaceKind::line)
        throw InputError (where, "is " + inWords (y * milli) + " mm, but the surface of '" + model.name
                                     + "' is a line; allowed: 0, or a plate as --device");
}
} // namespace

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

void checkIdleCeramics (const std::vector<int>& idle, const ModalModel& model)
{
    for (const auto ceramic : idle)
        if (ceramic < 1 || ceramic > model.actuators())
            throw InputError ("--idle-ceramic", "is " + std::to_string (ceramic) + "; allowed: 1 to "
                                                    + std::to_string (model.actuators()));
}

WideDesign designOn (const Setup& setup, const FocusDescription& focus)
{
    checkKindOfPlaces (setup.known, focus);
    return designWide (setup.wide, focus, setup.playback, setup.widen);
}

Field sampleRateField (double& rate)
{
    return Field ("--rate", &rate, "Sample rate, Hz").as ("sample_rate_Hz").within (8000, 2e6);
}

Field focusField (FocusDescription& focus)
{
    return Field ("focus", &focus, "Focus: an embedded name or a .json file").usually ("demonstrator").positional();
}

Field deviceOfFocusField (DeviceDescription& device)
{
    return Field ("--device", &device, "Device: an embedded name or a .json file")
        .usually ("staple")
        .by ("the one that the focus names, else staple")
        .positional();
}

Field outlineField (std::filesystem::path& outline)
{
    return Field ("--outline", &outline,
                  "Outline of the surface: a plate by embedded name or .json file, or a drawing (.svg, .dxf)")
        .written ("FILE");
}

bool isDrawingFile (const std::filesystem::path& outline)
{
    const auto extension = outline.extension();
    return extension == ".svg" || extension == ".dxf";
}

std::optional<SurfaceBoundary> boundaryFrom (const std::filesystem::path& outline)
{
    if (outline.empty())
        return {};

    if (isDrawingFile (outline))
        return SurfaceBoundary { readOutlineFile (outline.string(), {}), {} };

    const auto device = loadDevice (outline.string(), {});
    const auto surface = deviceExtent (device);

    if (surface.kind == SurfaceKind::line || (! surface.boundary && std::holds_alternative<ModalModel> (device.body)))
        throw InputError ("--outline " + outline.string(),
                          "is a device without an outline of its surface; allowed: a plate, or a drawing");

    return boundaryOf (surface);
}
} // namespace antinode
