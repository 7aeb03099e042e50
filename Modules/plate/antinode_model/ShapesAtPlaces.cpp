#include "ShapesAtPlaces.h"

namespace antinode
{
Eigen::MatrixXd shapesAtPlaces (const ModalModel& model, const Eigen::MatrixX2d& places)
{
    Eigen::MatrixXd shapes (places.rows(), model.modes());

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        shapes.row (p) = shapesAt (model, places (p, 0), places (p, 1));

    return shapes;
}
} // namespace antinode
