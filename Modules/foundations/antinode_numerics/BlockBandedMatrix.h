#pragma once

#include <Eigen/Core>

#include <vector>

namespace antinode
{
/** A symmetric matrix whose unknowns come in blocks, each coupled to a few of those that follow. Of each block its
   columns are dense, from its diagonal block down to the last block that it reaches. */
class BlockBandedMatrix
{
public:
    /** A matrix of zeros.
        @param sizes  of the blocks
        @param reach  of each block: the last one that it is coupled to, ascending
        [worker] */
    BlockBandedMatrix (const std::vector<Eigen::Index>& sizes, std::vector<Eigen::Index> reach);

    Eigen::Index size() const { return begins.back(); }
    Eigen::Index blocks() const { return static_cast<Eigen::Index> (panels.size()); }

    /** The first unknown of a block; of the number of blocks, the size. [any] */
    Eigen::Index begin (Eigen::Index block) const { return begins[static_cast<std::size_t> (block)]; }
    Eigen::Index size (Eigen::Index block) const { return begin (block + 1) - begin (block); }
    Eigen::Index reach (Eigen::Index block) const { return last[static_cast<std::size_t> (block)]; }
    Eigen::Index blockOf (Eigen::Index unknown) const { return blockOfUnknown[static_cast<std::size_t> (unknown)]; }

    /** The columns of a block, from its diagonal block down; above the diagonal nothing is read. [any] */
    Eigen::MatrixXd& panel (Eigen::Index block) { return panels[static_cast<std::size_t> (block)]; }
    const Eigen::MatrixXd& panel (Eigen::Index block) const { return panels[static_cast<std::size_t> (block)]; }

    /** Adds to an entry and to the one that mirrors it. [any] */
    void add (Eigen::Index row, Eigen::Index column, double value);

    /** The matrix times columns. [worker] */
    Eigen::MatrixXd operator* (const Eigen::MatrixXd& columns) const;

    /** Adds a multiple of a matrix of the same blocks. [worker] */
    void addMultiple (double factor, const BlockBandedMatrix&);

    Eigen::VectorXd diagonal() const;

private:
    std::vector<Eigen::Index> begins, last, blockOfUnknown;
    std::vector<Eigen::MatrixXd> panels;
};

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
