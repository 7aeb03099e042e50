#pragma once

#include "Allocation.h"

#include <Eigen/Core>

#include <vector>

namespace antinode
{
using RowIndices = std::vector<Eigen::Index>;

/** Rows of an allocation problem as sums of one or two products of a participation and responses to drives. */
struct RowProducts
{
    Eigen::MatrixXd participation;       ///< Rows x N_b
    Eigen::MatrixXd rows;                ///< Rows x N_d
    Eigen::MatrixXd secondParticipation; ///< As the first, or empty.
    Eigen::MatrixXd secondRows;

    bool hasSecond() const { return secondRows.rows() > 0; }
};

/** The hard rows of a problem, and its guards. [worker] */
RowProducts hardProducts (const AllocationProblem&);
RowProducts guardProducts (const AllocationProblem&);

/** Some of them. [worker] */
RowProducts chosenRows (const RowProducts&, const RowIndices&);

/** Which of them some ceramic moves, ascending. [worker] */
RowIndices movedRows (const RowProducts&);

/** The allocation problem in coordinates in which the norm is Euclidean. Docs/Theory.md, section 4.

    With the drives scaled to unit length, diag (1/|psi|) Psi = R' Q' (thin QR), the share of ceramic i is x_i = R diag
   (|psi|) m_i, its voltages are Q x_i and their norm is |x_i|. All x_i together are a matrix X, N_d x N_b. Voltages
   count in the largest limit. The first hardRows rows are the wanted ones, the others the guards; each is scaled so
   that its Gram entry is 1:

        minimise 1/2 |X|^2 + sum over guards (row value)^2 / (2 compliance),  hard row values = wanted,  |Q x_i| <=
   limits (i)

    Slopes count as further samples below those of Q, in parts of the slew limit times the voltage limit. A sample of 0
   parts them.
*/
struct WhitenedAllocation
{
    Eigen::MatrixXd basis;           ///< Q, orthonormal columns, and below it the slopes; N_s x N_d.
    Eigen::Index voltageSamples = 0; ///< Rows of Q.
    Eigen::VectorXd slopeWeights;    ///< N_b: what slopes are multiplied by to count as voltages, s.
    Eigen::MatrixXd toShares;        ///< N_d x N_d: m_i = toShares x_i, V.
    Eigen::MatrixXd responses;       ///< N_r x N_d: row r sees ceramic i as participation (r, i) responses (r, :) x_i.
    Eigen::MatrixXd participation;   ///< N_r x N_b
    Eigen::MatrixXd secondResponses, secondParticipation; ///< The same of the rows' second products, or empty.
    Eigen::VectorXd wanted;                               ///< N_r; 0 for guards.
    Eigen::VectorXd compliance;                           ///< N_r; 0 for hard rows.
    Eigen::VectorXd limits;                               ///< N_b; the largest is 1.
    Eigen::MatrixXd hardFactor;                           ///< Of the hard rows' Gram matrix, as factorLower leaves it.
    Eigen::Index hardRows = 0;
    std::vector<Eigen::Index> hardNames; ///< Which rows of the problem they are.
    Eigen::VectorXd hardScale;           ///< By which factor each was scaled.
    double voltageUnit = 1;              ///< V

    Eigen::Index drives() const { return basis.cols(); }
    Eigen::Index ceramics() const { return participation.cols(); }

    /** What the rows see of one ceramic: row r of N_r x N_d is that of responses times the weight r. Where rows have
       two products, their sums with weights of 1. [worker] */
    Eigen::MatrixXd responsesTo (Eigen::Index ceramic) const;
    Eigen::VectorXd weightsOf (Eigen::Index ceramic) const;

    /** The factors from a ceramic's share to one of its samples, N_d. [any] */
    Eigen::VectorXd direction (Eigen::Index ceramic, Eigen::Index sample) const;

    /** The same without its guards. [worker] */
    WhitenedAllocation withoutGuards() const;

    /** The values of the rows for shares X, N_r. [any] */
    Eigen::VectorXd rowValues (const Eigen::MatrixXd& shares) const;

    /** The Gram matrix of all rows without compliance, N_r x N_r. [worker] */
    Eigen::MatrixXd rowGram() const;

    /** The transpose of rowValues: sum of rows weighted by multipliers, N_d x N_b. [any] */
    Eigen::MatrixXd weightedRows (const Eigen::VectorXd& multipliers) const;

    /** Voltages of all ceramics, and slopes below them, N_s x N_b, in voltageUnit. [worker] */
    Eigen::MatrixXd voltages (const Eigen::MatrixXd& shares) const;

    /** The transpose of voltages: Q' z, N_d x N_b. [worker] */
    Eigen::MatrixXd pull (const Eigen::MatrixXd& sampleMultipliers) const;

    /** Sample multipliers, N_s x N_b, that pull as these shares do: pull (balancing (x)) = x. [worker] */
    Eigen::MatrixXd balancing (const Eigen::MatrixXd& shares) const;

    /** The largest |voltage| / limit on the grid. [any] */
    double peakRatio (const Eigen::MatrixXd& shares) const;

    /** The minimised value, including the guards' part. [any] */
    double objective (const Eigen::MatrixXd& shares) const;

    /** The least shares that add so much to the hard rows of the problem, N_d x N_b.
        @param missing  for all hard rows of the problem
        [worker] */
    Eigen::MatrixXd completing (const Eigen::VectorXd& missing) const;

    /** M, N_b x N_d, V. [any] */
    Eigen::MatrixXd matrix (const Eigen::MatrixXd& shares) const;
};

/** The Gram matrix of the rows, with compliance on its diagonal, factored. N_r x N_r. */
class RowSystem
{
public:
    /** [worker] N_r^2 (N_d + N_b) + N_r^3 / 6 */
    explicit RowSystem (const WhitenedAllocation&);

    /** Multipliers y with rowValues (weightedRows (y)) + compliance y = values. [any] */
    Eigen::VectorXd multipliers (const Eigen::VectorXd& values) const;

    /** L^-1 right, where L L' is the Gram matrix; N_r x any. [worker] */
    Eigen::MatrixXd halfSolve (Eigen::MatrixXd right) const;

    /** The shares of least objective without limits. [worker] */
    Eigen::MatrixXd leastNormShares() const;

    /** Shares with their hard row values brought back to the wanted ones, to rounding, by the smallest change. [worker]
     */
    Eigen::MatrixXd withExactRows (Eigen::MatrixXd shares) const;

private:
    const WhitenedAllocation& problem;
    Eigen::MatrixXd factor;
};

/** Whitens a valid problem that wants something. Where drives are combinations of others (to 1e-5 of their length) each
   gets a sample of 1e-4 of its length that no other drive has, at the end of the basis. Rows that nothing moves and
   that want 0 are left out.
    @throws InputError  when a hard row cannot be met, naming it
    [worker] 4 N_s N_d^2 */
WhitenedAllocation whiten (const AllocationProblem&);
} // namespace antinode
