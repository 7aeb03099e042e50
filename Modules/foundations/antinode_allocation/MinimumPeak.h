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

/** Row errors beside what is wanted of them that count as none. */
inline constexpr double metResidual = 1e-9;

/** The rows A of a least-peak problem, scaled to norm 1, and what an interior point asks of them. Multipliers and row
    values are those of the scaled rows. [worker] */
class PeakRows
{
public:
    explicit PeakRows (const MinimumPeakProblem&);

    Eigen::Index columns() const { return offsets.back(); }
    const Eigen::VectorXd& wanted() const { return wantedValues; }

    /** A' y, the columns of all ceramics one after the other. */
    Eigen::VectorXd pulls (const Eigen::VectorXd& y) const;

    /** A s. */
    Eigen::VectorXd values (const Eigen::VectorXd& s) const;

    /** The Cholesky factor of T' A diag (weights) A' T, T the basis in which A A' is 1; empty where it has none. */
    Eigen::MatrixXd factored (const Eigen::ArrayXd& weights) const;

    /** y with A diag (weights) A' y = values, of a factor. */
    Eigen::VectorXd solved (const Eigen::MatrixXd& factor, const Eigen::VectorXd& values) const;

    /** s and the least norm that makes up for its row errors. */
    Eigen::VectorXd corrected (Eigen::VectorXd s) const;

    /** The largest row error beside what is wanted of the row, or beside 1e-4 of what the row can take from such
        samples, where that is more. */
    double residual (const Eigen::VectorXd& s) const;

    /** What of the wanted values no samples bring. */
    Eigen::VectorXd unreachable() const;

    Eigen::VectorXd leastNormMultipliers() const { return basis * (basis.transpose() * wantedValues); }
    Eigen::VectorXd scaled (const Eigen::VectorXd& y) const
    {
        return (scale.array() > 0).select (y.cwiseQuotient (scale), 0);
    }
    Eigen::VectorXd unscaled (const Eigen::VectorXd& y) const { return y.cwiseProduct (scale); }

private:
    Eigen::MatrixXd gram (const Eigen::ArrayXd* weights) const;

    std::vector<PeakColumns> ceramics;
    std::vector<Eigen::Index> offsets;
    Eigen::VectorXd scale, wantedValues, absoluteValues;
    Eigen::MatrixXd basis; // N_r x rank: T
};
} // namespace antinode
