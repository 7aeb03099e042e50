#include "Orthogonalisation.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
void orthogonalise (IdentifiedModes& modes, const Eigen::VectorXd& masses)
{
    std::vector<Eigen::Index> used;

    for (Eigen::Index p = 0; p < modes.shapes.rows(); ++p)
        if (modes.shapes.row (p).allFinite())
            used.push_back (p);

    const auto points = static_cast<Eigen::Index> (used.size());
    const Eigen::VectorXd weights =
        masses.size() > 0 ? Eigen::VectorXd (masses (used)) : Eigen::VectorXd::Ones (points);
    Eigen::MatrixXd shapes = modes.shapes (used, Eigen::all);
    Eigen::MatrixXd triangle = Eigen::MatrixXd::Identity (modes.modes(), modes.modes());

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto length = std::sqrt (shapes.col (k).cwiseAbs2().dot (weights));

        for (Eigen::Index l = 0; l < k; ++l)
        {
            const auto square = shapes.col (l).cwiseAbs2().dot (weights);
            triangle (l, k) = shapes.col (l).cwiseProduct (weights).dot (shapes.col (k)) / std::max (square, 1e-300);
            shapes.col (k) -= triangle (l, k) * shapes.col (l);
        }

        triangle (k, k) = std::sqrt (shapes.col (k).cwiseAbs2().dot (weights)) / std::max (length, 1e-300);
        shapes.col (k) /= std::max (triangle (k, k), 1e-300);
    }

    modes.shapes (used, Eigen::all) = shapes;
    modes.participation = triangle * modes.participation;
}
} // namespace antinode
