#include "PlaceInputs.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_documents/DeviceFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tuple>

namespace antinode
{
namespace
{

/** "20" or "20x10", mm. */
std::pair<double, double> parseSize (const std::string& text)
{
    const auto fail = [&]
    { throw InputError ("--size-mm " + text, "is not a size; allowed: L or LxW in mm, for example 20 or 20x10"); };
    std::pair<double, double> size;
    const auto* const end = text.data() + text.size();
    const auto first = std::from_chars (text.data(), end, size.first);
    size.second = size.first;

    if (first.ec == std::errc() && first.ptr != end)
    {
        const auto second = std::from_chars (first.ptr + 1, end, size.second);

        if (*first.ptr != 'x' || second.ec != std::errc() || second.ptr != end)
            fail();
    }

    if (first.ec != std::errc() || ! (size.first > 0 && size.second > 0))
        fail();

    return size;
}

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
} // namespace

PlacingOptions placingOptions (const PlaceOptions& options, const CeramicDescription& ceramic)
{
    PlacingOptions placing;
    placing.count = options.count;
    placing.grid.modes = options.modes;
    placing.grid.step = options.step ? *options.step / milli : std::min (ceramic.sizeX, ceramic.sizeY) / 2;
    placing.grid.freeEdgeMargin = options.freeEdge / milli;
    placing.isResolved = ! options.isFrozen;

    if (options.edgeDistance)
        placing.grid.edgeDistance = *options.edgeDistance / milli;

    if (options.duration)
        placing.duration = *options.duration / milli;

    for (const auto& text : options.keepOut)
        placing.keepOut.push_back (parseKeepOut (text));

    return placing;
}

KeepOut parseKeepOut (const std::string& text)
{
    std::array<double, 4> values {};
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const auto [next, error] = std::from_chars (at, end, values[i]);
        const auto isLast = i + 1 == values.size();

        if (error != std::errc() || (isLast ? next != end : next == end || *next != ','))
            throw InputError ("--keep-out-mm " + text, "is not a rectangle; allowed: X0,Y0,X1,Y1 in mm");

        at = next + (isLast ? 0 : 1);
    }

    if (! (values[0] < values[2] && values[1] < values[3]))
        throw InputError ("--keep-out-mm " + text, "is empty; allowed: X0 below X1 and Y0 below Y1");

    return { values[0] / milli, values[1] / milli, values[2] / milli, values[3] / milli };
}

nlohmann::json ceramicLike (const nlohmann::json& document, bool isPlate, const std::string& size)
{
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

    if (! size.empty() && ceramic.contains ("diameter_mm"))
        ceramic["diameter_mm"] = parseSize (size).first;
    else if (! size.empty())
        std::tie (ceramic[lengthKey], ceramic[widthKey]) = parseSize (size);

    return ceramic;
}

nlohmann::json placedDevice (nlohmann::json device, const nlohmann::json& like,
                             const std::vector<CeramicDescription>& ceramics)
{
    const auto isPlate = device.value ("kind", "") == "plate";
    const auto name = device.value ("name", "");
    device["name"] = name + ", " + std::to_string (ceramics.size()) + " ceramics placed";
    device["ceramics"] = nlohmann::json::array();

    for (const auto& ceramic : ceramics)
        device["ceramics"].push_back (ceramicJson (like, ceramic, isPlate));

    return device;
}

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
} // namespace antinode
