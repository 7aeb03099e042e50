#pragma once

#include "BlockBandedMatrix.h"

namespace antinode
{
/** L D L' of a symmetric matrix, block by block, without pivoting. D is positive for a definite matrix; for an
   indefinite one the number of its negative entries is that of the matrix's negative eigenvalues (Sylvester's law of
   inertia). Golub, Van Loan, Matrix Computations, sections 4.2 to 4.4. */
class BlockBandedFactor
{
public:
    /** @param matrix  becomes L
        [worker] */
    explicit BlockBandedFactor (BlockBandedMatrix matrix);

    /** The inverse times the columns, in place. [worker] */
    void solveInPlace (Eigen::MatrixXd& columns) const;

    /** How many eigenvalues of the matrix are negative. [any] */
    Eigen::Index negativePivots() const { return negatives; }

    /** False where a pivot vanished or a number became too large: then nothing else is to be used. [any] */
    bool isUsable() const { return usable; }

private:
    void eliminate (Eigen::Index block);
    void factorDiagonal (Eigen::Index block);

    BlockBandedMatrix lower;
    Eigen::VectorXd pivots;
    Eigen::Index negatives = 0;
    bool usable = true;
};
} // namespace antinode
