#pragma once

#include <Eigen/Core>

#include <memory>

namespace antinode
{
/** The multipliers of a dual. */
struct WaveformMultipliers
{
    Eigen::VectorXd rows; ///< N_r
    Eigen::MatrixXd own;  ///< N_r x N_b: of what each ceramic brings of each row; empty where that costs nothing.
};

/** The least-energy samples within limits that bring rows to what is wanted. N_r rows, N_b ceramics, N_s samples.

    Unknown: samples u, N_b x N_s, V. Ceramic i brings part (k, i) = sum_n weights (k, n) u (i, n) of row k, and row k
    gives sum_i participation (k, i) part (k, i):

        minimise    1/2 sum_i sum_n costs (n) u (i, n)^2 + sum over soft rows (row value)^2 / (2 compliance)
                    + 1/2 sum_k sum_i (spread (k, i) part (k, i))^2
        subject to  row value = wanted (hard rows, those of compliance 0),   |u (i, n)| <= limits (i) shares (i, n)
*/
struct BoundedWaveformProblem
{
    Eigen::MatrixXd weights;       ///< N_r x N_s
    Eigen::MatrixXd participation; ///< N_r x N_b
    Eigen::VectorXd wanted;        ///< N_r; 0 for soft rows.
    Eigen::VectorXd compliance;    ///< N_r, at least 0.
    Eigen::VectorXd limits;        ///< N_b, V, more than 0.
    Eigen::VectorXd costs;         ///< N_s: of each sample's energy, more than 0; empty: 1 each.
    Eigen::MatrixXd shares;        ///< N_b x N_s: of the limits, what each sample may have, more than 0; empty: all.
    Eigen::MatrixXd spread;    ///< N_r x N_b: what each ceramic's own part of a row costs, at least 0; empty: nothing.
    WaveformMultipliers start; ///< Those of a problem alike; empty: those without limits.
    double nearness = 0; ///< Above 1: the limits are lowered to so many times the peak bound. 0: they are as given.
};

/** An answer, with what proves it. */
struct BoundedWaveform
{
    Eigen::MatrixXd samples; ///< N_b x N_s, V: clip (A' multipliers / costs), A' the transpose of the
                             ///< rows.
    WaveformMultipliers multipliers;
    bool isMet = false;     ///< Whether the hard rows are met, to 1e-10 of the largest.
    double rowResidual = 0; ///< max |row error| / max |wanted|, hard rows.
    double objective = 0;   ///< What is minimised.
    double softCost = 0;    ///< Of it, what soft rows and ceramics' own parts cost.
    double bound = 0;       ///< No samples within the limits that meet the hard rows have less (weak duality).
    double peakBound = 0;   ///< No samples that meet the hard rows have a smaller max |u (i, n)| / limits (i).
    double limitShare = 1;  ///< Of the limits, what the samples kept; below 1 where they were lowered.
    int iterations = 0;
};

/** Semismooth Newton steps on the dual, u = clip (A' y, +-limits): 3 to 15 of them, each with a line search.
    @return  isMet false where the limits do not allow it, proven where peakBound > 1
    [worker] up to N_b N_r^2 N_s / 2 a step. Docs/Theory.md, section 4.9. */
BoundedWaveform solveBoundedWaveform (const BoundedWaveformProblem&);

/** The same for one problem with several limits: what does not depend on these is kept. */
class BoundedWaveformSolver
{
public:
    /** @param problem  refered to: it outlives this [worker] */
    explicit BoundedWaveformSolver (const BoundedWaveformProblem& problem);
    ~BoundedWaveformSolver();

    /** As solveBoundedWaveform. [worker] */
    BoundedWaveform solve();

    /** With so much of the limits, and shares in place of those of the problem; nearness is left aside.
        @param start  where the steps begin
        [worker] */
    BoundedWaveform solveWithin (double limitShare, const Eigen::MatrixXd& shares, const WaveformMultipliers& start);

private:
    struct Kept;
    std::unique_ptr<Kept> kept;
};

/** What multipliers of the hard rows prove: no samples that meet these rows have a smaller max |u (i, n)| / limits (i).
    They may be those of another problem with the same rows. @param multipliers  N_r [worker] */
double provenPeak (const BoundedWaveformProblem&, const Eigen::VectorXd& multipliers);

/** What all multipliers prove: no samples that meet the hard rows, and whose soft rows and own parts cost no more than
    that, have a smaller max |u (i, n)| / limits (i). [worker] Docs/Theory.md, section 7.5. */
double provenPeak (const BoundedWaveformProblem&, const WaveformMultipliers&, double softCost);

/** Two values between which the least max |u (i, n)| / limits (i) of samples that meet the hard rows lies. */
struct PeakBracket
{
    double lower = 0, upper = 0;
    Eigen::VectorXd multipliers; ///< N_r: what proves the lower one.
};

/** The bracket, closed until upper <= (1 + tolerance) lower, or as far as rounding lets it; upper is infinite where no
   samples meet the rows. All rows are to be hard. [worker] 10 to 25 steps of an interior point (MinimumPeak.h).
   Docs/Theory.md, sections 4.5 and 4.9. */
PeakBracket minimumWaveformPeak (const BoundedWaveformProblem&, double tolerance);
} // namespace antinode
