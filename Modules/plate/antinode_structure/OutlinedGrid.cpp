#include "OutlinedGrid.h"

#include "BendingModes.h"
#include "SolvedPlate.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double largestPhase = 3;         // rad, of a wave over a cell: fewest places for 1e-5
constexpr double largestPhaseKinked = 1.2; // where edges of ceramics bend the plate within cells

double coordinate (const Eigen::Vector2d& place, PlaneAxis axis)
{
    return axis == PlaneAxis::x ? place.x() : place.y();
}

/** Straight pieces that cells can end on. */
void addAligned (std::vector<double>& lines, const Outline& outline, PlaneAxis axis)
{
    for (const auto& path : outline.paths)
        for (const auto& piece : path)
            if (piece.isStraight && coordinate (piece.start, axis) == coordinate (piece.end, axis))
                lines.push_back (coordinate (piece.start, axis));
}

/** Whether an outline has a side that no line of a grid follows. */
bool isKinked (const BendingPatch& patch)
{
    return std::any_of (patch.kinks.begin(), patch.kinks.end(),
                        [] (const KinkFunction& kink) { return ! kink.isAlongAxis(); });
}

/** Cells shrink towards holes and hollow arcs, around which fields vary faster than waves do. */
void addHollows (std::vector<SmallCells>& small, const Outline& outline, PlaneAxis axis)
{
    constexpr double growth = 0.5;

    for (const auto& path : outline.paths)
        for (const auto& piece : path)
        {
            const auto orientation = piece.cosine.x() * piece.sine.y() - piece.cosine.y() * piece.sine.x();
            const auto isHollow =
                ! piece.isStraight && insideAtLeft (outline, path) * orientation * (piece.to - piece.from) < 0;

            if (! isHollow)
                continue;

            const auto reach = std::hypot (coordinate (piece.cosine, axis), coordinate (piece.sine, axis));

            for (const auto side : { -1, 1 })
                small.push_back ({ coordinate (piece.centre, axis) + side * reach, reach, growth, 0 });
        }
}

GridAxis makeAxis (const BendingProblem& problem, PlaneAxis axis, double waveNumber)
{
    const auto extent = extentOf (problem.outline);
    const auto from = coordinate (extent.least, axis), to = coordinate (extent.largest, axis);
    const auto isAnyKinked = std::any_of (problem.patches.begin(), problem.patches.end(), isKinked);
    const auto cell = (isAnyKinked ? largestPhaseKinked : largestPhase) / waveNumber;
    std::vector<double> lines;
    addAligned (lines, problem.outline, axis);

    for (const auto& patch : problem.patches)
        addAligned (lines, patch.outline, axis);

    std::sort (lines.begin(), lines.end());
    std::vector<SmallCells> small;
    constexpr double nearest = 1e-3; // Closer lines are not worth cells of their own: they cut them.
    auto last = from;

    for (const auto line : lines)
        if (line > last + nearest && line < to - nearest)
        {
            small.push_back ({ line, cell, 1, 1 });
            last = line;
        }

    addHollows (small, problem.outline, axis);
    const auto breaks = breaksBetween (from, to, cell, small);
    constexpr int fewestPlaces = 5;
    Eigen::VectorXi counts (breaks.places.size() - 1);

    for (Eigen::Index s = 0; s < counts.size(); ++s)
        counts[s] = placesForPhase (waveNumber * (breaks.places[s + 1] - breaks.places[s]), fewestPlaces);

    return gridAxis (breaks.places, counts);
}

std::vector<const Outline*> patchOutlines (const BendingProblem& problem)
{
    std::vector<const Outline*> outlines;

    for (const auto& patch : problem.patches)
        outlines.push_back (&patch.outline);

    return outlines;
}

/** Legendre's polynomials at places between -1 and 1: one column per degree. */
Eigen::MatrixXd legendre (const Eigen::ArrayXd& at, Eigen::Index count)
{
    Eigen::MatrixXd values = Eigen::MatrixXd::Ones (at.size(), count);

    for (Eigen::Index n = 1; n < count; ++n)
    {
        const auto k = static_cast<double> (n);
        values.col (n) = (2 * k - 1) / k * at * values.col (n - 1).array();

        if (n > 1)
            values.col (n) -= (k - 1) / k * values.col (n - 2);
    }

    return values;
}

