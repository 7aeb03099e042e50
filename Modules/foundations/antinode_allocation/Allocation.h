#pragma once

#include <Eigen/Core>
#include <antinode_base/Watch.h>

#include <functional>

namespace antinode
{
/** The stage of the solver. */
enum class AllocationStage
{
    activeSet,   ///< The least norm by the voltages' peaks.
    minimumPeak, ///< The least peak by interior points.
    leastNorm    ///< The least norm by interior points.
};

/** The progress of a solver. */
struct AllocationProgress
{
    AllocationStage stage = AllocationStage::activeSet;
    int steps = 0;  ///< Of this stage, rounds of the active set or steps of the interior point.
    double gap = 1; ///< Certified so far, relative; 1 where nothing is yet.
};

/** Called before every step, on the thread that solves. */
using ShowAllocationProgress = std::function<void (const AllocationProgress&)>;

/** Shows the progress, where it is to be shown, and looks at the watch. @throws Cancelled  as checkWatch() [worker] */
inline void report (const ShowAllocationProgress& show, const AllocationProgress& progress)
{
    if (show)
        show (progress);

    checkWatch();
}

/** The allocation problem: the share of each drive on each ceramic. Docs/Theory.md, section 4; paper (29), (30).

    Unknown: M, N_b x N_d (ceramics x drives), V. With the drives sampled as Psi (N_d x N_s):

        minimise    1/2 ||M Psi||_F^2 + guardWeight/2 * scale * sum_g (guard row g of M)^2
        subject to  row k:   sum_i sum_l participation (k, i) rows (k, l) M (i, l) = wanted (k)      (hard)
                    |(M Psi) (i, n)| <= voltageLimits (i)
                    |(M slopes) (i, n)| <= slewLimits (i)      (where there are any)

    A guard row is built like a hard row, from guardParticipation and guardRows, in the same unit, and wants 0. Rows of
   complex modes are sums of two such products: they have a second participation and a second response each.
    `rows` is the identity for the paper's rows (29) and the matrix C of terminal velocities for exact rows.

    So that guardWeight has no unit, scale = E / |wanted|^2, where E = ||M Psi||_F^2 is the least energy that meets the
   hard rows without guards and limits: guards that end as large as all that is wanted cost guardWeight times that
   energy. At weight 100 a guard error of 1 % of the wanted velocities costs as much as 1 % of the drive energy. The
   units of voltages, velocities and participations and the number of samples do not matter.
*/
struct AllocationProblem
{
    Eigen::MatrixXd waveforms;           ///< Psi, N_d x N_s: the drives on a grid of times on which the limit holds.
    Eigen::MatrixXd participation;       ///< N_k x N_b
    Eigen::MatrixXd rows;                ///< N_k x N_d
    Eigen::VectorXd wanted;              ///< N_k
    Eigen::MatrixXd guardParticipation;  ///< N_g x N_b, or empty
    Eigen::MatrixXd guardRows;           ///< N_g x N_d, or empty
    Eigen::MatrixXd secondParticipation; ///< N_k x N_b, or empty: the rows have one product only.
    Eigen::MatrixXd secondRows;          ///< N_k x N_d, or empty
    Eigen::MatrixXd secondGuardParticipation; ///< N_g x N_b, or empty as secondParticipation is.
    Eigen::MatrixXd secondGuardRows;          ///< N_g x N_d, or empty
    double guardWeight = 0;                   ///< lambda, at least 0
    Eigen::MatrixXd slopes;        ///< dPsi/dt, N_d x N_t, 1/s, on a grid on which the slew limits hold, or empty.
    Eigen::VectorXd slewLimits;    ///< N_b, V/s, above 0; empty if slopes are empty.
    Eigen::VectorXd voltageLimits; ///< N_b, V, more than 0
    double peakRoom = 1.001;       ///< AllocationGoal::peak: the norm is the least within so many times the least peak.
};

/** The objective. */
enum class AllocationGoal
{
    norm, ///< The norm, guards included, within the limits.
    peak  ///< The largest |U_i| / voltageLimits (i) and |dU_i/dt| / slewLimits (i), guards ignored; then the norm,
          ///< guards included, within peakRoom times it.
};

enum class AllocationStatus
{
    unconstrained, ///< The closed-form minimum norm keeps the limits.
    optimal,       ///< The limits are active; the duality gap is certified. Always so for AllocationGoal::peak.
    infeasible     ///< Proven infeasible within 1e-6. The allocation is that of AllocationGoal::peak.
};

/** The certificate of an allocation. */
struct AllocationCertificate
{
    AllocationStatus status = AllocationStatus::unconstrained;
    int iterations = 0;   ///< Interior-point iterations over all rounds; 0 where the active set did it.
    int rounds = 0;       ///< Rounds of peak constraint generation.
    double objective = 0; ///< The minimised value, including the guards' part, V^2.
    /** A value that no M can go below which meets the rows and the limits (weak duality), V^2. Where the least peak was
        asked for, or the limits cannot be kept, the limits are those times peakRoom minimumPeakRatio. */
    double bound = 0;
    double gap = 0; ///< (objective - bound) / objective.
    double peakRatio =
        0; ///< The larger of max |U_i| / voltageLimits (i) and max |dU_i/dt| / slewLimits (i) on the grids.
    double peakVoltage = 0; ///< max |U_i| on the grid, V.
    /** Certified: no M has a smaller peakRatio. The least there is, to 1e-6, for AllocationGoal::peak and infeasible
       limits; otherwise only what came up on the way to knowing that the limits can be kept, or 0. */
    double minimumPeakRatio = 0;
    double rowResidual = 0; ///< max |row error| / max |wanted|.
    double milliseconds = 0;
};

struct Allocation
{
    Eigen::MatrixXd matrix; ///< M, N_b x N_d, V.
    AllocationCertificate certificate;
};

/** The best allocation, with its certificate: closed form where that keeps the limits, else an active set of the
   voltages' peaks, and where that does not end a primal-dual interior point method. Deterministic. Limits are kept to
   1e-9 and rows met to 1e-9, or to what rounding the matrix to doubles leaves where drives almost coincide. The gap is
   at most 1e-6, mostly 1e-9. Where the limits cannot be kept (status infeasible) the matrix is that of the least peak:
   the caller decides what to say; all is linear in `wanted`, so wanted / certificate.minimumPeakRatio can be reached.
    Where drives are combinations of others (to 1e-5 of their length) each counts as if 1e-4 of its length were in a
   sample of its own. `wanted` all 0 gives M = 0.
    @throws InputError  when the problem is not well-formed, or a row cannot be met at all (a mode that no ceramic
   moves, or that cannot be steered apart from those before it), naming the row; or when rounding leaves a gap above
   1e-6
    @param  progress  shown before every step
    @throws Cancelled  when a watch of this thread says no
    [worker] Docs/Theory.md, section 4. */
Allocation solveAllocation (const AllocationProblem&, AllocationGoal, const ShowAllocationProgress& = {});

/** The minimum-norm allocation without limits, guards included, closed form.
    @return M, N_b x N_d.
    @throws InputError  as solveAllocation
    [worker] Docs/Theory.md, section 4.2. */
Eigen::MatrixXd minimumNormAllocation (const AllocationProblem&);

/** Checks that sizes agree, numbers are finite, limits are more than 0 and the guards' weight is not negative.
    @throws InputError  naming the first thing that is wrong. [any] */
void validate (const AllocationProblem&);
} // namespace antinode
