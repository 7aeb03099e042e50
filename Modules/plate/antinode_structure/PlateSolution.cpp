#include "PlateSolution.h"

#include "DeviceDescription.h"
#include "ElementChain.h"
#include "PlateWaves.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

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

namespace
{
/** Eigenvalues are in units of D / (m L^4) of the bare substrate and the longer side. */
double eigenvalueUnit (const PlateDescription& plate, const PlateLayout& layout)
{
    const auto bare = bareSection (plate.common);
    return bare.d11 / bare.massPerArea / std::pow (layout.unit, 4);
}

/** Rigid motions that the edges allow: all three of a free plate, the rotation about a single supported edge, else
    none. */
int rigidBodyModes (const PlateDescription& plate)
{
    const std::array edges { plate.left, plate.right, plate.bottom, plate.top };
    const auto free = std::count (edges.begin(), edges.end(), EdgeCondition::free);
    const auto supported = std::count (edges.begin(), edges.end(), EdgeCondition::simplySupported);
    return free == 4 ? 3 : free == 3 && supported == 1 ? 1 : 0;
}

/** From the finest down: where lines crowd, cells are small anyway, and splines of less degree do. */
PlateProblem affordableProblem (const PlateDescription& plate, const PlateLayout& layout, double waveNumber)
{
    constexpr Eigen::Index comfortable = 25000, maximum = 70000; // unknowns
    const auto wavelength = 2 * std::numbers::pi / (waveNumber * layout.unit);
    const std::array resolutions { PlateResolution { 5, 0.4 * wavelength, 2, 0.25 },
                                   PlateResolution { 5, 0.4 * wavelength, 1, 0.2 },
                                   PlateResolution { 4, 0.3 * wavelength, 1, 0.25 },
                                   PlateResolution { 3, 0.25 * wavelength, 0, 0.25 } };

    for (const auto& resolution : resolutions)
    {
        const auto unknowns = expectedUnknowns (plate, layout, resolution);

        if (unknowns <= comfortable || (&resolution == &resolutions.back() && unknowns <= maximum))
            return plateProblem (plate, layout, resolution);
    }

    throw InputError ("device", "needs more than " + std::to_string (maximum)
                                    + " unknowns; choose fewer modes, align the ceramics, or use fewer of them");
}

/** How many flexible modes lie below a frequency, by inertia. */
int modesBelow (const PlateDescription& plate, const PlateLayout& layout, double frequency)
{
    const auto angularFrequency = 2 * std::numbers::pi * frequency;
    const auto lowest = angularFrequencyAt (plate.common, expectedWaveNumber (plate, 2));
    const auto waveNumber = largestWaveNumberAt (plate.common, std::max (angularFrequency, lowest));
    const auto tooMany = "maximum frequency is " + std::to_string (frequency) + " Hz; allowed: above 0 Hz, with up to "
                         + std::to_string (maximumPlateModes) + " modes below it";

    if (! (waveNumberAt (plate.common, angularFrequency) <= 2 * expectedWaveNumber (plate, maximumPlateModes)))
        throw InputError ("device", tooMany);

    const auto problem = affordableProblem (plate, layout, waveNumber);
    const auto below = eigenvaluesBelow (problem, angularFrequency * angularFrequency / eigenvalueUnit (plate, layout));
    const auto count = static_cast<int> (below.value_or (0)) - rigidBodyModes (plate);

    if (count < 1)
        throw InputError ("device", "has no mode up to its maximum frequency; choose a higher frequency");

    if (count > maximumPlateModes)
        throw InputError ("device", tooMany);

    return count;
}

int wantedCount (const PlateDescription& plate, const PlateLayout& layout, std::optional<int> argument)
{
    const auto given = argument ? argument : plate.common.modeCount;

    if (! given && plate.common.maximumFrequency)
        return modesBelow (plate, layout, *plate.common.maximumFrequency);

    requirePlateModes (given.value_or (defaultPlateModes));
    return given.value_or (defaultPlateModes);
}

Eigen::MatrixXd innerProducts (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero (a.cols(), b.cols());
    addTransposedLeft (products, 1, a, b);
    return products;
}

/** Replaces the lowest pairs, which rounding in the operator reaches, by Ritz's in the space of them, from strain
    energies. */
void sharpen (Eigenpairs& pairs, const PlateDescription& plate, const PlateLayout& layout, const PlateProblem& problem)
{
    constexpr double wanted = 1e-8;
    constexpr Eigen::Index maximum = 24; // The eigenvalues grow with the square of their number, and rounding does not.
    const auto limit = stiffnessRounding (problem) / wanted;
    const auto low = std::min ((pairs.values.array() < limit).count(), maximum);

    if (low == 0)
        return;

    const Eigen::MatrixXd fields = pairs.vectors.leftCols (low);
    const auto ritz = symmetricEigen (strainEnergies (plate, layout, problem, fields));
    pairs.values.head (low) = ritz.values;
    pairs.vectors.leftCols (low) = fields * ritz.vectors;

    // The last of them may come to lie above the next one.
    for (Eigen::Index k = 1; k < pairs.values.size(); ++k)
        pairs.values[k] = std::max (pairs.values[k], pairs.values[k - 1]);
}

/** What splines of one degree less give: one step of inverse iteration from the finer modes, and Ritz's pairs in the
   space that it spans. */
Eigenpairs coarserPairs (const PlateDescription& plate, const PlateLayout& layout, const PlateProblem& fine,
                         const Eigenpairs& pairs)
{
    constexpr double shift = -1;
    const auto coarse = plateProblem (plate, layout, fine.x().withDegree (fine.x().degree() - 1),
                                      fine.y().withDegree (fine.y().degree() - 1));
    const auto factor = factorShifted (coarse.stiffness, coarse.mass, shift, coarse.outer);
    const auto loads = massBetween (plate, layout, coarse, fine) (pairs.vectors);
    auto vectors = loads;
    factor.solveInPlace (vectors);

    // (K - shift M) v = load, so that v' load is the projected operator: of it and v' M v the eigenvalues.
    const auto inverse =
        generalizedEigen (innerProducts (vectors, coarse.mass (vectors)), innerProducts (vectors, loads));

    if (! inverse)
        throwNumbersTooFarApart();

    const Eigen::VectorXd inverses = inverse->values.reverse();
    const Eigen::MatrixXd turn = inverse->vectors.rowwise().reverse();
    Eigenpairs result { (shift + inverses.array().inverse()).matrix(),
                        Eigen::MatrixXd::Zero (vectors.rows(), turn.cols()) };
    addProduct (result.vectors, 1, vectors, turn * inverses.cwiseSqrt().cwiseInverse().asDiagonal());
    sharpen (result, plate, layout, coarse);
    return result;
}

Eigenpairs flexiblePairs (const PlateDescription& plate, const PlateLayout& layout, const PlateProblem& problem,
                          int count)
{
    const auto rigid = rigidBodyModes (plate);
    const auto all = solve (problem, rigid + count);
    Eigenpairs pairs { all.values.tail (count), all.vectors.rightCols (count) };

    // A rigid motion whose frequency is not negligible relative to the first flexible mode is rounding that spoils this
    // one, too.
    constexpr double negligible = 0.03;

    if (! all.values.allFinite() || ! (pairs.values[0] > 0)
        || (rigid > 0 && all.values.head (rigid).cwiseAbs().maxCoeff() > negligible * pairs.values[0]))
        throwNumbersTooFarApart();

    sharpen (pairs, plate, layout, problem);
    return pairs;
}

/** Where a ceramic lies on an axis; it may begin and end inside cells. */
struct CeramicExtent
{
    const SplineAxis& axis;
    double from, to;

