#pragma once

#include <antinode_structure/DeviceDescription.h>
#include <antinode_structure/Materials.h>

#include <array>
#include <cmath>
#include <numbers>

namespace antinode::examples
{
/** Damping and limits that no test here depends on. */
inline StructureCommon plainCommon (double thickness)
{
    StructureCommon common;
    common.thickness = thickness;
    common.material = findElasticMaterial ("aluminium").value();
    common.dampingRatios = { 0.005 };
    common.voltageLimit = 150;
    common.fullScaleVoltage = 150;
    return common;
}

/** A uniform aluminium beam of 200 x 10 x 1 mm. */
inline BeamDescription uniformBeam (EdgeCondition left, EdgeCondition right)
{
    BeamDescription beam;
    beam.common = plainCommon (1e-3);
    beam.length = 0.2;
    beam.width = 0.01;
    beam.left = left;
    beam.right = right;
    return beam;
}

/** sqrt (EI / mu) of a bare beam: omega = (beta L)^2 / L^2 times this. */
inline double stiffnessToMass (const StructureCommon& common)
{
    return common.thickness * std::sqrt (common.material.youngsModulus1 / (12 * common.material.density));
}

/** A pair of NCE51 ceramics on both sides, by its centre. */
inline CeramicDescription ceramicPair (double centre, double length, double width, double thickness)
{
    CeramicDescription ceramic;
    ceramic.x = centre - length / 2;
    ceramic.y = -width / 2;
    ceramic.sizeX = length;
    ceramic.sizeY = width;
    ceramic.thickness = thickness;
    ceramic.material = findPiezoelectricMaterial ("NCE51").value();
    return ceramic;
}

/** The staple of the demonstrator without ceramics: aluminium, 150 mm top, 17 mm legs, 10 x 2 mm. */
inline StapleDescription bareStaple()
{
    StapleDescription staple;
    staple.common = plainCommon (2e-3);
    staple.topLength = 0.15;
    staple.legLength = 0.017;
    staple.width = 0.01;
    return staple;
}

/** The demonstrator: the staple with eight pairs of ceramics of several lengths, 5 x 0.5 mm. */
inline StapleDescription demonstrator()
{
    constexpr std::array centres { -62e-3, -45e-3, -30e-3, -18e-3, 4e-3, 22e-3, 41e-3, 62e-3 };
    constexpr std::array lengths { 9e-3, 9e-3, 4.5e-3, 4.5e-3, 6e-3, 9e-3, 9e-3, 4.5e-3 };
    auto staple = bareStaple();

    for (std::size_t i = 0; i < centres.size(); ++i)
        staple.common.ceramics.push_back (ceramicPair (centres[i], lengths[i], 5e-3, 0.5e-3));

    return staple;
}

template <typename Body>
ModalModel solved (const Body& body, std::optional<int> modeCount = {})
{
    return solveStructure ({ "example", "", body }, modeCount);
}

inline Eigen::MatrixXd gramMatrix (const ModalModel& model)
{
    return model.shapes.transpose() * model.surface.masses.asDiagonal() * model.shapes;
}
} // namespace antinode::examples
