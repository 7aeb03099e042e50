#pragma once

#include "BoundedWaveform.h"
#include "FreeGrams.h"

#include <optional>

namespace antinode
{
/** The dual of a bounded waveform and its pieces, rows scaled so that each has a Gram entry of 1, and samples by the
    roots of their costs, so that each costs 1. Docs/Theory.md, section 4.9. [worker] */
class WaveformDual
{
public:
    explicit WaveformDual (const BoundedWaveformProblem&);

    /** Takes so much of the limits, and of that shares of single samples. @param shares  N_b x N_s; empty: all */
    void limit (double share, const Eigen::MatrixXd& shares);

    /** A' y: what multipliers pull each sample to, N_b x N_s. */
    Eigen::MatrixXd computePulls (const WaveformMultipliers& y) const;

    Eigen::MatrixXd clipped (const Eigen::MatrixXd& pulls) const;

    /** What the rows come to, and what each ceramic brings of each times its spread. */
    WaveformMultipliers values (const Eigen::MatrixXd& samples) const;

    /** What the dual still rises by, row by row: what the rows miss. */
    WaveformMultipliers slope (const WaveformMultipliers& y, const Eigen::MatrixXd& pulls) const;

    /** Each sample's part of the dual is v f - v^2 / 2 with v = clip (f). */
    double value (const WaveformMultipliers& y, const Eigen::MatrixXd& pulls) const;

    /** What soft rows and own parts cost, over samples. */
    double softCost (const Eigen::MatrixXd& samples) const;

    /** Multipliers between those of the problem and those of scaled rows. */
    WaveformMultipliers scaled (const WaveformMultipliers& ofProblem) const;
    WaveformMultipliers unscaled (const WaveformMultipliers& y) const;

    bool hasOwnRows() const { return spread.size() > 0; }

    Eigen::VectorXd roots; ///< N_s: of the costs. Samples here are so many times those of the problem.
    Eigen::MatrixXd caps;  ///< N_b x N_s: the limits of samples.
    Eigen::MatrixXd weights, participation, spread;
    Eigen::VectorXd wanted, compliance, scale;

private:
    Eigen::MatrixXd whole; ///< N_b x N_s: the limits as they are.
};

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