/** What coefficients of Legendre's polynomials are at most of a wave over a segment. */
Eigen::VectorXd usualCoefficients (double halfPhase, Eigen::Index count)
{
    Eigen::VectorXd sizes (count);
    double size = 1;

    for (Eigen::Index n = 0; n < count; ++n)
    {
        sizes[n] = (2 * static_cast<double> (n) + 1) * size;
        size *= halfPhase / (2 * static_cast<double> (n) + 3);
    }

    return sizes;
}

/** A segment of an axis, with what a polynomial over it needs. */
struct Segment
{
    Eigen::Index first, count;
    double begin, length;

    Segment (const GridAxis& axis, Eigen::Index number)
        : first (axis.first[number]), count (axis.first[number + 1] - axis.first[number]), begin (axis.edges[number]),
          length (axis.edges[number + 1] - axis.edges[number])
    {
    }

    Eigen::MatrixXd polynomials (const Eigen::VectorXd& at) const
    {
        return legendre (2 * (at.array() - begin) / length - 1, count);
    }
};
} // namespace

OutlinedGrid::OutlinedGrid (const BendingProblem& problemToUse, double waveNumberToUse, ModeAccuracy accuracy)
    : problem (problemToUse), waveNumber (waveNumberToUse), axisX (makeAxis (problem, PlaneAxis::x, waveNumber)),
      axisY (makeAxis (problem, PlaneAxis::y, waveNumber))
{
    addCells (accuracy);
}

std::size_t OutlinedGrid::numberOf (const std::vector<bool>& section)
{
    const auto found = std::find (sections.begin(), sections.end(), section);
    const auto number = static_cast<std::size_t> (found - sections.begin());

    if (found == sections.end())
        sections.push_back (section);

    return number;
}

void OutlinedGrid::addCells (ModeAccuracy accuracy)
{
    constexpr int coarseDegree = 2; // Where only edges of patches cross a cell: enough for masses to some percent.
    const PlaneCutter all (problem.outline, patchOutlines (problem)), plateOnly (problem.outline, {});
    const auto gridSize = axisX.places.size() * axisY.places.size();
    std::vector<double> areas (static_cast<std::size_t> (gridSize), 0);
    std::vector<Eigen::Vector2d> more;
    const auto nothing = numberOf (std::vector<bool> (problem.patches.size(), false));
    sectionOf.assign (static_cast<std::size_t> (gridSize), nothing);

    for (Eigen::Index row = 0; row + 1 < axisY.edges.size(); ++row)
        for (Eigen::Index column = 0; column + 1 < axisX.edges.size(); ++column)
        {
            checkWatch();
            const CellExtent extent { axisX.edges[column], axisX.edges[column + 1], axisY.edges[row],
                                      axisY.edges[row + 1] };
            const Segment alongX (axisX, column), alongY (axisY, row);
            const auto isCrossed = all.cuts (extent), isCut = isCrossed && plateOnly.cuts (extent);
            const auto degree = accuracy == ModeAccuracy::coarse && ! isCut
                                    ? coarseDegree
                                    : static_cast<int> (std::max (alongX.count, alongY.count)) - 1;
            const auto points = all.points (extent, isCrossed ? degree : 0, {});

            if (points.places.empty())
                continue;

            std::vector<std::size_t> numbers;

            for (const auto& section : points.sections)
                numbers.push_back (numberOf (section));

            for (auto j = alongY.first; j < alongY.first + alongY.count && ! isCut; ++j)
                for (auto i = alongX.first; i < alongX.first + alongX.count; ++i)
                {
                    const auto point = gridRow (i, j);
                    onPlate.push_back (point);

                    if (isCrossed)
                        continue;

                    areas[static_cast<std::size_t> (point)] = axisX.weights[i] * axisY.weights[j];
                    sectionOf[static_cast<std::size_t> (point)] = numbers[points.section.front()];
                }

            if (! isCrossed)
                continue;

            const auto first = gridSize + static_cast<Eigen::Index> (more.size());

            if (isCut)
                cutCells.push_back ({ column, row, first, static_cast<Eigen::Index> (points.places.size()) });

            for (std::size_t q = 0; q < points.places.size(); ++q)
            {
                onPlate.push_back (first + static_cast<Eigen::Index> (q));
                more.push_back (points.places[q]);
                areas.push_back (points.weights[q]);
                sectionOf.push_back (numbers[points.section[q]]);
            }
        }

    for (const auto& point : problem.points)
    {
        onPlate.push_back (gridSize + static_cast<Eigen::Index> (more.size()));
        more.push_back (point.place);
        areas.push_back (0);
        sectionOf.push_back (nothing);
    }

    weights = Eigen::Map<const Eigen::VectorXd> (areas.data(), static_cast<Eigen::Index> (areas.size()));
    places.resize (weights.size(), 2);

    for (Eigen::Index j = 0; j < axisY.places.size(); ++j)
        for (Eigen::Index i = 0; i < axisX.places.size(); ++i)
            places.row (gridRow (i, j)) << axisX.places[i], axisY.places[j];

    for (std::size_t q = 0; q < more.size(); ++q)
        places.row (gridSize + static_cast<Eigen::Index> (q)) = more[q].transpose();
}

