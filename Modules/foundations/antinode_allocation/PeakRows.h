#pragma once

#include "MinimumPeak.h"

namespace antinode
{
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
