#include "RowProducts.h"

#include <algorithm>
#include <iterator>

namespace antinode
{
namespace
{
RowIndices movedByProduct (const Eigen::MatrixXd& participation, const Eigen::MatrixXd& rows)
{
    constexpr auto nothing = 1e-13;
    RowIndices moved;

    if (participation.size() == 0 || rows.size() == 0)
        return moved;

    const auto participationFloor = nothing * participation.cwiseAbs().maxCoeff();
    const auto rowFloor = nothing * rows.cwiseAbs().maxCoeff();

    for (Eigen::Index k = 0; k < rows.rows(); ++k)
        if (participation.row (k).cwiseAbs().maxCoeff() > participationFloor
            && rows.row (k).cwiseAbs().maxCoeff() > rowFloor)
            moved.push_back (k);

    return moved;
}
} // namespace

RowProducts hardProducts (const AllocationProblem& problem)
{
    return { problem.participation, problem.rows, problem.secondParticipation, problem.secondRows };
}

RowProducts guardProducts (const AllocationProblem& problem)
{
    return { problem.guardParticipation, problem.guardRows, problem.secondGuardParticipation, problem.secondGuardRows };
}

RowProducts chosenRows (const RowProducts& products, const RowIndices& which)
{
    RowProducts chosen { products.participation (which, Eigen::all), products.rows (which, Eigen::all), {}, {} };

    if (products.hasSecond())
    {
        chosen.secondParticipation = products.secondParticipation (which, Eigen::all);
        chosen.secondRows = products.secondRows (which, Eigen::all);
    }

    return chosen;
}

RowIndices movedRows (const RowProducts& products)
{
    auto moved = movedByProduct (products.participation, products.rows);

    if (! products.hasSecond())
        return moved;

    const auto more = movedByProduct (products.secondParticipation, products.secondRows);
    RowIndices both;
    std::set_union (moved.begin(), moved.end(), more.begin(), more.end(), std::back_inserter (both));
    return both;
}
} // namespace antinode
