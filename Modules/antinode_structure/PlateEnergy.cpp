#include "PlateEnergy.h"

#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussLegendre.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** The splines of an axis at Gauss's places of some of its cells, and what each place weighs. */
struct AxisSamples
{
    Eigen::MatrixXd values, slopes, curvatures; ///< Places x splines.
    Eigen::VectorXd weights;
};

AxisSamples sampleAxis (const SplineAxis& axis, Eigen::Index beginCell, Eigen::Index endCell)
{
    const auto rule = gaussLegendre (axis.degree() + 1, 1);
    const auto perCell = rule.nodes.size();
    Eigen::VectorXd places (perCell * (endCell - beginCell)), weights (places.size());

    for (auto cell = beginCell; cell < endCell; ++cell)
    {
        const auto length = axis.cellLength (cell);
        places.segment ((cell - beginCell) * perCell, perCell) =
            (axis.cellStart (cell) + length * rule.nodes.array()).matrix();
        weights.segment ((cell - beginCell) * perCell, perCell) = length * rule.weights;
    }

    return { axis.at (places, 0), axis.at (places, 1), axis.at (places, 2), weights };
}

/** Splines of x times coefficients times splines of y for every field, each place by its weight's root: places x
    fields. */
Eigen::MatrixXd sampled (const PlateProblem& problem, const Eigen::MatrixXd& fields, const AxisSamples& x,
                         const AxisSamples& y, Eigen::MatrixXd AxisSamples::*ofX, Eigen::MatrixXd AxisSamples::*ofY)
{
    const Eigen::MatrixXd weightedX = x.weights.cwiseSqrt().asDiagonal() * x.*ofX;
    const Eigen::MatrixXd weightedY = y.weights.cwiseSqrt().asDiagonal() * y.*ofY;
    Eigen::MatrixXd samples = Eigen::MatrixXd::Zero (weightedX.rows() * weightedY.rows(), fields.cols());

    for (Eigen::Index k = 0; k < fields.cols(); ++k)
    {
        Eigen::MatrixXd half = Eigen::MatrixXd::Zero (weightedX.rows(), weightedY.cols());
        addProduct (half, 1, weightedX, problem.coefficients (fields.col (k)));
        addTransposedRight (Eigen::Map<Eigen::MatrixXd> (samples.col (k).data(), weightedX.rows(), weightedY.rows()), 1,
                            half, weightedY);
    }

    return samples;
}
} // namespace

Eigen::MatrixXd strainEnergies (const PlateDescription& plate, const PlateLayout& layout, const PlateProblem& problem,
                                const Eigen::MatrixXd& fields)
{
    Eigen::MatrixXd energies = Eigen::MatrixXd::Zero (fields.cols(), fields.cols());

    for (const auto& region : makeRegions (plate, layout, problem.x(), problem.y()))
    {
        const auto x = sampleAxis (problem.x(), region.beginX, region.endX);
        const auto y = sampleAxis (problem.y(), region.beginY, region.endY);
        const auto field = [&] (auto ofX, auto ofY) { return sampled (problem, fields, x, y, ofX, ofY); };
        const auto alongX = field (&AxisSamples::curvatures, &AxisSamples::values);
        const auto alongY = field (&AxisSamples::values, &AxisSamples::curvatures);
        const auto twist = field (&AxisSamples::slopes, &AxisSamples::slopes);
        addTransposedLeft (energies, region.section.d11, alongX, alongX);
        addTransposedLeft (energies, region.section.d22, alongY, alongY);
        addTransposedLeft (energies, region.section.d12, alongX, alongY);
        addTransposedLeft (energies, region.section.d12, alongY, alongX);
        addTransposedLeft (energies, 4 * region.section.d66, twist, twist);
    }

    return energies;
}

double stiffnessRounding (const PlateProblem& problem)
{
    double smallest = 1;

    for (const auto* const axis : { &problem.x(), &problem.y() })
        for (Eigen::Index cell = 0; cell < axis->cells(); ++cell)
            smallest = std::min (smallest, axis->cellLength (cell));

    // An entry is about degree^4 / h^3, and what a smooth field leaves of the sum is of the order of 1.
    return std::numeric_limits<double>::epsilon() * std::pow (problem.x().degree(), 4) / std::pow (smallest, 3);
}
} // namespace antinode
