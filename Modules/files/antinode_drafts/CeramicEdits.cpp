#include "CeramicEdits.h"

#include "DeviceEdits.h"

#include <antinode_structure/DescribedCeramic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> shapeWords { "rectangle", "disc", "ring" }; // by CeramicShape
constexpr double millimetresInMetre = 1000;

double number (const Json& object, const char* key, double otherwise = 0)
{
    return object.contains (key) ? object[key].get<double>() : otherwise;
}

CeramicShape shapeIn (const Json& ceramic)
{
    const auto word = ceramic.value ("shape", "rectangle");
    return static_cast<CeramicShape> (std::find (shapeWords.begin(), shapeWords.end(), word) - shapeWords.begin());
}

DrawnCeramic drawn (const Json& ceramic, bool isOnLine)
{
    DrawnCeramic result;
    result.shape = shapeIn (ceramic);

    if (isOnLine)
    {
        result.centre.x() = number (ceramic, "x_mm");
        result.size = { number (ceramic, "length_mm"), number (ceramic, "width_mm") };
        return result;
    }

    const auto diameter = number (ceramic.contains ("carrier") ? ceramic["carrier"] : ceramic, "diameter_mm");
    result.size = result.shape == CeramicShape::rectangle
                      ? Eigen::Vector2d (number (ceramic, "size_x_mm"), number (ceramic, "size_y_mm"))
                      : Eigen::Vector2d::Constant (diameter);
    result.angle = number (ceramic, "angle_deg");
    result.innerDiameter = number (ceramic, "inner_diameter_mm");
    result.centre = ceramic.contains ("centre_mm")
                        ? placeOf (ceramic["centre_mm"])
                        : Eigen::Vector2d (number (ceramic, "x_mm"), number (ceramic, "y_mm")) + result.size / 2;
    return result;
}

void writeRound (Json& ceramic, const DrawnCeramic& wanted)
{
    const auto diameter = tidy (wanted.size.x());
    ceramic["shape"] = shapeWords[static_cast<std::size_t> (wanted.shape)];

    if (ceramic.contains ("carrier"))
    {
        // A larger bender has a larger ceramic.
        auto& carrier = ceramic["carrier"];
        const auto factor = diameter / carrier["diameter_mm"].get<double>();
        carrier["diameter_mm"] = diameter;
        ceramic["diameter_mm"] = tidy (ceramic["diameter_mm"].get<double>() * factor);

        if (carrier.contains ("electrode_diameter_mm"))
            carrier["electrode_diameter_mm"] = tidy (carrier["electrode_diameter_mm"].get<double>() * factor);
    }
    else
        ceramic["diameter_mm"] = diameter;

    ceramic["centre_mm"] = placeJson (wanted.centre);

    if (wanted.shape == CeramicShape::ring)
        ceramic["inner_diameter_mm"] =
            tidy (wanted.innerDiameter > 0 && wanted.innerDiameter < diameter ? wanted.innerDiameter : diameter / 2);
}

void writeRectangle (Json& ceramic, const DrawnCeramic& wanted, bool hasCentre)
{
    ceramic["size_x_mm"] = tidy (wanted.size.x());
    ceramic["size_y_mm"] = tidy (wanted.size.y());

    if (wanted.angle != 0)
        ceramic["angle_deg"] = tidy (wanted.angle);

    if (hasCentre || wanted.angle != 0)
    {
        ceramic["centre_mm"] = placeJson (wanted.centre);
        return;
    }

    ceramic["x_mm"] = tidy (wanted.centre.x() - wanted.size.x() / 2);
    ceramic["y_mm"] = tidy (wanted.centre.y() - wanted.size.y() / 2);
}

