#pragma once

#include "DeviceDescription.h"

#include <antinode_base/StructFields.h>
#include <antinode_outline/OutlineFields.h>

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
    auto& [name, x, y, sizeX, sizeY, thickness, material, mounting, wiring, polarity, capacitance, lossFactor, shape,
           angle, innerDiameter] = ceramic;
    stream (name, x, y, sizeX, sizeY, thickness, material, mounting, wiring, polarity, capacitance, lossFactor, shape,
            angle, innerDiameter);
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

void fields (auto& stream, Struct<PlateEdge> auto& edge)
{
    auto& [condition, translation, rotation, lossFactor] = edge;
    stream (condition, translation, rotation, lossFactor);
}

void fields (auto& stream, Struct<PlateArea> auto& area)
{
    auto& [outline, stiffness, lossFactor, massPerArea] = area;
    stream (outline, stiffness, lossFactor, massPerArea);
}

void fields (auto& stream, Struct<PlatePoint> auto& point)
{
    auto& [x, y, stiffness, lossFactor, damping, mass] = point;
    stream (x, y, stiffness, lossFactor, damping, mass);
}

void fields (auto& stream, Struct<OutlinedPlate> auto& plate)
{
    auto& [common, outline, edges, foundation, foundationLoss, areas, points] = plate;
    stream (common, outline, edges, foundation, foundationLoss, areas, points);
}
} // namespace antinode
