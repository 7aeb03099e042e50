#include "ImmersedSpace.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
void findSplines (const SplineAxis& axis, std::vector<Eigen::Index>& first, std::vector<Eigen::Index>& count)
{
    const Eigen::VectorXd none (0);

    for (Eigen::Index cell = 0; cell < axis.cells(); ++cell)
    {
        const auto splines = axis.onCell (cell, none, 0);
        first.push_back (splines.first);
        count.push_back (splines.values.cols());
    }
}

template <typename Value>
const Value& at (const std::vector<Value>& values, Eigen::Index index)
{
    return values[static_cast<std::size_t> (index)];
}

/** A straight kink through and beyond the pieces of its edge. */
std::vector<PathPiece> extendedLines (const BendingPatch& patch, const KinkFunction& kink)
{
    if (kink.curvature != 0)
        return {};

    for (const auto& path : patch.outline.paths)
        for (const auto& piece : path)
            if (piece.edge == kink.edge)
            {
                constexpr double beyond = 100; // Of its length: farther than any spline near it reaches.
                return { linePiece (piece.start - beyond * piece.cosine, piece.end + beyond * piece.cosine, 0) };
            }

    return {};
}

std::vector<const Outline*> outlinesOf (const BendingProblem& problem)
{
    std::vector<const Outline*> outlines;

    for (const auto& patch : problem.patches)
        outlines.push_back (&patch.outline);

    return outlines;
}

/** Whether a kink's function is 0 all over a cell through which its edge does not pass: it lies outside. */
bool isOutside (const KinkFunction& kink, const CellExtent& cell)
{
    for (const auto x : { cell.left, cell.right })
        for (const auto y : { cell.bottom, cell.top })
            if (kink ({ x, y }) > 0)
                return false;

    return true;
}
} // namespace

ImmersedSpace::ImmersedSpace (const BendingProblem& problem, const SplineBreaks& breaksX, const SplineBreaks& breaksY,
                              int degree)
    : axisX (breaksX, degree), axisY (breaksY, degree), outerIsX (axisX.size() >= axisY.size())
{
    findSplines (axisX, firstX, countX);
    findSplines (axisY, firstY, countY);
    findKinks (problem);
    findCells (problem);
    numberUnknowns (problem);
}

CellExtent ImmersedSpace::extent (Eigen::Index column, Eigen::Index row) const
{
    const auto left = axisX.cellStart (column), bottom = axisY.cellStart (row);
    return { left, left + axisX.cellLength (column), bottom, bottom + axisY.cellLength (row) };
}

void ImmersedSpace::findKinks (const BendingProblem& problem)
{
    const auto products = static_cast<std::size_t> (axisX.size() * axisY.size());

    for (std::size_t p = 0; p < problem.patches.size(); ++p)
        for (const auto& kink : problem.patches[p].kinks)
        {
            if (kink.isAlongAxis())
                continue; // The splines bend there.

            KinkFamily family { p, kink, extendedLines (problem.patches[p], kink),
                                std::vector<Eigen::Index> (products, -1) };

            for (Eigen::Index row = 0; row < axisY.cells(); ++row)
                for (Eigen::Index column = 0; column < axisX.cells(); ++column)
                {
                    const auto cell = extent (column, row);
                    const auto isNear = [&] (const PathPiece& piece)
                    { return piece.edge == kink.edge && passesThrough (piece, cell); };
                    const auto& paths = problem.patches[p].outline.paths;

                    if (std::none_of (paths.begin(), paths.end(),
                                      [&] (const ClosedPath& path)
                                      { return std::any_of (path.begin(), path.end(), isNear); }))
                        continue;

                    forProducts ({ column, row }, [&] (std::size_t product) { family.unknownOf[product] = 0; });
                }

            families.push_back (std::move (family));
        }
}

bool ImmersedSpace::livesOn (const KinkFamily& family, const ImmersedCell& cell) const
{
    auto isHere = false;
    forProducts (cell, [&] (std::size_t product) { isHere = isHere || family.unknownOf[product] >= 0; });
    return isHere;
}

void ImmersedSpace::findCells (const BendingProblem& problem)
{
    const PlaneCutter cutter (problem.outline, outlinesOf (problem));
    cellNumber.assign (static_cast<std::size_t> (axisX.cells() * axisY.cells()), -1);

    for (Eigen::Index row = 0; row < axisY.cells(); ++row)
        for (Eigen::Index column = 0; column < axisX.cells(); ++column)
        {
            ImmersedCell cell { column, row };
            const auto place = extent (column, row);
            auto degree = axisX.degree();
            std::vector<PathPiece> lines;

            const auto isCrossed = cutter.cuts (place);

            for (const auto& family : families)
                if (livesOn (family, cell) && (isCrossed || ! isOutside (family.kink, place)))
                {
                    degree = std::max (degree, axisX.degree() + (family.kink.curvature == 0 ? 2 : 4));
                    lines.insert (lines.end(), family.lines.begin(), family.lines.end());
                }

            if (isCrossed || degree > axisX.degree())
            {
                checkWatch();
                cell.kind = CellKind::cut;
                cell.points = cutter.points (place, degree, lines);
            }
            else
            {
                // A whole cell may lie on a patch: one place says what is there.
                cell.points = cutter.points (place, 0, {});
            }

            if (cell.points.places.empty())
                continue;

            cellNumber[static_cast<std::size_t> (column + row * axisX.cells())] =
                static_cast<Eigen::Index> (activeCells.size());
            activeCells.push_back (std::move (cell));
        }
}

