#pragma once

#include "StructureExamples.h"

#include <antinode_structure/PlateSection.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <string>

namespace antinode::examples
{
/** Reference values of layered sections, with their sources. */
inline const nlohmann::json& sectionReferences()
{
    static const auto document =
        nlohmann::json::parse (std::ifstream (std::string (ANTINODE_TEST_DATA) + "/Structure/sections.json"));
    return document;
}

inline ElasticMaterial isotropicMaterial (double youngsModulus, double poissonRatio, double density)
{
    return { youngsModulus, youngsModulus, youngsModulus / (2 * (1 + poissonRatio)), poissonRatio, density };
}

/** A soft layer whose modulus does not depend on frequency. */
inline LayerDescription constantCore (double thickness, double shearModulus, double lossFactor, double density)
{
    ViscoelasticMaterial material;
    material.table = { { 1, shearModulus, lossFactor } };
    material.density = density;
    return { thickness, material };
}

/** Layers as a plate's. */
inline StructureCommon laminate (std::vector<LayerDescription> layers)
{
    auto common = plainCommon (0);
    common.dampingRatios = {};

    for (const auto& layer : layers)
        common.thickness += layer.thickness;

    common.layers = std::move (layers);
    return common;
}

/** A 27 mm bender of brass with 0.24 mm of NCE51, glued by its brass. */
inline CeramicDescription benderExample()
{
    CeramicDescription bender;
    bender.sizeX = bender.sizeY = 0.027;
    bender.thickness = 0.24e-3;
    bender.material = findPiezoelectricMaterial ("NCE51").value();
    bender.mounting = CeramicMounting::oneSide;
    bender.carrier = CarrierDisc { 0.3e-3, isotropicMaterial (103e9, 0.34, 8500), 0.0197, 0.0182 };
    return bender;
}
} // namespace antinode::examples