    /** The integrals of a derivative of the splines over it. @param weight  in them; none: 1 */
    Eigen::VectorXd integrals (int derivative, const AxisWeight& weight) const
    {
        // A weight that builds up over a part of a cell needs more places than splines alone.
        const auto rule = gaussLegendre (weight ? axis.degree() + 3 : axis.degree() / 2 + 1, 1);
        Eigen::VectorXd sum = Eigen::VectorXd::Zero (axis.size());

        for (auto cell = axis.cellAt (from); cell < axis.cells() && axis.cellStart (cell) < to; ++cell)
        {
            const auto begin = std::max (from, axis.cellStart (cell));
            const auto length = std::min (to, axis.cellStart (cell) + axis.cellLength (cell)) - begin;
            const Eigen::VectorXd places = (begin + length * rule.nodes.array()).matrix();
            Eigen::VectorXd weights = length * rule.weights;

            if (weight)
                weights.array() *= places.unaryExpr (weight).array();

            const auto some = axis.onCell (cell, places, derivative);
            sum.segment (some.first, some.values.cols()) += some.values.transpose() * weights;
        }

        return sum;
    }

    /** How much the slopes of the splines change over it. */
    Eigen::VectorXd slopeChanges() const
    {
        const auto slopes = axis.at (Eigen::Vector2d (from, to), 1);
        return (slopes.row (1) - slopes.row (0)).transpose();
    }
};

PlateSolution solutionFor (const PlateDescription& plate, const PlateLayout& layout, int count, double waveNumber)
{
    const auto problem = affordableProblem (plate, layout, waveNumber);
    const auto pairs = flexiblePairs (plate, layout, problem, count);
    const auto coarser = coarserPairs (plate, layout, problem, pairs).values;
    const Eigen::VectorXd errors =
        (coarser.cwiseQuotient (pairs.values).cwiseSqrt().array() - 1).abs().max (1e-12).matrix();

    // A real solution is never so coarse; numbers that are far apart make it noise.
    if (! (errors.maxCoeff() < 0.1))
        throwNumbersTooFarApart();

    const Eigen::VectorXd angularFrequencies = (pairs.values * eigenvalueUnit (plate, layout)).cwiseSqrt();
    const auto massScale = std::sqrt (bareSection (plate.common).massPerArea) * layout.unit;
    return { layout,
             problem,
             rigidBodyModes (plate),
             angularFrequencies,
             pairs.vectors / massScale,
             errors,
             largestWaveNumberAt (plate.common, angularFrequencies[count - 1]) };
}
} // namespace

