#pragma once

#include "Structure/PlateExamples.h"

#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_structure/DeviceDescription.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace antinode::test
{
/** Something that takes long. Making it takes as long as what it needs. */
struct LongWork
{
    std::string name;
    std::function<void()> run;
};

/** A focus on each embedded device. */
inline constexpr std::array<std::array<const char*, 2>, 5> embeddedCases { { { "staple", "demonstrator" },
                                                                             { "beam", "demonstrator" },
                                                                             { "phone-bare", "phone-bare-thumb" },
                                                                             { "glass-148x210", "glass-finger" },
                                                                             { "aluminium-200x120",
                                                                               "aluminium-centre" } } };

/** The largest that is promised: an aluminium plate with 64 ceramics and 500 modes. */
inline DeviceDescription largestPlate()
{
    PlateDescription plate;
    plate.common = examples::plainCommon (1e-3);
    plate.common.modeCount = 500;
    plate.lengthX = 0.24;
    plate.lengthY = 0.2;

    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            plate.common.ceramics.push_back (
                examples::plateCeramic (0.01 + 0.029 * i, 0.008 + 0.0245 * j, 0.012, 0.012, 0.2e-3));

    return { "largest plate", "", plate };
}

/** A focus for which the largest plate needs many modes. */
inline FocusDescription largeFocus (AllocationMethod method)
{
    FocusDescription focus;
    focus.name = "large";
    focus.targets = { { TargetShape::bump, 0.1, 0.08, 0.02, 0.002 } };
    focus.focusTime = 0.025;
    focus.modes.count = 200;
    focus.allocation.method = method;
    focus.allocation.guardModes = 100;
    return focus;
}
} // namespace antinode::test
