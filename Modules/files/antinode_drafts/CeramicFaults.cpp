#include "CeramicFaults.h"

#include "DeviceEdits.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_outline/OutlineChecks.h>
#include <antinode_outline/PathBuilder.h>

#include <algorithm>
#include <limits>

namespace antinode
{
namespace
{
constexpr double leastDistance = 1e-3; // m from an edge: what glueing by hand is good for.

struct NamedCeramic
{
    std::string name;
    Outline outline;
    OutlineExtent extent;
};

std::vector<NamedCeramic> namedCeramics (const nlohmann::json& device)
{
    std::vector<NamedCeramic> all;
    const auto drawn = ceramicsOf (device);

    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        auto outline = outlineOf (drawn[i]);
        const auto extent = extentOf (outline);
        all.push_back (
            { device["ceramics"][i].value ("name", "ceramic " + std::to_string (i + 1)), std::move (outline), extent });
    }

    return all;
}

bool areApart (const Outline& plate, const std::vector<OutlinePart>& parts)
{
    try
    {
        checkParts (plate, parts);
        return true;
    }
    catch (const InputError&)
    {
        return false;
    }
}

bool mayTouch (const OutlineExtent& a, const OutlineExtent& b)
{
    return (a.least.array() < b.largest.array()).all() && (b.least.array() < a.largest.array()).all();
}

/** A rectangle around both, in which they lie for sure. */
Outline around (const OutlineExtent& a, const OutlineExtent& b)
{
    const Eigen::Vector2d least = a.least.cwiseMin (b.least), largest = a.largest.cwiseMax (b.largest);
    const Eigen::Vector2d size = largest - least;
    return { { rectanglePath ((least + largest) / 2, 2 * size, 0, { 0, 0, 0, 0 }, 0) } };
}

/** From its boundary to that of the plate, m. */
double distanceFromEdge (const Outline& plate, const Outline& ceramic)
{
    auto nearest = std::numeric_limits<double>::infinity();

    for (const auto& piece : ceramic.paths.front())
        for (const auto share : { 0.0, 0.25, 0.5, 0.75 })
        {
            const auto place = piece.at (piece.from + share * (piece.to - piece.from));
            nearest = std::min (nearest, distanceToBoundary (plate, place.x(), place.y()));
        }

    return nearest;
}

/** Ceramics of lines are as wide as these. */
double distanceFromEnd (const OutlineExtent& line, const OutlineExtent& ceramic)
{
    return std::min (ceramic.least.x() - line.least.x(), line.largest.x() - ceramic.largest.x());
}
} // namespace

std::vector<CeramicFault> ceramicFaults (const nlohmann::json& device)
{
    const auto plate = outlineOf (device);
    const auto extent = extentOf (plate);
    const auto ceramics = namedCeramics (device);
    std::vector<CeramicFault> faults;

    for (std::size_t i = 0; i < ceramics.size(); ++i)
    {
        const auto& own = ceramics[i];

        for (std::size_t j = 0; j < i; ++j)
            if (mayTouch (own.extent, ceramics[j].extent)
                && ! areApart (around (own.extent, ceramics[j].extent),
                               { { own.name, own.outline }, { ceramics[j].name, ceramics[j].outline } }))
                faults.push_back ({ i, true, own.name + " overlaps " + ceramics[j].name });

        if (! areApart (plate, { { own.name, own.outline } }))
        {
            faults.push_back ({ i, true, own.name + " reaches outside" });
            continue;
        }

        const auto distance =
            isLine (device) ? distanceFromEnd (extent, own.extent) : distanceFromEdge (plate, own.outline);

        if (distance < leastDistance)
            faults.push_back ({ i, false, own.name + " is " + inWords (1000 * distance) + " mm from the edge" });
    }

    return faults;
}
} // namespace antinode
