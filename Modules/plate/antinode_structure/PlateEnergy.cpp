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
    Eigen::VectorXd weights, places;
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

    return { axis.at (places, 0), axis.at (places, 1), axis.at (places, 2), weights, places };
}

/** The same samples, each weighed by a share. */
AxisSamples weighed (AxisSamples samples, const Eigen::VectorXd& shares)
{
    samples.weights.array() *= shares.array();
    return samples;
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

namespace
{
/** The energies of what is bonded. @param sample  fields at the places of two axes, as sampled() */
template <typename Sample>
void addBonded (Eigen::MatrixXd& energies, const BondedPart& part, const AxisSamples& x, const AxisSamples& y,
                const Sample& sample)
{
    const auto parts = BondedStiffness::of (part.stiffness);
    const auto shared = [&] (const AxisSamples& samples, Eigen::Index axis, const Eigen::Vector2d& lengths)
    {
        return weighed (
            samples, samples.places.unaryExpr ([&] (double place) { return part.shareAlong (axis, place, lengths); }));
    };
    const auto stretchedX = shared (x, 0, part.lengths), stretchedY = shared (y, 1, part.lengths);
    const auto shearedX = shared (x, 0, part.shearLengths), shearedY = shared (y, 1, part.shearLengths);
    const auto add = [&] (double factor, const Eigen::MatrixXd& one, const Eigen::MatrixXd& other)
    { addTransposedLeft (energies, factor, one, other); };
    const auto alongX = sample (stretchedX, y, &AxisSamples::curvatures, &AxisSamples::values);
    const auto alongY = sample (x, stretchedY, &AxisSamples::values, &AxisSamples::curvatures);
    const auto bothX = sample (stretchedX, stretchedY, &AxisSamples::curvatures, &AxisSamples::values);
    const auto bothY = sample (stretchedX, stretchedY, &AxisSamples::values, &AxisSamples::curvatures);
    const auto twist = sample (shearedX, shearedY, &AxisSamples::slopes, &AxisSamples::slopes);
    add (parts.first, alongX, alongX);
    add (parts.second, alongY, alongY);
    add (parts.bothFirst, bothX, bothX);
    add (parts.bothSecond, bothY, bothY);
    add (parts.coupling, bothX, bothY);
    add (parts.coupling, bothY, bothX);
    add (4 * parts.shear, twist, twist);
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

        if (region.bonded)
            addBonded (energies, *region.bonded, x, y,
                       [&] (const AxisSamples& ofX, const AxisSamples& ofY, auto onX, auto onY)
                       { return sampled (problem, fields, ofX, ofY, onX, onY); });
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
