#pragma once

#include "Field.h"

#include <antinode_focus/Tolerance.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** Devices that are drawn around a model. */
struct DrawnDevices
{
    int draws = 200;
    int seed = 1;
    std::optional<double> frequency, damping, participation, drift; ///< Relative standard deviations; none: the usual.
};

/** [any] */
std::vector<Field> fields (DrawnDevices&);

/** @param usual  what counts where the request gives none [any] */
ToleranceOptions toleranceOptions (const DrawnDevices&, const DetuningSpread& usual);

/** "200 random devices; standard deviations: 0.1 % in frequency, ...". [any] */
std::string drawnInWords (const ToleranceOptions&);
} // namespace antinode
