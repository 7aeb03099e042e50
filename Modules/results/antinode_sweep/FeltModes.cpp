#include "FeltModes.h"

#include <antinode_focus/SpillOver.h>
#include <antinode_model/ShapeInterpolation.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
constexpr double highestFelt = 3000; // Hz: modes above it add less than skin notices
constexpr int fewestModes = 24;

/** An axis with half as many places in each segment: enough for waves that are several times as long. */
GridAxis coarser (const GridAxis& axis)
{
    constexpr int fewest = 4;
    const auto segments = axis.first.size() - 1;
    const Eigen::VectorXi counts = axis.first.tail (segments) - axis.first.head (segments);
    return gridAxis (axis.edges, ((counts.array() + 1) / 2).max (fewest).matrix());
}

/** The same shapes on fewer points. */
ModalModel onCoarserGrid (ModalModel model)
{
    if (! model.surface.grid)
        return model;

    const auto fine = *model.surface.grid;
    const PlateGrid grid { coarser (fine.x), coarser (fine.y) };
    const auto rowsX = interpolationRows (fine.x, grid.x.places), rowsY = interpolationRows (fine.y, grid.y.places);
    Eigen::MatrixXd shapes (rowsX.rows() * rowsY.rows(), model.modes());

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const Eigen::Map<const Eigen::MatrixXd> shape (model.shapes.col (k).data(), rowsX.cols(), rowsY.cols());
        Eigen::Map<Eigen::MatrixXd> (shapes.col (k).data(), rowsX.rows(), rowsY.rows()) =
            rowsX * shape * rowsY.transpose();
    }

    model.shapes = std::move (shapes);
    placeOnGrid (model.surface, grid);
    return model;
}

} // namespace

ModalModel feltModes (const ModalModel& model)
{
    const auto highest = 2 * std::numbers::pi * highestFelt;
    const auto& frequencies = model.angularFrequencies;
    const auto count = std::upper_bound (frequencies.begin(), frequencies.end(), highest) - frequencies.begin();
    return onCoarserGrid (
        firstModes (model, std::max<Eigen::Index> (count, std::min<Eigen::Index> (fewestModes, model.modes()))));
}
} // namespace antinode
