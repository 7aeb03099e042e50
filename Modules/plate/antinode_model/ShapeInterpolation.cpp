#include "ShapeInterpolation.h"

#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace antinode
{
namespace
{
/** The weights of the barycentric formula for the polynomial through some places. */
Eigen::VectorXd barycentricWeights (const Eigen::VectorXd& places)
{
    // Differences are scaled to the order of 1, so that the products of many of them neither vanish nor explode.
    const auto scale = places.size() > 1 ? 4 / (places[places.size() - 1] - places[0]) : 1.0;
    Eigen::VectorXd weights (places.size());

    for (Eigen::Index i = 0; i < places.size(); ++i)
    {
        double product = 1;

        for (Eigen::Index j = 0; j < places.size(); ++j)
            if (j != i)
                product *= scale * (places[i] - places[j]);

        weights[i] = 1 / product;
    }

    return weights;
}

Eigen::Index findSegment (const GridAxis& axis, double place)
{
    const auto* const begin = axis.edges.data();
    const auto* const end = begin + axis.edges.size();
    const auto segment = std::upper_bound (begin, end, place) - begin - 1;
    return std::clamp<Eigen::Index> (segment, 0, axis.edges.size() - 2);
}
} // namespace

GridAxis gridAxis (const Eigen::VectorXd& edges, const Eigen::VectorXi& counts)
{
    GridAxis axis;
    axis.edges = edges;
    axis.first = Eigen::VectorXi::Zero (counts.size() + 1);
    axis.places.resize (counts.sum());
    axis.weights.resize (counts.sum());

    for (Eigen::Index s = 0; s < counts.size(); ++s)
    {
        const auto rule = gaussLegendre (counts[s], 1);
        const auto length = edges[s + 1] - edges[s];
        axis.first[s + 1] = axis.first[s] + counts[s];
        axis.places.segment (axis.first[s], counts[s]) = (edges[s] + length * rule.nodes.array()).matrix();
        axis.weights.segment (axis.first[s], counts[s]) = length * rule.weights;
    }

    return axis;
}

Eigen::MatrixXd interpolationRows (const GridAxis& axis, const Eigen::VectorXd& at)
{
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero (at.size(), axis.places.size());

    for (Eigen::Index i = 0; i < at.size(); ++i)
    {
        const auto segment = findSegment (axis, at[i]);
        const auto first = axis.first[segment];
        const auto count = axis.first[segment + 1] - first;
        const Eigen::VectorXd places = axis.places.segment (first, count);
        const Eigen::ArrayXd differences = at[i] - places.array();
        Eigen::Index nearest = 0;

        if (differences.abs().minCoeff (&nearest) == 0)
        {
            rows (i, first + nearest) = 1;
            continue;
        }

        const Eigen::ArrayXd terms = barycentricWeights (places).array() / differences;
        rows.row (i).segment (first, count) = (terms / terms.sum()).matrix().transpose();
    }

    return rows;
}

namespace
{
constexpr Eigen::Index thinPlateNeighbours = 48;

std::vector<Eigen::Index> nearestPoints (const Eigen::MatrixX2d& points, const Eigen::RowVector2d& place)
{
    std::vector<Eigen::Index> order (static_cast<std::size_t> (points.rows()));
    std::iota (order.begin(), order.end(), Eigen::Index { 0 });
    const auto rank = [&] (Eigen::Index i) { return std::pair ((points.row (i) - place).squaredNorm(), i); };
    const auto count = std::min<Eigen::Index> (points.rows(), thinPlateNeighbours);
    std::partial_sort (order.begin(), order.begin() + count, order.end(),
                       [&] (auto a, auto b) { return rank (a) < rank (b); });
    order.resize (static_cast<std::size_t> (count));
    return order;
}

/** r^2 ln r, from r^2. */
double thinPlateKernel (double squaredDistance)
{
    return squaredDistance > 0 ? 0.5 * squaredDistance * std::log (squaredDistance) : 0.0;
}
} // namespace

Eigen::RowVectorXd interpolateOnLine (const Eigen::VectorXd& points, const Eigen::MatrixXd& values,
                                      const Eigen::MatrixXd& slopes, double x)
{
    const auto count = points.size();
    const auto* above = std::upper_bound (points.data(), points.data() + count, x);

    if (above == points.data())
        return values.row (0);

    if (above == points.data() + count)
        return values.row (count - 1);

    const auto right = static_cast<Eigen::Index> (above - points.data());
    const auto left = right - 1;
    const auto h = points[right] - points[left];
    const auto t = (x - points[left]) / h;
    const auto u = 1 - t;
    return (1 + 2 * t) * u * u * values.row (left) + (1 + 2 * u) * t * t * values.row (right)
           + h * t * u * (u * slopes.row (left) - t * slopes.row (right));
}

Eigen::RowVectorXd slopesOnLine (const Eigen::VectorXd& points, const Eigen::MatrixXd& values,
                                 const Eigen::MatrixXd& slopes, double x)
{
    const auto count = points.size();
    const auto above = std::upper_bound (points.data(), points.data() + count, x) - points.data();
    const auto right = std::clamp<Eigen::Index> (above, 1, count - 1);
    const auto left = right - 1;
    const auto h = points[right] - points[left];
    const auto t = std::clamp ((x - points[left]) / h, 0.0, 1.0);
    const auto u = 1 - t;
    return 6 * t * u / h * (values.row (right) - values.row (left)) + u * (1 - 3 * t) * slopes.row (left)
           + t * (1 - 3 * u) * slopes.row (right);
}

Eigen::MatrixXd naturalSplineSlopes (const Eigen::VectorXd& points, const Eigen::MatrixXd& values)
{
    const auto n = points.size();

    if (n < 2)
        return Eigen::MatrixXd::Zero (n, values.cols());

    // Thomas' algorithm on the slopes' tridiagonal system; the natural ends are 2 s_0 + s_1 = 3 (y_1 - y_0) / h_0.
    Eigen::VectorXd upper (n);
    Eigen::MatrixXd slopes (n, values.cols());
    const auto secant = [&] (Eigen::Index i) -> Eigen::RowVectorXd
    { return (values.row (i + 1) - values.row (i)) / (points[i + 1] - points[i]); };
    upper[0] = 0.5;
    slopes.row (0) = 1.5 * secant (0);

    for (Eigen::Index i = 1; i < n; ++i)
    {
        const auto isLast = i == n - 1;
        const auto left = isLast ? 1.0 : 1 / (points[i] - points[i - 1]);
        const auto right = isLast ? 0.0 : 1 / (points[i + 1] - points[i]);
        const auto pivot = 2 * (left + right) - left * upper[i - 1];
        Eigen::RowVectorXd load = 3 * left * secant (i - 1);

        if (! isLast)
            load += 3 * right * secant (i);

        upper[i] = right / pivot;
        slopes.row (i) = (load - left * slopes.row (i - 1)) / pivot;
    }

    for (Eigen::Index i = n - 2; i >= 0; --i)
        slopes.row (i) -= upper[i] * slopes.row (i + 1);

    return slopes;
}

Eigen::RowVectorXd interpolateOnGrid (const PlateGrid& grid, const Eigen::MatrixXd& values, double x, double y)
{
    const auto rowX = interpolationRows (grid.x, Eigen::VectorXd::Constant (1, x));
    const auto rowY = interpolationRows (grid.y, Eigen::VectorXd::Constant (1, y));
    Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero (values.cols());

    for (Eigen::Index j = 0; j < rowY.cols(); ++j)
        for (Eigen::Index i = 0; i < rowX.cols(); ++i)
            if (rowX (0, i) != 0 && rowY (0, j) != 0)
                result += rowX (0, i) * rowY (0, j) * values.row (i + j * rowX.cols());

    return result;
}

Eigen::RowVectorXd interpolateInPlane (const Eigen::MatrixX2d& points, const Eigen::MatrixXd& values, double x,
                                       double y)
{
    const Eigen::RowVector2d place (x, y);
    const auto nearest = nearestPoints (points, place);
    const auto n = static_cast<Eigen::Index> (nearest.size());
    const auto reach = std::max ((points.row (nearest.back()) - place).norm(), 1e-12);
    const auto scaled = [&] (Eigen::Index i) -> Eigen::RowVector2d
    { return (points.row (nearest[static_cast<std::size_t> (i)]) - place) / reach; };

    Eigen::MatrixXd system = Eigen::MatrixXd::Zero (n + 3, n + 3);
    Eigen::VectorXd right = Eigen::VectorXd::Zero (n + 3);

    for (Eigen::Index i = 0; i < n; ++i)
    {
        for (Eigen::Index j = 0; j < n; ++j)
            system (i, j) = thinPlateKernel ((scaled (i) - scaled (j)).squaredNorm());

        system.row (i).tail (3) << 1, scaled (i);
        right[i] = thinPlateKernel (scaled (i).squaredNorm());
    }

    system.bottomLeftCorner (3, n) = system.topRightCorner (n, 3).transpose();
    right[n] = 1;

    // The system is symmetric, so its solution for the kernel's row at the place holds the points' weights. Few or
    // collinear points leave the plane's part undetermined: the least-squares solution of the rank-revealing QR serves
    // there too.
    const Eigen::VectorXd weights = leastSquares (system, right).head (n);
    Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero (values.cols());

    for (Eigen::Index i = 0; i < n; ++i)
        result += weights[i] * values.row (nearest[static_cast<std::size_t> (i)]);

    return result;
}
} // namespace antinode
