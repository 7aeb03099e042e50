#pragma once

#include "TensorOperator.h"

#include <antinode_numerics/DenseKernels.h>

#include <vector>

namespace antinode
{
/** L D L' of a symmetric operator on the splines of a plate, without pivoting. The unknowns of one outer spline are a
   block; blocks reach as far as outer splines overlap. D is positive for a definite operator; for an indefinite one the
   number of its negative entries is that of the operator's negative eigenvalues (Sylvester's law of inertia). Golub,
   Van Loan, Matrix Computations, sections 4.2 to 4.4. */
class BlockBandedFactor
{
public:
    /** @param stiffness, mass  symmetric operators of the same size
        @param shift            K - shift M is what is factored
        @param outer            the axis of the blocks
        [worker] */
    BlockBandedFactor (const TensorOperator& stiffness, const TensorOperator& mass, double shift,
                       const SplineAxis& outer);

    /** (K - shift M)^-1 times the columns, in place. [worker] */
    void solveInPlace (Eigen::MatrixXd& columns) const;

    /** How many eigenvalues of K x = lambda M x lie below the shift. [any] */
    Eigen::Index negativePivots() const { return negatives; }

    /** False where a pivot vanished or a number became too large: then nothing else is to be used. [any] */
    bool isUsable() const { return usable; }

private:
    void addTerms (const TensorOperator&, double factor);
    void eliminate (Eigen::Index block);
    void factorDiagonal (MatrixOut diagonal, Eigen::Index firstPivot);

    Eigen::Index blockSize;
    std::vector<Eigen::Index> last;      ///< Of each block: the last one that it reaches.
    std::vector<Eigen::MatrixXd> panels; ///< Of each block: its columns of L, from its diagonal block down.
    Eigen::VectorXd pivots;
    Eigen::Index negatives = 0;
    bool usable = true;
};
} // namespace antinode
