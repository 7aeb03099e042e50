#include "CellFunctions.h"
#include "ImmersedSpace.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <vector>

// What functions of the space are at places: the fields of its coefficients.
namespace antinode
{
const ImmersedCell* ImmersedSpace::cellAt (double xPlace, double yPlace) const
{
    const auto place = axisX.cellAt (xPlace) + axisY.cellAt (yPlace) * axisX.cells();
    const auto number = cellNumber[static_cast<std::size_t> (place)];
    return number < 0 ? nullptr : &activeCells[static_cast<std::size_t> (number)];
}

const ImmersedCell* ImmersedSpace::cellNear (double xPlace, double yPlace) const
{
    constexpr double little = 1e-9; // Of a cell.
    const auto alongX = little * axisX.cellLength (axisX.cellAt (xPlace));
    const auto alongY = little * axisY.cellLength (axisY.cellAt (yPlace));

    for (const auto right : { 0, 1, -1 })
        for (const auto up : { 0, 1, -1 })
            if (const auto* cell = cellAt (xPlace + right * alongX, yPlace + up * alongY))
                return cell;

    return nullptr;
}

Eigen::VectorXd ImmersedSpace::plane (double c, double a, double b) const
{
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero (count);

    for (Eigen::Index j = 0; j < axisY.size(); ++j)
        for (Eigen::Index i = 0; i < axisX.size(); ++i)
            if (const auto number = unknownOf[static_cast<std::size_t> (tensorIndex (i, j))]; number >= 0)
                coefficients[number] = c + a * axisX.centre (i) + b * axisY.centre (j);

    return coefficients;
}

Eigen::MatrixXd ImmersedSpace::evaluate (const Eigen::MatrixX2d& places, const Eigen::MatrixXd& coefficients, int dx,
                                         int dy) const
{
    Eigen::MatrixXd fields = Eigen::MatrixXd::Zero (places.rows(), coefficients.cols());
    std::vector<std::vector<Eigen::Index>> rowsOf (activeCells.size());

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        if (const auto* const cell = cellNear (places (p, 0), places (p, 1)))
            rowsOf[static_cast<std::size_t> (cell - activeCells.data())].push_back (p);

    for (std::size_t c = 0; c < activeCells.size(); ++c)
    {
        const auto& rows = rowsOf[c];

        if (rows.empty())
            continue;

        checkWatch();
        std::vector<Eigen::Vector2d> here;

        for (const auto row : rows)
            here.emplace_back (places.row (row).transpose());

        const CellFunctions functions (*this, activeCells[c], here, std::max (dx, dy));
        const Eigen::MatrixXd local = coefficients (functions.unknowns(), Eigen::all);
        Eigen::MatrixXd values = Eigen::MatrixXd::Zero (static_cast<Eigen::Index> (rows.size()), coefficients.cols());
        addProduct (values, 1, functions.derivative (dx, dy), local);
        fields (rows, Eigen::all) = values;
    }

    return fields;
}
} // namespace antinode