/** Its place and size, in the keys that it has. */
void write (Json& ceramic, const DrawnCeramic& wanted, bool isOnLine)
{
    if (isOnLine)
    {
        ceramic["x_mm"] = tidy (wanted.centre.x());
        ceramic["length_mm"] = tidy (wanted.size.x());
        ceramic["width_mm"] = tidy (wanted.size.y());
        return;
    }

    const auto hasCentre = ceramic.contains ("centre_mm");
    const auto isOther = shapeIn (ceramic) != wanted.shape;

    for (const auto* const key :
         { "x_mm", "y_mm", "centre_mm", "size_x_mm", "size_y_mm", "angle_deg", "inner_diameter_mm" })
        ceramic.erase (key);

    if (isOther)
        for (const auto* const key : { "shape", "diameter_mm", "carrier" })
            ceramic.erase (key);

    if (wanted.shape == CeramicShape::rectangle)
        writeRectangle (ceramic, wanted, hasCentre);
    else
        writeRound (ceramic, wanted);
}

/** The first of C1, C2 and so on that no ceramic has. */
std::string freeName (const Json& ceramics)
{
    for (auto i = ceramics.size() + 1;; ++i)
    {
        auto name = "C" + std::to_string (i);

        if (std::none_of (ceramics.begin(), ceramics.end(),
                          [&] (const Json& ceramic) { return ceramic.value ("name", "") == name; }))
            return name;
    }
}
} // namespace

double tidy (double millimetres)
{
    constexpr double digits = 1e6;
    return std::round (millimetres * digits) / digits + 0.0;
}

Json placeJson (const Eigen::Vector2d& place)
{
    return { tidy (place.x()), tidy (place.y()) };
}

Eigen::Vector2d placeOf (const Json& place)
{
    return { place.at (0).get<double>(), place.at (1).get<double>() };
}

std::vector<DrawnCeramic> ceramicsOf (const Json& device)
{
    std::vector<DrawnCeramic> all;

    for (const auto& ceramic : device["ceramics"])
        all.push_back (drawn (ceramic, isLine (device)));

    return all;
}

Outline outlineOf (const DrawnCeramic& drawn)
{
    CeramicDescription ceramic;
    ceramic.shape = drawn.shape;
    ceramic.sizeX = drawn.size.x() / millimetresInMetre;
    ceramic.sizeY = drawn.size.y() / millimetresInMetre;
    ceramic.x = drawn.centre.x() / millimetresInMetre - ceramic.sizeX / 2;
    ceramic.y = drawn.centre.y() / millimetresInMetre - ceramic.sizeY / 2;
    ceramic.angle = drawn.angle * std::numbers::pi / 180;
    ceramic.innerDiameter = drawn.innerDiameter / millimetresInMetre;
    return ceramicOutline (ceramic);
}

Json withCeramic (Json device, std::size_t index, const DrawnCeramic& wanted)
{
    write (device["ceramics"][index], wanted, isLine (device));
    return device;
}

Json withMoreCeramic (Json device, const DrawnCeramic& wanted, std::size_t like)
{
    auto& ceramics = device["ceramics"];
    auto more = like < ceramics.size()
                    ? ceramics[like]
                    : Json { { "thickness_mm", 0.3 }, { "material", "NCE51" }, { "mounting", "one_side" } };
    more["name"] = freeName (ceramics);
    write (more, wanted, isLine (device));
    ceramics.push_back (std::move (more));
    return device;
}

Json withPlaces (Json device, const std::vector<Eigen::Vector2d>& places)
{
    auto all = ceramicsOf (device);

    for (std::size_t i = 0; i < std::min (all.size(), places.size()); ++i)
    {
        all[i].centre = places[i];
        device = withCeramic (std::move (device), i, all[i]);
    }

    return device;
}

Json withoutCeramics (Json device, const CeramicChoice& chosen)
{
    auto& ceramics = device["ceramics"];

    for (auto index = chosen.rbegin(); index != chosen.rend(); ++index)
        ceramics.erase (*index);

    return device;
}

Json withShifted (Json device, const CeramicChoice& chosen, const Eigen::Vector2d& by)
{
    const auto all = ceramicsOf (device);

    for (const auto index : chosen)
    {
        auto shifted = all[index];
        shifted.centre += isLine (device) ? Eigen::Vector2d (by.x(), 0) : by;
        device = withCeramic (std::move (device), index, shifted);
    }

    return device;
}

