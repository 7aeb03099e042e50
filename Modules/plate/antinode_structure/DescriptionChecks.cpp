#include "DescriptionChecks.h"

#include "DescribedCeramic.h"
#include "PlateWaves.h"

#include <antinode_base/InputError.h>
#include <antinode_outline/OutlineChecks.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace antinode
{
namespace
{
std::string text (double number)
{
    std::ostringstream stream;
    stream << number;
    return stream.str();
}

std::string millimetres (double metres)
{
    return text (metres * 1000) + " mm";
}

void requirePositive (const std::string& where, const std::string& what, double value)
{
    if (! (std::isfinite (value) && value > 0))
        throw InputError (where, what + " is " + text (value) + "; allowed: above 0");
}

void requireCommon (const StructureCommon& common)
{
    requirePositive ("device", "thickness", common.thickness);
    requirePositive ("device", "Young's modulus of the substrate", common.material.youngsModulus1);
    requirePositive ("device", "density of the substrate", common.material.density);
    requirePositive ("device", "full-scale voltage", common.fullScaleVoltage);

    if (! (std::isfinite (common.voltageLimit) && common.voltageLimit >= 0))
        throw InputError ("device", "voltage limit is " + text (common.voltageLimit) + " V; allowed: 0 V or more");

    for (const auto limit : { common.slewLimit, common.currentLimit })
        if (! (std::isfinite (limit) && limit >= 0))
            throw InputError ("device",
                              "slew or current limit is " + text (limit) + "; allowed: above 0, or 0 for none");

    if (common.dampingRatios.empty() && ! hasSoftLayers (common))
        throw InputError ("device", "has no damping ratio; allowed: one for all modes, or a list");

    for (const auto ratio : common.dampingRatios)
        if (! (ratio > 0 && ratio < 1))
            throw InputError ("device", "damping ratio is " + text (ratio) + "; allowed: above 0 to below 1");
}

/** Checks that do not depend on the position of a ceramic. */
void requireCeramic (const std::string& place, const CeramicDescription& ceramic)
{
    requirePositive (place, "thickness", ceramic.thickness);
    requirePositive (place, "Young's modulus", ceramic.material.youngsModulus);
    requirePositive (place, "density", ceramic.material.density);
    requirePositive (place, "width", ceramic.sizeY);

    if (! std::isfinite (ceramic.material.d31))
        throw InputError (place, "d31 is " + text (ceramic.material.d31) + " m/V; allowed: finite numbers");

    if (ceramic.polarity != 1 && ceramic.polarity != -1)
        throw InputError (place, "polarity is " + std::to_string (ceramic.polarity) + "; allowed: 1 or -1");
}

void requireLineCeramic (const std::string& place, const CeramicDescription& ceramic, double length, double width)
{
    requireCeramic (place, ceramic);

    if (ceramic.sizeY > width + edgeTolerance)
        throw InputError (place, "width is " + millimetres (ceramic.sizeY) + "; allowed: up to the device's width of "
                                     + millimetres (width));

    if (! (ceramic.sizeX >= 10 * edgeTolerance))
        throw InputError (place, "length is " + millimetres (ceramic.sizeX)
                                     + "; allowed: " + millimetres (10 * edgeTolerance) + " or more");

    if (! (ceramic.x >= -length / 2 - edgeTolerance && ceramic.x + ceramic.sizeX <= length / 2 + edgeTolerance))
        throw InputError (place, "extends from " + millimetres (ceramic.x) + " to "
                                     + millimetres (ceramic.x + ceramic.sizeX)
                                     + "; allowed: " + millimetres (-length / 2) + " to " + millimetres (length / 2));
}

void requireNoOverlap (const std::vector<CeramicDescription>& ceramics)
{
    std::vector<std::size_t> order (ceramics.size());
    std::iota (order.begin(), order.end(), std::size_t { 0 });
    std::stable_sort (order.begin(), order.end(), [&] (auto a, auto b) { return ceramics[a].x < ceramics[b].x; });

    for (std::size_t i = 1; i < order.size(); ++i)
    {
        const auto& left = ceramics[order[i - 1]];
        const auto& right = ceramics[order[i]];
        const auto overlap = left.x + left.sizeX - right.x;

        if (overlap > edgeTolerance)
            throw InputError (ceramicPlace (order[i], right), "overlaps " + ceramicPlace (order[i - 1], left) + " by "
                                                                  + millimetres (overlap)
                                                                  + "; ceramics may only touch");
    }
}

/** Poisson's ratios of a material that stores energy whatever it is strained: nu^2 < E1 / E2. */
void requirePoissonRatio (const std::string& where, double ratio, double stiffnessRatio)
{
    const auto limit = std::sqrt (stiffnessRatio);

    if (! (std::abs (ratio) < limit))
        throw InputError (where, "Poisson's ratio is " + text (ratio) + "; allowed: above " + text (-limit)
                                     + " to below " + text (limit));
}

/** One side of a plate's ceramic, along one axis. */
void requireInside (const std::string& place, const std::string& axis, double from, double size, double length)
{
    if (! (size >= 10 * edgeTolerance))
        throw InputError (place, "size along " + axis + " is " + millimetres (size)
                                     + "; allowed: " + millimetres (10 * edgeTolerance) + " or more");

    if (! (from >= -edgeTolerance && from + size <= length + edgeTolerance))
        throw InputError (place, "extends from " + axis + " = " + millimetres (from) + " to "
                                     + millimetres (from + size) + "; allowed: 0 to " + millimetres (length));
}

void requireNoOverlapInPlane (const std::vector<CeramicDescription>& ceramics)
{
    for (std::size_t i = 0; i < ceramics.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
            const auto &a = ceramics[i], &b = ceramics[j];
            const auto inX = std::min (a.x + a.sizeX, b.x + b.sizeX) - std::max (a.x, b.x);
            const auto inY = std::min (a.y + a.sizeY, b.y + b.sizeY) - std::max (a.y, b.y);

            if (inX > edgeTolerance && inY > edgeTolerance)
                throw InputError (ceramicPlace (i, a), "overlaps " + ceramicPlace (j, b) + " by " + millimetres (inX)
                                                           + " x " + millimetres (inY) + "; ceramics may only touch");
        }
}

void requirePlateMaterial (const ElasticMaterial& material)
{
    requirePositive ("device", "second Young's modulus of the substrate", material.youngsModulus2);
    requirePositive ("device", "shear modulus of the substrate", material.shearModulus);
    requirePoissonRatio ("device", material.poissonRatio12, material.youngsModulus1 / material.youngsModulus2);
}

void requireNotNegative (const std::string& where, const std::string& what, double value)
{
    if (! (std::isfinite (value) && value >= 0))
        throw InputError (where, what + " is " + text (value) + "; allowed: 0 or more");
}

/** The time grows with the number of lines and arcs times that of cells. */
void requirePieces (const Outline& outline)
{
    constexpr std::size_t most = 2000;
    std::size_t pieces = 0;

    for (const auto& path : outline.paths)
        pieces += path.size();

    if (pieces > most)
        throw InputError ("device: outline", "has " + std::to_string (pieces) + " lines and arcs; allowed: up to "
                                                 + std::to_string (most) + ", curves being arcs and not short lines");
}

void requireSupports (const OutlinedPlate& plate)
{
    for (std::size_t i = 0; i < plate.edges.size(); ++i)
    {
        const auto& edge = plate.edges[i];
        const auto place = "edge " + std::to_string (i + 1);

        if (edge.condition == EdgeCondition::guided)
            throw InputError (place, "is guided; allowed: clamped, simply supported, free or elastic");

        requireNotNegative (place, "stiffness per length", edge.translation);
        requireNotNegative (place, "rotational stiffness per length", edge.rotation);
        requireNotNegative (place, "loss factor", edge.lossFactor);
    }

    requireNotNegative ("device", "foundation", plate.foundation);
    requireNotNegative ("device", "loss factor of the foundation", plate.foundationLoss);

    for (std::size_t i = 0; i < plate.areas.size(); ++i)
    {
        const auto& area = plate.areas[i];
        const auto place = "area " + std::to_string (i + 1);
        requireNotNegative (place, "foundation", area.stiffness);
        requireNotNegative (place, "loss factor", area.lossFactor);
        requireNotNegative (place, "mass per area", area.massPerArea);
    }

    for (std::size_t i = 0; i < plate.points.size(); ++i)
    {
        const auto& point = plate.points[i];
        const auto place = "point " + std::to_string (i + 1);

        if (! plate.outline.contains (point.x, point.y))
            throw InputError (place, "at (" + millimetres (point.x) + ", " + millimetres (point.y)
                                         + ") is not on the plate; allowed: inside its outline, not in a hole");

        requireNotNegative (place, "stiffness", point.stiffness);
        requireNotNegative (place, "loss factor", point.lossFactor);
        requireNotNegative (place, "damping", point.damping);
        requireNotNegative (place, "mass", point.mass);
    }
}

/** Sizes and angle of a ceramic on an outlined plate. */
void requireShape (const std::string& place, const CeramicDescription& ceramic)
{
    if (! (std::isfinite (ceramic.x) && std::isfinite (ceramic.y) && std::isfinite (ceramic.angle)))
        throw InputError (place, "has a place or an angle that is not finite");

    for (const auto size : { ceramic.sizeX, ceramic.sizeY })
        if (! (std::isfinite (size) && size >= 10 * edgeTolerance))
            throw InputError (place, "size is " + millimetres (size) + "; allowed: " + millimetres (10 * edgeTolerance)
                                         + " or more");

    if (ceramic.shape == CeramicShape::ring
        && ! (ceramic.innerDiameter >= 10 * edgeTolerance && ceramic.innerDiameter < ceramic.sizeX))
        throw InputError (place, "inner diameter is " + millimetres (ceramic.innerDiameter)
                                     + "; allowed: above 0 to below the outer diameter of "
                                     + millimetres (ceramic.sizeX));
}

void requireLine (const StructureCommon& common, double length, double width)
{
    requirePositive ("device", "width", width);
    requireCommon (common);

    for (std::size_t i = 0; i < common.ceramics.size(); ++i)
        requireLineCeramic (ceramicPlace (i, common.ceramics[i]), common.ceramics[i], length, width);

    requireNoOverlap (common.ceramics);
}
} // namespace

std::string ceramicPlace (std::size_t index, const CeramicDescription& ceramic)
{
    const auto place = "ceramic " + std::to_string (index + 1);
    return ceramic.name.empty() ? place : place + " (" + ceramic.name + ")";
}

void requireSolvable (const BeamDescription& beam)
{
    requirePositive ("device", "length", beam.length);
    requireLine (beam.common, beam.length, beam.width);
}

void requireSolvable (const StapleDescription& staple)
{
    requirePositive ("device", "length of the top", staple.topLength);
    requirePositive ("device", "length of the legs", staple.legLength);
    requireLine (staple.common, staple.topLength, staple.width);
}

void requireSolvable (const PlateDescription& plate)
{
    requirePositive ("device", "length along x", plate.lengthX);
    requirePositive ("device", "length along y", plate.lengthY);
    requireCommon (plate.common);
    requirePlateMaterial (plate.common.material);

    for (const auto edge : { plate.left, plate.right, plate.bottom, plate.top })
        if (edge == EdgeCondition::guided)
            throw InputError ("device", "has a guided edge; allowed: clamped, simply supported or free");

    for (std::size_t i = 0; i < plate.common.ceramics.size(); ++i)
    {
        const auto& ceramic = plate.common.ceramics[i];
        const auto place = ceramicPlace (i, ceramic);
        requireCeramic (place, ceramic);
        requirePoissonRatio (place, ceramic.material.poissonRatio, 1);
        requireInside (place, "x", ceramic.x, ceramic.sizeX, plate.lengthX);
        requireInside (place, "y", ceramic.y, ceramic.sizeY, plate.lengthY);
    }

    requireNoOverlapInPlane (plate.common.ceramics);
}

void requireSolvable (const OutlinedPlate& plate)
{
    requireCommon (plate.common);
    requirePlateMaterial (plate.common.material);
    checkOutline (plate.outline, "device: outline");
    requirePieces (plate.outline);
    requireSupports (plate);
    std::vector<OutlinePart> parts;

    for (std::size_t i = 0; i < plate.common.ceramics.size(); ++i)
    {
        const auto& ceramic = plate.common.ceramics[i];
        const auto place = ceramicPlace (i, ceramic);
        requireCeramic (place, ceramic);
        requirePoissonRatio (place, ceramic.material.poissonRatio, 1);
        requireShape (place, ceramic);
        parts.push_back ({ place, ceramicOutline (ceramic) });
    }

    checkParts (plate.outline, parts);

    for (std::size_t i = 0; i < plate.areas.size(); ++i)
        checkParts (plate.outline, { { "area " + std::to_string (i + 1), plate.areas[i].outline } });
}
} // namespace antinode
