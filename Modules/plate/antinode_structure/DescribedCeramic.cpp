#include "DescribedCeramic.h"

#include <antinode_base/InputError.h>
#include <antinode_outline/PathBuilder.h>

#include <algorithm>
#include <numbers>

namespace antinode
{
double capacitance (const CeramicDescription& ceramic)
{
    if (ceramic.capacitance > 0)
        return ceramic.capacitance;

    constexpr auto vacuumPermittivity = 8.8541878128e-12; // F/m
    const auto one =
        vacuumPermittivity * ceramic.material.permittivityRelative * faceArea (ceramic) / ceramic.thickness;

    if (ceramic.mounting == CeramicMounting::oneSide)
        return one;

    return ceramic.wiring == CeramicWiring::parallel ? 2 * one : one / 2;
}

double slewLimit (const StructureCommon& common, std::size_t index)
{
    if (common.currentLimit == 0)
        return common.slewLimit;

    const auto charged = capacitance (common.ceramics[index]);

    if (! (charged > 0))
        throw InputError ("device: current limit", "needs the capacitance of ceramic " + std::to_string (index + 1)
                                                       + ", but its material has no relative permittivity; give it, or "
                                                         "a limit of the slew rate (device: slew limit)");

    const auto byCurrent = common.currentLimit / charged;
    return common.slewLimit > 0 ? std::min (common.slewLimit, byCurrent) : byCurrent;
}

double faceArea (const CeramicDescription& ceramic)
{
    if (ceramic.carrier)
        return std::numbers::pi / 4 * ceramic.carrier->electrodeDiameter * ceramic.carrier->electrodeDiameter;

    const auto rectangle = ceramic.sizeX * ceramic.sizeY;

    if (ceramic.shape == CeramicShape::rectangle)
        return rectangle;

    const auto hole = ceramic.shape == CeramicShape::ring ? ceramic.innerDiameter * ceramic.innerDiameter : 0;
    return std::numbers::pi / 4 * (rectangle - hole);
}

bool fillsItsRectangle (const CeramicDescription& ceramic)
{
    return ceramic.shape == CeramicShape::rectangle && ceramic.angle == 0;
}

Outline ceramicOutline (const CeramicDescription& ceramic)
{
    const auto centre = ceramic.centre();

    switch (ceramic.shape)
    {
        case CeramicShape::rectangle:
            return { { rectanglePath (centre, { ceramic.sizeX, ceramic.sizeY }, ceramic.angle, { 0, 0, 0, 0 }, 0) } };
        case CeramicShape::disc:
            return { { circlePath (centre, ceramic.sizeX / 2, 0) } };
        case CeramicShape::ring:
            return { { circlePath (centre, ceramic.sizeX / 2, 0), circlePath (centre, ceramic.innerDiameter / 2, 1) } };
    }

    return {};
}

OutlineExtent ceramicExtent (const CeramicDescription& ceramic)
{
    if (fillsItsRectangle (ceramic))
        return { { ceramic.x, ceramic.y }, { ceramic.x + ceramic.sizeX, ceramic.y + ceramic.sizeY } };

    return extentOf (ceramicOutline (ceramic));
}
} // namespace antinode
