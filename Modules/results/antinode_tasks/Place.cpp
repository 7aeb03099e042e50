#include "Place.h"

#include "PlacementOutcomes.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DeviceFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace antinode
{
namespace
{
double rounded (double metres)
{
    return std::round (metres * milli * 1e6) / 1e6;
}

nlohmann::json ceramicJson (nlohmann::json like, const CeramicDescription& ceramic, bool isPlate)
{
    like["name"] = ceramic.name;

    if (like.contains ("centre_mm"))
    {
        like["centre_mm"] = { rounded (ceramic.centre().x()), rounded (ceramic.centre().y()) };
        return like;
    }

    like["x_mm"] = rounded (isPlate ? ceramic.x : ceramic.x + ceramic.sizeX / 2);

    if (isPlate)
        like["y_mm"] = rounded (ceramic.y);

    return like;
}

/** The ceramic that is placed, as a document: the first of the device, or a default one, of the size that is wanted. */
nlohmann::json ceramicLike (const PlaceRequest& request, const nlohmann::json& document)
{
    const auto isPlate = deviceExtent (request.device).kind == SurfaceKind::plate;
    const auto* const lengthKey = isPlate ? "size_x_mm" : "length_mm";
    const auto* const widthKey = isPlate ? "size_y_mm" : "width_mm";
    const auto list = document.value ("ceramics", nlohmann::json::array());
    auto ceramic = list.is_array() && ! list.empty() ? list.front()
                                                     : nlohmann::json { { "x_mm", 0 },
                                                                        { "thickness_mm", 0.5 },
                                                                        { "material", "NCE51" },
                                                                        { "wiring", "parallel" },
                                                                        { "mounting", "both_sides" },
                                                                        { lengthKey, 10 },
                                                                        { widthKey, 10 } };

    if (ceramic.contains ("centre_mm"))
        ceramic["centre_mm"] = { 0, 0 };
    else
    {
        ceramic["x_mm"] = 0;

        if (isPlate)
            ceramic["y_mm"] = 0;
    }

    if (request.size && ceramic.contains ("diameter_mm"))
        ceramic["diameter_mm"] = rounded (request.size->first);
    else if (request.size)
        std::tie (ceramic[lengthKey], ceramic[widthKey]) =
            std::pair (rounded (request.size->first), rounded (request.size->second));

    return ceramic;
}

/** The ceramic of a document. @throws InputError  as readDevice, and on a device whose modes are given */
CeramicDescription describedCeramic (nlohmann::json document, const nlohmann::json& ceramic)
{
    if (document.contains ("base") || document.value ("kind", "") == "modal")
        throw InputError ("device",
                          (document.contains ("base") ? "has measured modes; allowed: " : "is of kind modal; allowed: ")
                              + std::string (computedKinds));

    document["ceramics"] = nlohmann::json::array ({ ceramic });
    const auto described = readDevice (document, "--size-mm");
    return std::visit (
        [] (const auto& body)
        {
            if constexpr (requires { body.common; })
                return body.common.ceramics.front();
            else
                return CeramicDescription {};
        },
        described.body);
}

PlacingOptions placingOptions (const PlaceRequest& request, const CeramicDescription& ceramic)
{
    PlacingOptions placing;
    placing.count = request.count;
    placing.grid.modes = request.modes;
    placing.grid.step = request.step.value_or (std::min (ceramic.sizeX, ceramic.sizeY) / 2);
    placing.grid.freeEdgeMargin = request.freeEdge;
    placing.isResolved = ! request.isFrozen;
    placing.keepOut = request.keepOut;

    if (request.edgeDistance)
        placing.grid.edgeDistance = *request.edgeDistance;

    if (request.duration)
        placing.duration = *request.duration;

    if (request.waveforms)
        placing.costOf = waveformsCost (request);
    else if (! request.focuses.empty())
        placing.costOf = peakVoltageCost (request.device, request.focuses);

    return placing;
}

std::pair<double, double> sizeOf (const std::vector<double>& millimetres)
{
    if (! (millimetres.front() > 0 && millimetres.back() > 0))
        throw InputError ("--size-mm", "is not a size; allowed: L or LxW in mm, for example 20 or 20x10");

    return { millimetres.front() / milli, millimetres.back() / milli };
}

KeepOut keepOutOf (const std::vector<double>& corners)
{
    if (! (corners[0] < corners[2] && corners[1] < corners[3]))
        throw InputError ("--keep-out-mm", "is empty; allowed: X0 below X1 and Y0 below Y1");

    return { corners[0] / milli, corners[1] / milli, corners[2] / milli, corners[3] / milli };
}
} // namespace

std::vector<Field> fields (PlaceRequest& request)
{
    constexpr double millimetres = 1000, milliseconds = 1000;
    auto* const r = &request;
    std::vector<Field> all {
        Field ("device", &r->device, "Device: an embedded name or a .json file")
            .usually ("aluminium-200x120")
            .positional(),
        Field ("--count", &r->count, "Number of ceramics").within (1, 64),
        Field ("--size-mm",
               NumberRows { "L or LxW in mm, for example 20 or 20x10", 1, 2, false,
                            [r] (const auto& numbers) { r->size = sizeOf (numbers); } },
               "Size L or LxW of a ceramic, mm")
            .written ("LxW", 'x')
            .by ("that of the device's first ceramic, or 10"),
        Field ("--step-mm", &r->step, "Spacing of positions, mm").in (millimetres).by ("half a ceramic"),
        Field ("--rim-mm", &r->edgeDistance, "On a plate: largest distance of ceramics from an edge, mm")
            .in (millimetres)
            .within (0, 1e12)
            .by ("any"),
        Field ("--free-edge-mm", &r->freeEdge, "Least distance of ceramics from free edges, mm")
            .in (millimetres)
            .within (0, 1000),
        Field ("--focus", &r->focuses,
               "Places for the voltage that this focus needs, an embedded name or a .json file (repeatable)")
            .as ("focuses"),
        Field ("--waveforms", OptionalWaveforms { &r->waveforms },
               "Places for what these waveforms need: an embedded name, a .json file or haptic content")
            .without ("--focus"),
        Field ("--least", &r->least, "What the waveforms are to need least of")
            .oneOf ({ "volts", "energy" })
            .with ("--waveforms"),
    };
    for (auto& field : fields (r->at))
        all.push_back (field.with ("--waveforms"));

    append (all,
            {
                Field ("--keep-out-mm",
                       NumberRows { "X0,Y0,X1,Y1 in mm", 4, 4, true,
                                    [r] (const auto& numbers) { r->keepOut.push_back (keepOutOf (numbers)); } },
                       "Rectangle without ceramics, mm (repeatable)")
                    .written ("X0,Y0,X1,Y1", ','),
                Field ("--modes", &r->modes, "Number of the lowest modes to excite").within (1, 200),
                Field ("--focus-time-ms", &r->duration, "Time available to excite the modes, ms")
                    .in (milliseconds)
                    .within (0.1, 60000)
                    .by ("25"),
                Field ("--frozen", &r->isFrozen, "Does not solve the device again with the placed ceramics"),
            });
    return all;
}

PlacedCeramics placed (const PlaceRequest& request, const PlacementNews& better, const ShowProgress& show)
{
    const auto document = nlohmann::json::parse (request.device.document);
    const auto ceramic = describedCeramic (document, ceramicLike (request, document));
    auto placing = placingOptions (request, ceramic);
    placing.better = better;
    return placeCeramics (request.device, ceramic, placing,
                          [&] (double share)
                          {
                              if (show)
                                  show ("Placing ceramics", share);
                          });
}

nlohmann::json placedDevice (const PlaceRequest& request, const std::vector<CeramicDescription>& ceramics)
{
    auto device = nlohmann::json::parse (request.device.document);
    const auto like = ceramicLike (request, device);
    const auto isPlate = device.value ("kind", "") == "plate";
    device["name"] = request.device.name + ", " + std::to_string (ceramics.size()) + " ceramics placed";
    device["ceramics"] = nlohmann::json::array();

    for (const auto& ceramic : ceramics)
        device["ceramics"].push_back (ceramicJson (like, ceramic, isPlate));

    return device;
}

PlacedDevice place (const PlaceRequest& request, const ShowProgress& show)
{
    auto found = placed (request, {}, show);
    return { placedDevice (request, found.ceramics).dump(), std::move (found) };
}
} // namespace antinode
