#pragma once

#include "DeviceDescription.h"

#include <antinode_base/StructFields.h>

namespace antinode
{
/** All fields of a described body, in the order of their declaration: what the cache of modes knows it by. [any] */
void fields (auto& stream, Struct<ElasticMaterial> auto& material)
{
    auto& [youngsModulus1, youngsModulus2, shearModulus, poissonRatio12, density] = material;
    stream (youngsModulus1, youngsModulus2, shearModulus, poissonRatio12, density);
}

void fields (auto& stream, Struct<PiezoelectricMaterial> auto& material)
{
    auto& [youngsModulus, poissonRatio, density, d31, permittivityRelative] = material;
    stream (youngsModulus, poissonRatio, density, d31, permittivityRelative);
}

void fields (auto& stream, Struct<CeramicDescription> auto& ceramic)
{
    auto& [name, x, y, sizeX, sizeY, thickness, material, mounting, wiring, polarity, capacitance, lossFactor] =
        ceramic;
    stream (name, x, y, sizeX, sizeY, thickness, material, mounting, wiring, polarity, capacitance, lossFactor);
}

void fields (auto& stream, Struct<StructureCommon> auto& common)
{
    auto& [thickness, material, dampingRatios, ceramics, voltageLimit, slewLimit, currentLimit, fullScaleVoltage,
           maximumFrequency, modeCount] = common;
    stream (thickness, material, dampingRatios, ceramics, voltageLimit, slewLimit, currentLimit, fullScaleVoltage,
            maximumFrequency, modeCount);
}

void fields (auto& stream, Struct<BeamDescription> auto& beam)
{
    auto& [common, length, width, left, right] = beam;
    stream (common, length, width, left, right);
}

void fields (auto& stream, Struct<StapleDescription> auto& staple)
{
    auto& [common, topLength, legLength, width] = staple;
    stream (common, topLength, legLength, width);
}

void fields (auto& stream, Struct<PlateDescription> auto& plate)
{
    auto& [common, lengthX, lengthY, left, right, bottom, top] = plate;
    stream (common, lengthX, lengthY, left, right, bottom, top);
}
} // namespace antinode
