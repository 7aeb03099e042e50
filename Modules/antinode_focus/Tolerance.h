#pragma once

#include "DetuningSpread.h"
#include "FocusDesign.h"
#include "FocusScore.h"
#include "ToleranceCauses.h"

#include <antinode_model/ModalModel.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace antinode
{
/** The devices to draw: their spread and number. */
struct ToleranceOptions
{
    DetuningSpread spread = usualSpread;
    int draws = 200; ///< 1 or more.
    std::uint64_t seed = 1;
};

/** The reported percentiles, %. */
inline constexpr std::array<double, 5> tolerancePercents { 5, 25, 50, 75, 95 };

/** A value at each of tolerancePercents. */
using Percentiles = std::array<double, tolerancePercents.size()>;

/** The tolerance of a design to devices that differ from the model. Fields are compared with what the controlled modes
    represent. */
struct Tolerance
{
    ToleranceOptions options;
    FocusScore known;                   ///< On the nominal device.
    std::vector<FocusScore> draws;      ///< On each device drawn.
    Percentiles vScore {};              ///< Over the draws.
    Percentiles fieldError {};          ///< Over the draws.
    Percentiles peakRatio {};           ///< Over the draws.
    std::vector<ToleranceCause> causes; ///< Causes of error, the largest first.
};

/** The field of a design at the focus, in closed form, on devices drawn around the model. The same options draw the
   same devices for every design, so that designs can be compared. The result does not depend on the number of threads,
   which is that of the machine.
    @param progress  called on the calling thread with 0 to 1
    [worker] Docs/Theory.md, section 7.4. */
Tolerance evaluateTolerance (const ModalModel&, const FocusDesign&, const ToleranceOptions&,
                             const std::function<void (double)>& progress);

/** Percentiles by linear interpolation between the ordered values, the least at 0 and the largest at 100 %.
    @param values  not empty
    [any] */
Percentiles computePercentiles (std::vector<double> values);
} // namespace antinode