Json withCeramicKey (Json device, const CeramicChoice& chosen, const std::string& key, const Json& value)
{
    for (const auto index : chosen)
        device["ceramics"][index][key] = value;

    return device;
}

Json withMirrored (Json device, const CeramicChoice& chosen, bool isLeftToRight)
{
    const auto extent = extentOf (outlineOf (device));
    const Eigen::Vector2d twice = (extent.least + extent.largest) * millimetresInMetre;
    const auto all = ceramicsOf (device);

    for (const auto index : chosen)
    {
        auto mirrored = all[index];
        mirrored.angle = -mirrored.angle;
        auto& place = isLeftToRight ? mirrored.centre.x() : mirrored.centre.y();
        place = (isLeftToRight ? twice.x() : twice.y()) - place;
        device = withMoreCeramic (std::move (device), mirrored, index);
    }

    return device;
}

Json withRow (Json device, const DrawnCeramic& kind, std::size_t like, DeviceSide side, int count, double distance)
{
    const auto extent = extentOf (outlineOf (device));
    const Eigen::Vector2d least = extent.least * millimetresInMetre, largest = extent.largest * millimetresInMetre;
    const auto isAlongX = isLine (device) || side == DeviceSide::bottom || side == DeviceSide::top;
    const auto along = isAlongX ? 0 : 1, across = 1 - along;
    const auto isHigh = side == DeviceSide::top || side == DeviceSide::right;
    const auto reach = kind.size[across] / 2 + distance;
    auto each = kind;
    each.centre[across] = isLine (device) ? 0 : isHigh ? largest[across] - reach : least[across] + reach;

    for (int i = 0; i < count; ++i)
    {
        each.centre[along] = least[along] + (largest[along] - least[along]) * (i + 0.5) / count;
        device = withMoreCeramic (std::move (device), each, like);
    }

    return device;
}

Json withRing (Json device, const DrawnCeramic& kind, std::size_t like, int count, double distance)
{
    const auto extent = extentOf (outlineOf (device));
    const Eigen::Vector2d centre = (extent.least + extent.largest) * millimetresInMetre / 2;
    const Eigen::Vector2d radii =
        extent.size() * millimetresInMetre / 2 - Eigen::Vector2d::Constant (kind.size.maxCoeff() / 2 + distance);
    auto each = kind;

    for (int i = 0; i < count; ++i)
    {
        const auto angle = 2 * std::numbers::pi * (i + 0.5) / count;
        each.centre = centre + radii.cwiseProduct (Eigen::Vector2d (std::cos (angle), std::sin (angle)));
        device = withMoreCeramic (std::move (device), each, like);
    }

    return device;
}

std::vector<DrawnPoint> pointsOf (const Json& device)
{
    std::vector<DrawnPoint> all;

    if (device.contains ("points"))
        for (const auto& point : device["points"])
            all.push_back ({ { number (point, "x_mm"), number (point, "y_mm") },
                             number (point, "stiffness_N_per_mm"),
                             number (point, "mass_g") });

    return all;
}

Json withPoint (Json device, std::size_t index, const DrawnPoint& wanted)
{
    auto& points = device["points"];

    if (index >= points.size())
        points.push_back (Json::object());

    auto& point = points[std::min (index, points.size() - 1)];
    point["x_mm"] = tidy (wanted.place.x());
    point["y_mm"] = tidy (wanted.place.y());

    if (wanted.stiffness > 0 || point.contains ("stiffness_N_per_mm"))
        point["stiffness_N_per_mm"] = wanted.stiffness;

    if (wanted.mass > 0 || point.contains ("mass_g"))
        point["mass_g"] = wanted.mass;

    return device;
}

Json withoutPoint (Json device, std::size_t index)
{
    device["points"].erase (index);

    if (device["points"].empty())
        device.erase ("points");

    return device;
}
} // namespace antinode
