#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace antinode
{
/** What one ceramic adds to the rows: row k takes gains (k) sum_n weights (k, n) s (n). */
struct PeakColumns
{
    Eigen::VectorXd gains;                          ///< N_r
    std::shared_ptr<const Eigen::MatrixXd> weights; ///< N_r x N_n; several ceramics may share it.
};

/** The samples s of least peak that bring rows to what is wanted: minimise p subject to
    sum over columns of (row value) = wanted, |s| <= p. Any number of columns a ceramic. */
struct MinimumPeakProblem
{
    std::vector<PeakColumns> ceramics;
    Eigen::VectorXd wanted; ///< N_r
};

/** Both sides of the least peak p*: lower <= p* <= upper. */
struct MinimumPeak
{
    double lower = 0;            ///< wanted' y / sum |columns' y|: weak duality, for any y.
    double upper = 0;            ///< max |samples|; infinite where no samples meet the rows.
    Eigen::VectorXd multipliers; ///< N_r: y.
    Eigen::VectorXd samples;     ///< Of all ceramics, one after the other; they meet the rows.
    double rowResidual = 0;      ///< max |row error| / |row wanted| or, where more, rounding; 0 is exact.
    int iterations = 0;

    /** (upper - lower) / upper: 0 is closed, 1 says nothing. */
    double gap() const;
};

/** Feasible primal-dual interior-point steps with Mehrotra's predictor and corrector: 8 to 25 of them, with one
    symmetric system of N_r unknowns each. Every iterate has both sides, so the gap is that of what is returned.
    Rows that depend on others to 1e-13 of their norm are met where the wanted values depend in the same way; else upper
   is infinite.
    @param tolerance  the gap asked for
    @param start      an answer for coarser columns that were split, samples handed on; none: the least norm
    @return           within the tolerance, or as far as rounding lets it: look at gap()
    [worker] N_r^2 N / 2 a step, N columns in all. Docs/Theory.md, section 4.5. */
MinimumPeak minimumPeak (const MinimumPeakProblem&, double tolerance, const MinimumPeak* start = nullptr);
} // namespace antinode
