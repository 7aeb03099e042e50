#include "StructureReader.h"

#include "CeramicReader.h"
#include "FileUnits.h"
#include "LimitsReader.h"
#include "OutlineReader.h"
#include "SubstrateReader.h"
#include "SupportReader.h"

#include <antinode_structure/CeramicShapes.h>
#include <antinode_structure/OutlinedModel.h>
#include <antinode_text/PhysicalRanges.h>

#include <algorithm>
#include <array>
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
} // namespace antinode