Eigen::VectorXd OutlinedGrid::masses() const
{
    Eigen::VectorXd result = weights;

    for (Eigen::Index p = 0; p < result.size(); ++p)
    {
        auto massPerArea = problem.section.massPerArea;
        const auto& isOn = patchesAt (p);

        for (std::size_t i = 0; i < isOn.size(); ++i)
            massPerArea += isOn[i] ? problem.patches[i].added.massPerArea : 0;

        result[p] *= massPerArea;
    }

    const auto number = static_cast<Eigen::Index> (problem.points.size());

    for (Eigen::Index i = 0; i < number; ++i)
        result[result.size() - number + i] = problem.points[static_cast<std::size_t> (i)].mass;

    return result;
}

void OutlinedGrid::extend (Eigen::MatrixXd& shapes, const CutCell& cell) const
{
    // Of all polynomials that are as smooth as waves the one that is nearest to the shapes on the plate.
    constexpr double least = 1e-3;
    const auto amplitude = 10 / std::sqrt (areaOf (problem.outline));
    const Segment alongX (axisX, cell.column), alongY (axisY, cell.row);
    const auto sizesX = usualCoefficients (waveNumber * alongX.length / 2, alongX.count);
    const auto sizesY = usualCoefficients (waveNumber * alongY.length / 2, alongY.count);
    const Eigen::MatrixXd ofX = alongX.polynomials (places.col (0).segment (cell.first, cell.count));
    const Eigen::MatrixXd ofY = alongY.polynomials (places.col (1).segment (cell.first, cell.count));
    const Eigen::MatrixXd nodesX = alongX.polynomials (axisX.places.segment (alongX.first, alongX.count));
    const Eigen::MatrixXd nodesY = alongY.polynomials (axisY.places.segment (alongY.first, alongY.count));
    const auto terms = alongX.count * alongY.count;
    Eigen::MatrixXd samples (terms, cell.count), nodes (terms, terms);

    for (Eigen::Index b = 0; b < alongY.count; ++b)
        for (Eigen::Index a = 0; a < alongX.count; ++a)
        {
            const auto term = a + b * alongX.count;
            const auto size = amplitude * std::max (least, sizesX[a] * sizesY[b]);
            samples.row (term) = size * ofX.col (a).cwiseProduct (ofY.col (b)).transpose();
            nodes.col (term) = size * (nodesX.col (a) * nodesY.col (b).transpose()).reshaped();
        }

    // More than rounding leaves of the sum, so that it can be factored: 1e-5 of the amplitude.
    constexpr double tolerance = 1e-13;
    Eigen::MatrixXd system = tolerance * samples.squaredNorm() * Eigen::MatrixXd::Identity (terms, terms);
    addGram (system, 1, samples);

    if (! factorLower (system))
        throw InputError ("device",
                          "has an outline that leaves too little of a cell; change it or the number of modes a little");

    Eigen::MatrixXd right = Eigen::MatrixXd::Zero (terms, shapes.cols());
    addProduct (right, 1, samples, shapes.middleRows (cell.first, cell.count));
    const Eigen::MatrixXd values = nodes * solveFactored (system, std::move (right));

    for (Eigen::Index j = 0; j < alongY.count; ++j)
        shapes.middleRows (gridRow (alongX.first, alongY.first + j), alongX.count) =
            values.middleRows (j * alongX.count, alongX.count);
}

Eigen::MatrixXd OutlinedGrid::shapes (const BendingModes& modes) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (places.rows(), modes.coefficients.cols());
    result (onPlate, Eigen::all) = modes.space.evaluate (places (onPlate, Eigen::all), modes.coefficients, 0, 0);

    for (const auto& cell : cutCells)
        extend (result, cell);

    return result;
}

