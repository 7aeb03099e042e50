#pragma once

#include "DeviceDescription.h"

#include <antinode_base/Reflection.h>
#include <antinode_outline/Outline.h>

namespace antinode
{
/** All fields of a described body, in the order of their declaration: what the cache of modes knows it by. [any] */
void fields (auto& stream, Struct<ElasticMaterial> auto& material)
{
    auto& [youngsModulus1, youngsModulus2, shearModulus, poissonRatio12, density] = material;
    stream (youngsModulus1, youngsModulus2, shearModulus, poissonRatio12, density);
}

void fields (auto& stream, Struct<FibreComposite> auto& fibres)
{
    auto& [youngsModulus2, shearModulus, d32, electrodeDistance] = fibres;
    stream (youngsModulus2, shearModulus, d32, electrodeDistance);
}

void fields (auto& stream, Struct<PiezoelectricMaterial> auto& material)
{
    auto& [youngsModulus, poissonRatio, density, d31, permittivityRelative, fibres] = material;
    stream (youngsModulus, poissonRatio, density, d31, permittivityRelative, fibres);
}

void fields (auto& stream, Struct<RelaxationTerm> auto& term)
{
    auto& [shearModulus, time] = term;
    stream (shearModulus, time);
}

void fields (auto& stream, Struct<ShearAtFrequency> auto& row)
{
    auto& [frequency, shearModulus, lossFactor] = row;
    stream (frequency, shearModulus, lossFactor);
}

void fields (auto& stream, Struct<ViscoelasticMaterial> auto& material)
{
    auto& [table, slowShearModulus, relaxation, poissonRatio, density] = material;
    stream (table, slowShearModulus, relaxation, poissonRatio, density);
}

void fields (auto& stream, Struct<LayerDescription> auto& layer)
{
    auto& [thickness, material] = layer;
    stream (thickness, material.index());
    std::visit ([&] (auto& value) { stream (value); }, material);
}

void fields (auto& stream, Struct<GlueLayer> auto& glue)
{
    auto& [thickness, material] = glue;
    stream (thickness, material);
}

void fields (auto& stream, Struct<CarrierDisc> auto& carrier)
{
    auto& [thickness, material, ceramicDiameter, electrodeDiameter] = carrier;
    stream (thickness, material, ceramicDiameter, electrodeDiameter);
}

void fields (auto& stream, Struct<SectionReference> auto& reference)
{
    auto& [waveNumber, angularFrequency] = reference;
    stream (waveNumber, angularFrequency);
}

void fields (auto& stream, Struct<CeramicDescription> auto& ceramic)
{
    auto& [name, x, y, sizeX, sizeY, thickness, material, glue, carrier, mounting, wiring, polarity, capacitance,
           lossFactor, shape, angle, innerDiameter] = ceramic;
    stream (name, x, y, sizeX, sizeY, thickness, material, glue, carrier, mounting, wiring, polarity, capacitance,
            lossFactor, shape, angle, innerDiameter);
}

void fields (auto& stream, Struct<StructureCommon> auto& common)
{
    auto& [thickness, material, layers, reference, theory, dampingRatios, ceramics, voltageLimit, slewLimit,
           currentLimit, fullScaleVoltage, maximumFrequency, modeCount] = common;
    stream (thickness, material, layers, reference, theory, dampingRatios, ceramics, voltageLimit, slewLimit,
            currentLimit, fullScaleVoltage, maximumFrequency, modeCount);
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
