#include "ChebyshevNodes.h"

#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
double nodeAngle (Eigen::Index node)
{
    return std::numbers::pi * (static_cast<double> (node) + 0.5) / static_cast<double> (smoothNodes);
}
} // namespace

Eigen::VectorXd chebyshevNodes (double centre, double halfWidth)
{
    Eigen::VectorXd result (smoothNodes);

    for (Eigen::Index j = 0; j < smoothNodes; ++j)
        result[j] = centre + halfWidth * std::cos (nodeAngle (j));

    return result;
}

Eigen::MatrixXd interpolation (const Eigen::VectorXd& at, const Eigen::VectorXd& nodes)
{
    Eigen::MatrixXd result (at.size(), smoothNodes);

    // Lagrange's polynomials in barycentric form.
    for (Eigen::Index f = 0; f < at.size(); ++f)
    {
        for (Eigen::Index j = 0; j < smoothNodes; ++j)
        {
            const auto weight = (j % 2 == 0 ? 1.0 : -1.0) * std::sin (nodeAngle (j));
            const auto distance = at[f] - nodes[j];
            result (f, j) = weight / (distance == 0 ? 1e-300 : distance);
        }

        result.row (f) /= result.row (f).sum();
    }

    return result;
}
} // namespace antinode
