#pragma once

#include "Structure/StructureExamples.h"

namespace antinode::test
{
/** Devices whose descriptions have something in every field. */
inline StructureCommon everything()
{
    auto common = examples::plainCommon (2e-3);
    common.dampingRatios = { 0.005, 0.006 };
    common.ceramics = { examples::ceramicPair (-0.03, 9e-3, 5e-3, 0.5e-3),
                        examples::ceramicPair (0.02, 9e-3, 5e-3, 0.5e-3) };
    common.maximumFrequency = 30000;
    common.modeCount = 12;
    return common;
}

inline DeviceDescription beam()
{
    return { "strip", "text",
             BeamDescription { everything(), 0.2, 0.01, EdgeCondition::clamped, EdgeCondition::free } };
}

inline DeviceDescription staple()
{
    return { "staple", "text", StapleDescription { everything(), 0.15, 0.017, 0.01 } };
}

inline DeviceDescription plate()
{
    return { "pane", "text", PlateDescription { everything(), 0.2, 0.12 } };
}
} // namespace antinode::test
