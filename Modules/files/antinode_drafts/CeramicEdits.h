#pragma once

#include <antinode_structure/DeviceDescription.h>

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace antinode
{
// What a user does to the ceramics, feet and masses of a device while drawing it; as DeviceEdits.h. [any]

/** A ceramic as it is drawn. Lengths in mm. */
struct DrawnCeramic
{
    CeramicShape shape = CeramicShape::rectangle;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d size = Eigen::Vector2d::Zero(); ///< Of a disc both are its diameter; of a bender its carrier's.
    double angle = 0;                               ///< Degrees, counter-clockwise.
    double innerDiameter = 0;                       ///< Of a ring.
};

/** Which ceramics an edit is about, by their indices. */
using CeramicChoice = std::set<std::size_t>;

std::vector<DrawnCeramic> ceramicsOf (const nlohmann::json& device);

/** What the outline of one covers, m. */
Outline outlineOf (const DrawnCeramic&);

/** A device whose ceramic lies elsewhere, or has another size, shape or angle. */
nlohmann::json withCeramic (nlohmann::json device, std::size_t index, const DrawnCeramic&);

/** A device with one more. @param like  which one it is made like; where there is none, a thin one of NCE51 */
nlohmann::json withMoreCeramic (nlohmann::json device, const DrawnCeramic&, std::size_t like);

/** The same ceramics at other places. @param places  one for each, of its middle, mm */
nlohmann::json withPlaces (nlohmann::json device, const std::vector<Eigen::Vector2d>& places);

nlohmann::json withoutCeramics (nlohmann::json device, const CeramicChoice&);

/** The same ceramics shifted. */
nlohmann::json withShifted (nlohmann::json device, const CeramicChoice&, const Eigen::Vector2d& by);

/** A key of these ceramics set: thickness, material, mounting and so on. */
nlohmann::json withCeramicKey (nlohmann::json device, const CeramicChoice&, const std::string& key,
                               const nlohmann::json& value);

/** More ceramics: the same ones mirrored about the middle of the device.
    @param isLeftToRight  else from the lower half to the upper one */
nlohmann::json withMirrored (nlohmann::json device, const CeramicChoice&, bool isLeftToRight);

/** A side of the extent of a device. */
enum class DeviceSide
{
    bottom,
    right,
    top,
    left
};

/** More ceramics: a row of them along a side, evenly, at a distance from it. On a line along all of it.
    @param kind   what each is like; its centre does not count
    @param like   as withMoreCeramic */
nlohmann::json withRow (nlohmann::json device, const DrawnCeramic& kind, std::size_t like, DeviceSide, int count,
                        double distance);

/** More ceramics: a ring of them about the middle, along the boundary, at a distance from it. */
nlohmann::json withRing (nlohmann::json device, const DrawnCeramic& kind, std::size_t like, int count, double distance);

/** A foot or a mass as it is drawn. */
struct DrawnPoint
{
    Eigen::Vector2d place = Eigen::Vector2d::Zero(); ///< mm
    double stiffness = 0;                            ///< N/mm; 0: no spring.
    double mass = 0;                                 ///< g
};

std::vector<DrawnPoint> pointsOf (const nlohmann::json& device);

/** A plate with a point changed, or one more. @param index  the number of points: one more */
nlohmann::json withPoint (nlohmann::json device, std::size_t index, const DrawnPoint&);

nlohmann::json withoutPoint (nlohmann::json device, std::size_t index);

// How documents have numbers and places. [any]

/** Without the last digits of rounding, which nobody has drawn. */
double tidy (double millimetres);

nlohmann::json placeJson (const Eigen::Vector2d&);
Eigen::Vector2d placeOf (const nlohmann::json&);
} // namespace antinode
