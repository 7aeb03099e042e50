#pragma once

#include "StructureExamples.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace antinode::examples
{
/** Reference values of plates, with their sources. */
inline const nlohmann::json& plateReferences()
{
    static const auto document =
        nlohmann::json::parse (std::ifstream (std::string (ANTINODE_TEST_DATA) + "/Structure/plates.json"));
    return document;
}

inline EdgeCondition edgeFrom (char letter)
{
    return letter == 'C'   ? EdgeCondition::clamped
           : letter == 'S' ? EdgeCondition::simplySupported
                           : EdgeCondition::free;
}

/** A plate with edges x = 0, y = 0, x = a, y = b as letters C, S, F. */
inline PlateDescription barePlate (const std::string& edges, double lengthX, double lengthY, double poissonRatio = 0.3)
{
    PlateDescription plate;
    plate.common = plainCommon (1e-3);
    plate.common.material = { 200e9, 200e9, 200e9 / (2 * (1 + poissonRatio)), poissonRatio, 8000 };
    plate.lengthX = lengthX;
    plate.lengthY = lengthY;
    plate.left = edgeFrom (edges[0]);
    plate.bottom = edgeFrom (edges[1]);
    plate.right = edgeFrom (edges[2]);
    plate.top = edgeFrom (edges[3]);
    return plate;
}

/** omega a^2 sqrt (rho h / D) of an isotropic plate. */
inline Eigen::VectorXd lambdas (const PlateDescription& plate, const ModalModel& model)
{
    const auto& common = plate.common;
    const auto ratio = common.material.poissonRatio12;
    const auto stiffness = common.material.youngsModulus1 * std::pow (common.thickness, 3) / (12 * (1 - ratio * ratio));
    return model.angularFrequencies
           * (plate.lengthX * plate.lengthX * std::sqrt (common.material.density * common.thickness / stiffness));
}

/** A pair of NCE51 ceramics, by its lower left corner. */
inline CeramicDescription plateCeramic (double x, double y, double sizeX, double sizeY, double thickness = 0.5e-3)
{
    CeramicDescription ceramic;
    ceramic.x = x;
    ceramic.y = y;
    ceramic.sizeX = sizeX;
    ceramic.sizeY = sizeY;
    ceramic.thickness = thickness;
    ceramic.material = findPiezoelectricMaterial ("NCE51").value();
    return ceramic;
}

/** Plate A: 200 x 120 x 1 mm aluminium, clamped at x = 0, with eight pairs of ceramics. */
inline PlateDescription patchedPlate()
{
    PlateDescription plate;
    plate.common = plainCommon (1e-3);
    plate.lengthX = 0.2;
    plate.lengthY = 0.12;
    plate.left = EdgeCondition::clamped;

    for (const auto& corner : plateReferences()["patched_plate"]["lower_left_corners_mm"])
        plate.common.ceramics.push_back (
            plateCeramic (corner[0].get<double>() / 1000, corner[1].get<double>() / 1000, 0.025, 0.025));

    return plate;
}

/** The largest relative deviation of the first frequencies from a list. */
inline double largestDeviation (const Eigen::VectorXd& values, const nlohmann::json& reference)
{
    const auto expected = reference.get<std::vector<double>>();
    double largest = 0;

    for (std::size_t i = 0; i < expected.size(); ++i)
        largest = std::max (largest, std::abs (values[static_cast<Eigen::Index> (i)] / expected[i] - 1));

    return largest;
}
} // namespace antinode::examples
