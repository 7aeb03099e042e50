#pragma once

#include "OwnRows.h"
#include "WaveformDual.h"

#include <optional>

namespace antinode
{
/** Where a solution stands. */
struct DualPoint
{
    WaveformMultipliers multipliers, slope; ///< slope of the dual: what the rows miss
    Eigen::MatrixXd pulls;
};

/** Where the dual is highest, or far enough on a way without end to prove that there is one. */
struct DualSummit
{
    DualPoint point;
    double residual = 0;  ///< max |row error| / max |wanted| of the hard rows, as they were before they were scaled.
    double peakBound = 0; ///< What the multipliers on the way prove, in terms of the caps.
    int iterations = 0;
};

/** Newton steps on the dual of a bounded waveform, which keep what the next step needs, other limits or not. It refers
    to the dual. Docs/Theory.md, section 4.9. */
class DualClimb
{
public:
    explicit DualClimb (const WaveformDual&);

    /** From multipliers to the summit within the caps as they are. [worker] */
    DualSummit from (const WaveformMultipliers& start);

    /** The multipliers that would do without limits. [worker] */
    WaveformMultipliers unlimited();

private:
    WaveformMultipliers newtonStep (const DualPoint& point);
    Eigen::MatrixXd curvature (const Eigen::MatrixXd& pulls);

    const WaveformDual& dual;
    Eigen::MatrixXd gram; ///< Of all samples.
    FreeGrams seen;
    std::optional<OwnRows> own;
};

/** What multipliers of the hard rows alone prove: wanted' y / sum_i sum_n cap (i, n) |pull|. [worker] */
double computePeakBound (const WaveformDual&, const WaveformMultipliers& y);

/** What all multipliers prove of samples whose soft rows and own parts cost no more than that. [worker] */
double computePeakBound (const WaveformDual&, const WaveformMultipliers& y, double softCost);
} // namespace antinode
