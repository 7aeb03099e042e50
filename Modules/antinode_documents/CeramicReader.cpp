#include "CeramicReader.h"

#include "FileUnits.h"
#include "MaterialReader.h"
#include "SubstrateReader.h"

#include <antinode_text/PhysicalRanges.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double toleranceMillimetre =
    1e-6; ///< Tolerance for overlapping ceramics and for ceramics beyond the device: rounding, not geometry.

constexpr WordList<CeramicMounting, 2> mountingWords { { { "both_sides", CeramicMounting::bothSides },
                                                         { "one_side", CeramicMounting::oneSide } } };

constexpr WordList<CeramicWiring, 2> wiringWords { { { "parallel", CeramicWiring::parallel },
                                                     { "series", CeramicWiring::series } } };

/** A position that keeps the ceramic on the device. */
double readPosition (const JsonValue& value, double minimum, double maximum)
{
    const auto position = value.number (ranges::positionMillimetre);

    if (position < minimum - toleranceMillimetre || position > maximum + toleranceMillimetre)
        return value.number ({ minimum, maximum });

    return position;
}

double readSize (const JsonValue& value, double maximum)
{
    const auto size = value.number (ranges::lengthMillimetre);
    return size <= maximum + toleranceMillimetre ? size : value.number ({ ranges::lengthMillimetre.minimum, maximum });
}

/** The properties that do not depend on the position of a ceramic. */
CeramicDescription readCeramic (const JsonObject& object)
{
    CeramicDescription ceramic;
    ceramic.thickness = fromMillimetres (object.required ("thickness_mm").number (ranges::lengthMillimetre));
    ceramic.material = readPiezoelectricMaterial (object.required ("material"));
    ceramic.mounting = CeramicMounting::oneSide;
    ceramic.glue = readGlue (object);

    if (const auto mounting = object.optional ("mounting"))
        ceramic.mounting = mounting->choice (mountingWords);

    if (const auto wiring = object.optional ("wiring"))
        ceramic.wiring = wiring->choice (wiringWords);

    if (const auto name = object.optional ("name"))
        ceramic.name = name->text (ranges::maximumNameBytes);

    if (const auto polarity = object.optional ("polarity"))
        ceramic.polarity = polarity->sign();

    if (const auto capacitance = object.optional ("capacitance_nF"))
        ceramic.capacitance = fromNanofarads (capacitance->number (ranges::capacitanceNanofarad));

    if (const auto loss = object.optional ("loss_factor"))
        ceramic.lossFactor = loss->number (ranges::lossFactor);

    return ceramic;
}

bool overlap (const CeramicDescription& a, const CeramicDescription& b)
{
    const auto tolerance = fromMillimetres (toleranceMillimetre);
    const auto inX = std::min (a.x + a.sizeX, b.x + b.sizeX) - std::max (a.x, b.x) > tolerance;
    const auto inY = std::min (a.y + a.sizeY, b.y + b.sizeY) - std::max (a.y, b.y) > tolerance;
    return inX && inY;
}

void requireNoOverlap (const std::vector<JsonValue>& places, const std::vector<CeramicDescription>& ceramics)
{
    for (std::size_t i = 0; i < ceramics.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (overlap (ceramics[i], ceramics[j]))
                places[i].fail ("overlaps /ceramics/" + std::to_string (j) + "; ceramics may only touch");
}
} // namespace

std::vector<CeramicDescription> readCentredCeramics (const JsonValue& list, double length, double width)
{
    const auto places = list.items (0, ranges::maximumCeramics);
    std::vector<CeramicDescription> ceramics;

    for (const auto& place : places)
    {
        const auto object =
            place.object ({ "name", "x_mm", "length_mm", "width_mm", "thickness_mm", "material", "mounting", "wiring",
                            "polarity", "capacitance_nF", "loss_factor", "glue" });
        const auto ownLength = readSize (object.required ("length_mm"), length);
        const auto ownWidth = readSize (object.required ("width_mm"), width);
        const auto reach = (length - ownLength) / 2;
        const auto centre = readPosition (object.required ("x_mm"), -reach, reach);
        auto ceramic = readCeramic (object);
        ceramic.x = fromMillimetres (centre - ownLength / 2);
        ceramic.y = fromMillimetres (-ownWidth / 2);
        ceramic.sizeX = fromMillimetres (ownLength);
        ceramic.sizeY = fromMillimetres (ownWidth);
        ceramics.push_back (ceramic);
    }

    requireNoOverlap (places, ceramics);
    return ceramics;
}

std::vector<CeramicDescription> readCornerCeramics (const JsonValue& list, double lengthX, double lengthY)
{
    const auto places = list.items (0, ranges::maximumCeramics);
    std::vector<CeramicDescription> ceramics;

    for (const auto& place : places)
    {
        const auto object =
            place.object ({ "name", "x_mm", "y_mm", "size_x_mm", "size_y_mm", "thickness_mm", "material", "mounting",
                            "wiring", "polarity", "capacitance_nF", "loss_factor", "glue" });
        const auto sizeX = readSize (object.required ("size_x_mm"), lengthX);
        const auto sizeY = readSize (object.required ("size_y_mm"), lengthY);
        auto ceramic = readCeramic (object);
        ceramic.x = fromMillimetres (readPosition (object.required ("x_mm"), 0, lengthX - sizeX));
        ceramic.y = fromMillimetres (readPosition (object.required ("y_mm"), 0, lengthY - sizeY));
        ceramic.sizeX = fromMillimetres (sizeX);
        ceramic.sizeY = fromMillimetres (sizeY);
        ceramics.push_back (ceramic);
    }

    requireNoOverlap (places, ceramics);
    return ceramics;
}
} // namespace antinode
