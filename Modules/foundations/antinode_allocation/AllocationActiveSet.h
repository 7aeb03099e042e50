#pragma once

#include "Allocation.h"
#include "LimitedAllocation.h"
#include "WhitenedAllocation.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace antinode
{
/** A sample of one ceramic's voltage that a limit holds: sign voltage <= limit. */
struct ActivePeak
{
    Eigen::Index ceramic = 0, sample = 0;
    double sign = 1;
};

/** The least objective where sign q_n' x_i <= limit (i) is imposed on some peaks only, by their multipliers z >= 0.

    The shares are E' y - Z with the rows E, their multipliers y and column i of Z the sum of z sign q_n over the peaks
   of ceramic i. With y eliminated the dual is d' z - z' K z / 2 with K = A' A - V' V and d the voltage beyond the limit
   without any z. A are the peaks' directions, which overlap only within a ceramic; V = L^-1 E A, L L' the rows' Gram
   matrix. It is maximised by projected Newton steps. Docs/Theory.md, section 4.3.
*/
class ActivePeaks
{
public:
    /** @param start   the shares of least objective without limits
        @param limits  N_b, in the problem's unit
        The first three are referred to. [worker] */
    ActivePeaks (const WhitenedAllocation&, const RowSystem&, const Eigen::MatrixXd& start, Eigen::VectorXd limits);

    /** Limits these peaks, ordered by ceramics, and no others.
        @param multipliers  where to start, one a peak
        @return  false where there is no optimum, as far as known
        [worker] a step N^2 (N_d + N_r) / 2 + N^3 / 6 */
    bool solve (std::vector<ActivePeak>, Eigen::VectorXd multipliers);

    const std::vector<ActivePeak>& peaks() const { return list; }

    /** The multiplier of each peak, N. */
    const Eigen::VectorXd& multipliers() const { return z; }

    /** N_d x N_b, hard rows met to rounding. [worker] */
    Eigen::MatrixXd shares() const;

    /** z with signs, N_s x N_b. [worker] */
    Eigen::MatrixXd sampleMultipliers() const;

private:
    using Indices = std::vector<Eigen::Index>;

    const ActivePeak& peak (Eigen::Index j) const { return list[static_cast<std::size_t> (j)]; }
    void set (std::vector<ActivePeak>, Eigen::VectorXd multipliers);
    Eigen::MatrixXd gram() const;
    Eigen::VectorXd excess (const Eigen::MatrixXd& shares) const;
    Eigen::VectorXd gradient() const { return beyond - matrix.selfadjointView<Eigen::Lower>() * z; }
    Indices pushedOrWrong (const Eigen::VectorXd& slope) const;
    Eigen::VectorXd newtonStep (const Indices&, const Eigen::VectorXd& slope) const;
    Eigen::VectorXd risingStep (Indices, const Eigen::VectorXd& slope) const;
    void ascend (const Eigen::VectorXd& step, const Eigen::VectorXd& slope);
    bool polish();

    const WhitenedAllocation& problem;
    const RowSystem& rows;
    const Eigen::MatrixXd& start;
    Eigen::VectorXd limits;
    std::vector<ActivePeak> list;
    Eigen::MatrixXd normals; ///< sign q_n, N_d x N.
    Eigen::MatrixXd matrix;  ///< K, lower triangle.
    Eigen::VectorXd beyond;  ///< d
    Eigen::VectorXd z;
};

/** Shares of the least objective within |Q x_i| <= ratio limits (i), by a dual active set: peaks at their limits are
   treated as equations, all wrong ones are exchanged at once. The ceramics meet in the rows alone, so the equations'
   matrix costs N_active^2 (N_d + N_r) / 2, and no matrix of all unknowns is made. Faster than the interior point where
   it ends, which it does not have to: then the limits may be out of reach.
    @param start  the shares of least objective without limits
    @return       shares within 1e-9 of the limits on all samples; nothing if more peaks are active than it is made for,
   or where the exchange leads nowhere [worker] Docs/Theory.md, section 4.3. */
std::optional<LimitedAllocation> activeSetShares (const WhitenedAllocation&, const RowSystem&, double ratio,
                                                  const Eigen::MatrixXd& start, const ShowAllocationProgress&);
} // namespace antinode