PlateSolution solvePlateModes (const PlateDescription& plate, std::optional<int> modeCount)
{
    const auto layout = makeLayout (plate);
    const auto count = wantedCount (plate, layout, modeCount);
    constexpr int resolvedModes = 50; // At least: then few modes are right to many digits, and still cost little.
    const auto expected = expectedWaveNumber (plate, std::max (count, resolvedModes));
    auto waveNumber = largestWaveNumberAt (plate.common, angularFrequencyAt (plate.common, expected));

    for (;;)
    {
        auto solution = solutionFor (plate, layout, count, waveNumber);
        constexpr double excused = 1.15; // Cells are small enough for that.

        if (solution.waveNumber <= excused * waveNumber)
            return solution;

        waveNumber = solution.waveNumber;
    }
}

Eigen::VectorXd ceramicLoad (const PlateProblem& problem, const StructureCommon& common,
                             const CeramicDescription& ceramic, double unit)
{
    const auto bond = ceramicBond (common, ceramic, 0);
    const auto section = bond ? alongAxes (bond->loose) : ceramicSection (common, ceramic);
    const CeramicExtent x { problem.x(), ceramic.x / unit, (ceramic.x + ceramic.sizeX) / unit };
    const CeramicExtent y { problem.y(), ceramic.y / unit, (ceramic.y + ceramic.sizeY) / unit };
    Eigen::MatrixXd load = section.momentX * x.slopeChanges() * y.integrals (0, {}).transpose()
                           + section.momentY * x.integrals (0, {}) * y.slopeChanges().transpose();

    if (bond)
    {
        const auto part = scaledPart (bond->part, unit, 1);
        const auto parts = BondedStiffness::of (part.stiffness);
        const auto shareOf = [&part] (Eigen::Index side) -> AxisWeight
        { return [&part, side] (double place) { return part.shareAlong (side, place, part.lengths); }; };
        const auto shareX = shareOf (0), shareY = shareOf (1);
        const auto& free = part.curvaturePerVolt;
        load += x.integrals (2, shareX)
                * (parts.first * free[0] * y.integrals (0, {})
                   + (parts.bothFirst * free[0] + parts.coupling * free[1]) * y.integrals (0, shareY))
                      .transpose();
        load += (parts.second * free[1] * x.integrals (0, {})
                 + (parts.bothSecond * free[1] + parts.coupling * free[0]) * x.integrals (0, shareX))
                * y.integrals (2, shareY).transpose();
    }

    return problem.field (load);
}
} // namespace antinode
