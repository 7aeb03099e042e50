#include "StructureReader.h"

#include "CeramicReader.h"
#include "FileUnits.h"
#include "OutlineReader.h"
#include "SharedFields.h"
#include "SubstrateReader.h"

#include <antinode_base/MessageText.h>
#include <antinode_outline/Outline.h>
#include <antinode_structure/DescribedCeramic.h>
#include <antinode_structure/OutlinedModel.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr WordList<EdgeCondition, 4> beamEndWords { { { "clamped", EdgeCondition::clamped },
                                                      { "simply_supported", EdgeCondition::simplySupported },
                                                      { "free", EdgeCondition::free },
                                                      { "guided", EdgeCondition::guided } } };

/** An object of a device whose kind adds these keys to those that all described devices share. */
JsonObject readBody (const JsonValue& device, std::initializer_list<std::string_view> keysOfKind)
{
    std::vector<std::string_view> keys { "schema",       "name",     "description",   "kind",
                                         "thickness_mm", "material", "damping_ratio", "quality_factor",
                                         "ceramics",     "limits",   "modes",         theoryKey };
    keys.insert (keys.end(), keysOfKind);
    return device.object (keys);
}

double readLength (const JsonObject& body, std::string_view key)
{
    return body.required (key).number (ranges::lengthMillimetre);
}

/** Everything that is shared but the ceramics, whose place depends on the kind. */
StructureCommon readCommon (const JsonObject& body)
{
    StructureCommon common;
    readSubstrate (common, body);
    const auto limits = readLimits (body.required ("limits"));
    common.voltageLimit = limits.voltage;
    common.slewLimit = limits.slew;
    common.currentLimit = limits.current;
    common.fullScaleVoltage = limits.fullScale;

    if (const auto given = body.optional ("modes"))
    {
        const auto modes = given->object ({ "maximum_frequency_Hz", "count" });

        if (const auto frequency = modes.optional ("maximum_frequency_Hz"))
            common.maximumFrequency = frequency->number (ranges::frequencyHz);

        if (const auto count = modes.optional ("count"))
            common.modeCount = count->integer (1, static_cast<int> (ranges::maximumModes));
    }

    return common;
}

OutlinedPlate readOutlinedPlate (const JsonValue& device)
{
    const auto body = readBody (device, { "outline", "edges", "foundation", "areas", "points", layersKey });
    auto named = readOutline (body.required ("outline"));
    OutlinedPlate plate;
    plate.common = readCommon (body);
    plate.common.ceramics = readPlateCeramics (body.required ("ceramics"), {});
    plate.outline = std::move (named.outline);
    readPlateEdges (body.required ("edges"), named.edges, plate);
    readSupports (body, plate);
    return plate;
}
} // namespace

BeamDescription readBeam (const JsonValue& device)
{
    const auto body = readBody (device, { "length_mm", "width_mm", "ends" });
    const auto length = readLength (body, "length_mm");
    const auto width = readLength (body, "width_mm");
    const auto ends = body.required ("ends").object ({ "left", "right" });

    BeamDescription beam;
    beam.common = readCommon (body);
    beam.common.ceramics = readCentredCeramics (body.required ("ceramics"), length, width);
    beam.length = fromMillimetres (length);
    beam.width = fromMillimetres (width);
    beam.left = ends.required ("left").choice (beamEndWords);
    beam.right = ends.required ("right").choice (beamEndWords);
    return beam;
}

StapleDescription readStaple (const JsonValue& device)
{
    const auto body = readBody (device, { "top_length_mm", "leg_length_mm", "width_mm" });
    const auto topLength = readLength (body, "top_length_mm");
    const auto width = readLength (body, "width_mm");

    StapleDescription staple;
    staple.common = readCommon (body);
    staple.common.ceramics = readCentredCeramics (body.required ("ceramics"), topLength, width);
    staple.topLength = fromMillimetres (topLength);
    staple.legLength = fromMillimetres (readLength (body, "leg_length_mm"));
    staple.width = fromMillimetres (width);
    return staple;
}

std::variant<PlateDescription, OutlinedPlate> readPlate (const JsonValue& device)
{
    if (device.find ("outline"))
        return readOutlinedPlate (device);

    const auto body = readBody (
        device, { "length_x_mm", "length_y_mm", "edges", "foundation", "areas", "points", "outline", layersKey });
    const auto lengthX = readLength (body, "length_x_mm");
    const auto lengthY = readLength (body, "length_y_mm");
    const auto edges = body.required ("edges").object ({ "left", "right", "bottom", "top" });

    PlateDescription plate;
    plate.common = readCommon (body);
    plate.common.ceramics = readPlateCeramics (body.required ("ceramics"), Eigen::Vector2d (lengthX, lengthY));
    plate.lengthX = fromMillimetres (lengthX);
    plate.lengthY = fromMillimetres (lengthY);
    const std::array sides { readPlateEdge (edges.required ("bottom")), readPlateEdge (edges.required ("right")),
                             readPlateEdge (edges.required ("top")), readPlateEdge (edges.required ("left")) };
    const auto isElastic = [] (const PlateEdge& edge) { return edge.translation > 0 || edge.rotation > 0; };
    const auto isAligned = std::all_of (plate.common.ceramics.begin(), plate.common.ceramics.end(), fillsItsRectangle);

    if (isAligned && std::none_of (sides.begin(), sides.end(), isElastic) && ! body.has ("foundation")
        && ! body.has ("areas") && ! body.has ("points"))
    {
        plate.bottom = sides[0].condition;
        plate.right = sides[1].condition;
        plate.top = sides[2].condition;
        plate.left = sides[3].condition;
        return plate;
    }

    auto outlined = outlinedPlate (plate);
    outlined.edges.assign (sides.begin(), sides.end());
    readSupports (body, outlined);
    return outlined;
}

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
