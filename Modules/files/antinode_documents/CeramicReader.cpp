#include "CeramicReader.h"

#include "FileUnits.h"
#include "OutlineReader.h"
#include "SubstrateReader.h"

#include <antinode_structure/DescribedCeramic.h>
#include <antinode_text/JsonReader.h>

#include <algorithm>
#include <numbers>

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

/** An object of a plate's ceramic with keys of its shape besides those that all have. */
JsonObject plateCeramic (const JsonValue& place, std::initializer_list<std::string_view> keysOfShape)
{
    std::vector<std::string_view> keys { "name",   "shape",    "thickness_mm",   "material",    "mounting",
                                         "wiring", "polarity", "capacitance_nF", "loss_factor", "glue" };
    keys.insert (keys.end(), keysOfShape);
    return place.object (keys);
}

void placeAt (CeramicDescription& ceramic, const Eigen::Vector2d& centre)
{
    ceramic.x = centre.x() - ceramic.sizeX / 2;
    ceramic.y = centre.y() - ceramic.sizeY / 2;
}

using PlateSize = std::optional<Eigen::Vector2d>;

CeramicDescription readRectangularCeramic (const JsonValue& place, const PlateSize& size)
{
    const auto object = plateCeramic (place, { "x_mm", "y_mm", "centre_mm", "size_x_mm", "size_y_mm", "angle_deg" });
    const auto most = size.value_or (Eigen::Vector2d::Constant (ranges::lengthMillimetre.maximum));
    const auto angle = object.optional ("angle_deg");
    auto ceramic = readCeramic (object);
    ceramic.angle = angle ? angle->number (ranges::angleDegrees) * std::numbers::pi / 180 : 0.0;

    // Turned ones need other room: the solver looks at that.
    const auto bound = [&] (double largest) { return ceramic.angle == 0 ? largest : ranges::lengthMillimetre.maximum; };
    const auto sizeX = readSize (object.required ("size_x_mm"), bound (most.x()));
    const auto sizeY = readSize (object.required ("size_y_mm"), bound (most.y()));
    ceramic.sizeX = fromMillimetres (sizeX);
    ceramic.sizeY = fromMillimetres (sizeY);

    if (object.has ("centre_mm"))
    {
        if (object.has ("x_mm") || object.has ("y_mm"))
            place.fail ("has both 'centre_mm' and the corner 'x_mm', 'y_mm'; allowed: one of them");

        placeAt (ceramic, readPlaneMillimetres (object.required ("centre_mm")));
        return ceramic;
    }

    if (ceramic.angle != 0)
        place.fail ("has 'angle_deg' and no 'centre_mm' about which it is turned; allowed: 'centre_mm' for its place");

    const auto isBound = size.has_value();
    const auto least = isBound ? 0 : ranges::positionMillimetre.minimum;
    ceramic.x = fromMillimetres (readPosition (object.required ("x_mm"), least,
                                               isBound ? most.x() - sizeX : ranges::positionMillimetre.maximum));
    ceramic.y = fromMillimetres (readPosition (object.required ("y_mm"), least,
                                               isBound ? most.y() - sizeY : ranges::positionMillimetre.maximum));
    return ceramic;
}

CeramicDescription readRound (const JsonValue& place, const JsonObject& object, CeramicShape shape)
{
    auto ceramic = readCeramic (object);
    ceramic.shape = shape;
    ceramic.sizeX = ceramic.sizeY = fromMillimetres (object.required ("diameter_mm").number (ranges::lengthMillimetre));

    if (const auto inner = place.find ("inner_diameter_mm"))
        ceramic.innerDiameter = fromMillimetres (
            inner->number ({ ranges::lengthMillimetre.minimum, toMillimetres (ceramic.sizeX), false, true }));

    placeAt (ceramic, readPlaneMillimetres (object.required ("centre_mm")));
    return ceramic;
}

/** A disc, or a disc bender: then its extent is that of the metal disc. */
CeramicDescription readDiscCeramic (const JsonValue& place, const PlateSize&)
{
    const auto object = plateCeramic (place, { "centre_mm", "diameter_mm", "carrier" });
    auto ceramic = readRound (place, object, CeramicShape::disc);

    if (const auto carrier = object.optional ("carrier"))
    {
        const auto centre = ceramic.centre();
        ceramic.carrier = readCarrier (*carrier, ceramic.sizeX);
        ceramic.sizeX = ceramic.sizeY = readCarrierDiameter (*carrier, ceramic.sizeX);
        placeAt (ceramic, centre);
    }

    return ceramic;
}

CeramicDescription readRingCeramic (const JsonValue& place, const PlateSize&)
{
    const auto object = plateCeramic (place, { "centre_mm", "diameter_mm", "inner_diameter_mm" });
    object.required ("inner_diameter_mm");
    return readRound (place, object, CeramicShape::ring);
}

constexpr WordList<CeramicDescription (*) (const JsonValue&, const PlateSize&), 3> ceramicReaders {
    { { "rectangle", readRectangularCeramic }, { "disc", readDiscCeramic }, { "ring", readRingCeramic } }
};
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

std::vector<CeramicDescription> readPlateCeramics (const JsonValue& list, const std::optional<Eigen::Vector2d>& size)
{
    const auto places = list.items (0, ranges::maximumCeramics);
    std::vector<CeramicDescription> ceramics;

    for (const auto& place : places)
    {
        const auto shape = place.find ("shape");
        const auto read = shape ? shape->choice (ceramicReaders) : readRectangularCeramic;
        ceramics.push_back (read (place, size));
    }

    // On a plate with an outline the solver looks at all of them, once they are known to lie on it.
    if (size && std::all_of (ceramics.begin(), ceramics.end(), fillsItsRectangle))
        requireNoOverlap (places, ceramics);

    return ceramics;
}
} // namespace antinode