namespace
{
/** Twice the energy that is lost of foundations: integral loss k w^2. */
Eigen::VectorXd lostInFoundations (const OutlinedPlate& plate, const OutlinedProblem& scaled, const OutlinedGrid& grid,
                                   const Eigen::MatrixXd& shapes)
{
    const auto ceramicPatches = scaled.ceramicOfPatch.size();
    Eigen::VectorXd losses = Eigen::VectorXd::Zero (shapes.rows());

    for (Eigen::Index p = 0; p < losses.size(); ++p)
    {
        if (! (grid.areas()[p] > 0))
            continue;

        losses[p] = scaled.problem.foundation * plate.foundationLoss;
        const auto& isOn = grid.patchesAt (p);

        for (std::size_t a = 0; a < plate.areas.size(); ++a)
            if (isOn[ceramicPatches + a])
                losses[p] += scaled.problem.patches[ceramicPatches + a].foundation * plate.areas[a].lossFactor;
    }

    if (! losses.any())
        return Eigen::VectorXd::Zero (shapes.cols());

    return shapes.cwiseAbs2().transpose() * losses.cwiseProduct (grid.areas());
}

/** The same of springs along a piece of the boundary. */
Eigen::VectorXd lostAlong (const PathPiece& piece, const EdgeSupport& support, const BendingModes& modes,
                           double waveNumber)
{
    constexpr int places = 8;
    const auto rule = gaussLegendre (places, 1);
    const auto parts = std::max (1, static_cast<int> (std::ceil (waveNumber * piece.length (piece.from, piece.to))));
    const auto step = (piece.to - piece.from) / parts;
    Eigen::MatrixX2d at (parts * places, 2), normals (parts * places, 2);
    Eigen::VectorXd weights (parts * places);

    for (int i = 0; i < parts * places; ++i)
    {
        const auto part = i / places;
        const auto t = piece.from + step * (part + rule.nodes[i % places]);
        const auto derivative = piece.derivative (t);
        at.row (i) = piece.at (t).transpose();
        normals.row (i) << derivative.y() / derivative.norm(), -derivative.x() / derivative.norm();
        weights[i] = std::abs (step) * derivative.norm() * rule.weights[i % places];
    }

    const auto& [space, eigenvalues, coefficients, participation, rigid] = modes;
    Eigen::VectorXd lost =
        support.translation * space.evaluate (at, coefficients, 0, 0).cwiseAbs2().transpose() * weights;

    if (support.rotation > 0)
    {
        const Eigen::MatrixXd slopes = normals.col (0).asDiagonal() * space.evaluate (at, coefficients, 1, 0)
                                       + normals.col (1).asDiagonal() * space.evaluate (at, coefficients, 0, 1);
        lost += support.rotation * slopes.cwiseAbs2().transpose() * weights;
    }

    return lost;
}
} // namespace

Eigen::VectorXd dampingOfSupports (const OutlinedPlate& plate, const OutlinedSolution& solution,
                                   const OutlinedGrid& grid, const Eigen::MatrixXd& shapes)
{
    const auto& scaled = solution.scaled;
    const auto& problem = scaled.problem;
    const auto omegas = solution.modes.eigenvalues.cwiseSqrt();
    Eigen::VectorXd lost = lostInFoundations (plate, scaled, grid, shapes);
    Eigen::VectorXd dashpots = Eigen::VectorXd::Zero (lost.size());

    for (const auto& path : problem.outline.paths)
        for (const auto& piece : path)
            if (const auto edge = static_cast<std::size_t> (piece.edge); plate.edges[edge].lossFactor > 0)
                lost += plate.edges[edge].lossFactor
                        * lostAlong (piece, problem.edges[edge], solution.modes, solution.waveNumber);

    for (std::size_t i = 0; i < plate.points.size(); ++i)
    {
        const auto row = shapes.rows() - static_cast<Eigen::Index> (plate.points.size() - i);
        const Eigen::VectorXd squares = shapes.row (row).cwiseAbs2().transpose();
        lost += plate.points[i].lossFactor * problem.points[i].stiffness * squares;
        dashpots += plate.points[i].damping * squares;
    }

    // A dashpot in units of the problem: mass per area times length squared times the unit of frequency.
    const auto unit = scaled.massPerArea * scaled.length * scaled.length * std::sqrt (scaled.eigenvalueUnit());
    return (lost.array() / omegas.array().square() + dashpots.array() / unit / omegas.array()) / 2;
}
} // namespace antinode
