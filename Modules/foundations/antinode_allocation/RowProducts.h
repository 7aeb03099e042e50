#pragma once

#include "Allocation.h"

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
} // namespace antinode
