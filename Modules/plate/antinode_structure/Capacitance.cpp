#include "Capacitance.h"

#include "CeramicShapes.h"

#include <antinode_base/InputError.h>

#include <algorithm>

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
} // namespace antinode