std::vector<double> ImmersedSpace::squares (const KinkFamily* family) const
{
    std::vector<double> sums (static_cast<std::size_t> (axisX.size() * axisY.size()), 0);

    for (const auto& cell : activeCells)
    {
        const auto area = extent (cell.column, cell.row).area();

        if (cell.kind == CellKind::whole)
        {
            if (family == nullptr)
                forProducts (cell, [&] (std::size_t product) { sums[product] += area; });

            continue;
        }

        if (family != nullptr && ! livesOn (*family, cell))
            continue;

        const auto number = static_cast<Eigen::Index> (cell.points.places.size());
        Eigen::VectorXd x (number), y (number), weights (number);

        for (Eigen::Index q = 0; q < number; ++q)
        {
            const auto& place = at (cell.points.places, q);
            const auto kink = family == nullptr ? 1.0 : std::max (0.0, family->kink (place)) / family->kink.width;
            x[q] = place.x();
            y[q] = place.y();
            weights[q] = at (cell.points.weights, q) * std::pow (kink, 4);
        }

        const Eigen::MatrixXd ofX = axisX.onCell (cell.column, x, 0).values.cwiseAbs2();
        const Eigen::MatrixXd ofY = weights.asDiagonal() * axisY.onCell (cell.row, y, 0).values.cwiseAbs2();
        const Eigen::MatrixXd both = ofX.transpose().lazyProduct (ofY);
        Eigen::Index next = 0;
        forProducts (cell, [&] (std::size_t product) { sums[product] += both.data()[next++]; });
    }

    return sums;
}

std::vector<bool> ImmersedSpace::productsOnHeldEdges (const BendingProblem& problem) const
{
    std::vector<bool> result (static_cast<std::size_t> (axisX.size() * axisY.size()), false);

    for (const auto& cell : activeCells)
    {
        if (cell.kind == CellKind::whole)
            continue;

        const auto place = extent (cell.column, cell.row);
        const auto isHeldHere = [&] (const PathPiece& piece)
        {
            const auto& support = problem.edges[static_cast<std::size_t> (piece.edge)];
            return (support.holdsDisplacement || support.holdsSlope) && passesThrough (piece, place);
        };

        for (const auto& path : problem.outline.paths)
            if (std::any_of (path.begin(), path.end(), isHeldHere))
                forProducts (cell, [&] (std::size_t product) { result[product] = true; });
    }

    return result;
}

void ImmersedSpace::numberUnknowns (const BendingProblem& problem)
{
    // A function with less than this of a cell changes nothing and only costs digits; with more, rigid motions would
    // suffer. On an edge that is held, where hardly anything moves, more can be left out, and must be: the terms that
    // hold the edge would make the stiffness indefinite.
    constexpr double negligible = 1e-26, negligibleOnHeldEdge = 1e-14;
    const auto onHeldEdge = productsOnHeldEdges (problem);
    unknownOf.assign (static_cast<std::size_t> (axisX.size() * axisY.size()), 0);
    std::vector<std::vector<Eigen::Index>*> kinds { &unknownOf };

    for (auto& family : families)
        kinds.push_back (&family.unknownOf);

    double most = 0;

    for (std::size_t k = 0; k < kinds.size(); ++k)
    {
        auto& numbers = *kinds[k];
        const auto sums = squares (k == 0 ? nullptr : &families[k - 1]);

        if (k == 0)
            most = *std::max_element (sums.begin(), sums.end());

        for (std::size_t product = 0; product < numbers.size(); ++product)
            if (! (sums[product] > most * (onHeldEdge[product] ? negligibleOnHeldEdge : negligible)))
                numbers[product] = -1;
    }

    const auto& outer = outerIsX ? axisX : axisY;
    const auto& inner = outerIsX ? axisY : axisX;

    for (Eigen::Index o = 0; o < outer.size(); ++o)
    {
        const auto begin = count;

        for (auto* numbers : kinds)
            for (Eigen::Index i = 0; i < inner.size(); ++i)
                if (auto& number =
                        (*numbers)[static_cast<std::size_t> (outerIsX ? tensorIndex (o, i) : tensorIndex (i, o))];
                    number >= 0)
                    number = count++;

        blockSizes.push_back (count - begin);
    }
}

BlockBandedMatrix ImmersedSpace::zeroMatrix() const
{
    const auto& outer = outerIsX ? axisX : axisY;
    std::vector<Eigen::Index> reach;

    for (Eigen::Index o = 0; o < outer.size(); ++o)
        reach.push_back (outer.lastNeighbour (o));

    return { blockSizes, reach };
}
} // namespace antinode
