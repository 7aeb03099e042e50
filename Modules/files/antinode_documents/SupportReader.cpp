#include "SupportReader.h"

#include "FileUnits.h"
#include "OutlineReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_outline/OutlineParts.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr std::size_t maximumSupports = 1000;
constexpr double newtonsPerSquareMillimetre = 1e6, newtonsPerCubicMillimetre = 1e9; // in N/m^2, N/m^3

constexpr WordList<EdgeCondition, 3> edgeWords { { { "clamped", EdgeCondition::clamped },
                                                   { "simply_supported", EdgeCondition::simplySupported },
                                                   { "free", EdgeCondition::free } } };

double numberOrZero (const JsonObject& object, std::string_view key, const NumberRange& range)
{
    const auto given = object.optional (key);
    return given ? given->number (range) : 0;
}

double readLoss (const JsonObject& object)
{
    return numberOrZero (object, "loss_factor", ranges::supportLossFactor);
}

/** A place on the boundary of an outline, or nearly so. */
Eigen::Vector2d readPlaceOn (const JsonValue& value, const Outline& outline)
{
    constexpr double near = 0.01; // of the outline's size
    auto place = readPlaneMillimetres (value);
    const auto most = near * extentOf (outline).size().maxCoeff();

    if (const auto distance = distanceToBoundary (outline, place.x(), place.y()); ! (distance <= most))
        value.fail ("is " + numberText (1000 * distance) + " mm from the outline; allowed: up to "
                    + numberText (1000 * most) + " mm");

    return place;
}

void readParts (const JsonValue& list, OutlinedPlate& plate)
{
    for (const auto& item : list.items (0, maximumSupports))
    {
        const auto part = item.object ({ "from_mm", "to_mm", "support" });
        const auto from = readPlaceOn (part.required ("from_mm"), plate.outline);
        const auto to = readPlaceOn (part.required ("to_mm"), plate.outline);
        auto outline = withEdgeAlong (plate.outline, from, to, static_cast<int> (plate.edges.size()));

        if (! outline)
            item.fail ("begins on one path of the outline and ends on another; allowed: both on one");

        plate.outline = std::move (*outline);
        plate.edges.push_back (readPlateEdge (part.required ("support")));
    }
}
} // namespace

PlateEdge readPlateEdge (const JsonValue& value)
{
    PlateEdge edge;

    if (! value.isObject())
    {
        edge.condition = value.choice (edgeWords);
        return edge;
    }

    const auto object = value.object ({ "stiffness_N_per_mm2", "rotation_stiffness_N", "loss_factor" });

    if (! value.find ("stiffness_N_per_mm2") && ! value.find ("rotation_stiffness_N"))
        object.fail ("has no stiffness; allowed: \"stiffness_N_per_mm2\", \"rotation_stiffness_N\" or both");

    edge.translation =
        numberOrZero (object, "stiffness_N_per_mm2", ranges::supportStiffness) * newtonsPerSquareMillimetre;
    edge.rotation = numberOrZero (object, "rotation_stiffness_N", ranges::supportStiffness);
    edge.lossFactor = readLoss (object);
    return edge;
}

void readPlateEdges (const JsonValue& value, const std::vector<std::string>& names, OutlinedPlate& plate)
{
    const auto isOfAll =
        ! value.isObject() || value.find ("stiffness_N_per_mm2") || value.find ("rotation_stiffness_N");

    if (isOfAll)
    {
        plate.edges.assign (names.size(), readPlateEdge (value));
        return;
    }

    std::vector<std::string_view> keys (names.begin(), names.end());
    keys.insert (keys.end(), { "others", "parts" });
    const auto object = value.object (keys);
    const auto others = object.optional ("others");

    for (const auto& name : names)
    {
        const auto given = object.optional (name);
        plate.edges.push_back (readPlateEdge (given ? *given : others ? *others : object.required (name)));
    }

    if (const auto parts = object.optional ("parts"))
        readParts (*parts, plate);
}

void readSupports (const JsonObject& device, OutlinedPlate& plate)
{
    if (const auto foundation = device.optional ("foundation"))
    {
        const auto object = foundation->object ({ "stiffness_N_per_mm3", "loss_factor" });
        plate.foundation =
            object.required ("stiffness_N_per_mm3").number (ranges::supportStiffness) * newtonsPerCubicMillimetre;
        plate.foundationLoss = readLoss (object);
    }

    if (const auto areas = device.optional ("areas"))
        for (const auto& item : areas->items (0, maximumSupports))
        {
            const auto object = item.object ({ "outline", "stiffness_N_per_mm3", "loss_factor", "mass_kg_m2" });
            PlateArea area;
            area.outline = readOutline (object.required ("outline")).outline;
            area.stiffness =
                numberOrZero (object, "stiffness_N_per_mm3", ranges::supportStiffness) * newtonsPerCubicMillimetre;
            area.lossFactor = readLoss (object);
            area.massPerArea = numberOrZero (object, "mass_kg_m2", ranges::massPerArea);
            plate.areas.push_back (std::move (area));
        }

    if (const auto points = device.optional ("points"))
        for (const auto& item : points->items (0, maximumSupports))
        {
            const auto object =
                item.object ({ "x_mm", "y_mm", "stiffness_N_per_mm", "loss_factor", "damping_N_s_per_m", "mass_g" });
            PlatePoint point;
            point.x = fromMillimetres (object.required ("x_mm").number (ranges::positionMillimetre));
            point.y = fromMillimetres (object.required ("y_mm").number (ranges::positionMillimetre));
            point.stiffness =
                fromNewtonsPerMillimetre (numberOrZero (object, "stiffness_N_per_mm", ranges::supportStiffness));
            point.lossFactor = readLoss (object);
            point.damping = numberOrZero (object, "damping_N_s_per_m", ranges::supportDamping);
            point.mass = fromGrams (numberOrZero (object, "mass_g", ranges::massGram));
            plate.points.push_back (point);
        }
}
} // namespace antinode
