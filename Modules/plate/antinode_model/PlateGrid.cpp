#include "PlateGrid.h"

#include <antinode_numerics/GaussLegendre.h>

#include <algorithm>

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
} // namespace antinode
