#include "ImmersedSpace.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

namespace
{
double binomial (int n, int k)
{
    return k == 0 || k == n ? 1 : n; // Up to 3 over 1 and 2, which is all that is needed.
}
} // namespace

CellFunctions::CellFunctions (const ImmersedSpace& space, const ImmersedCell& cell,
                              const std::vector<Eigen::Vector2d>& placesToUse, int highest)
    : places (placesToUse)
{
    const auto number = static_cast<Eigen::Index> (places.size());
    Eigen::VectorXd x (number), y (number);

    for (Eigen::Index i = 0; i < number; ++i)
    {
        x[i] = places[static_cast<std::size_t> (i)].x();
        y[i] = places[static_cast<std::size_t> (i)].y();
    }

    for (int d = 0; d <= highest; ++d)
    {
        alongX.push_back (space.axisX.onCell (cell.column, x, d).values);
        alongY.push_back (space.axisY.onCell (cell.row, y, d).values);
    }

    const auto addFunctions = [&] (const std::vector<Eigen::Index>& unknownOf, const KinkFunction* kink)
    {
        for (Eigen::Index j = 0; j < space.countY[static_cast<std::size_t> (cell.row)]; ++j)
            for (Eigen::Index i = 0; i < space.countX[static_cast<std::size_t> (cell.column)]; ++i)
                if (const auto unknown = unknownOf[static_cast<std::size_t> (
                        space.tensorIndex (space.firstX[static_cast<std::size_t> (cell.column)] + i,
                                           space.firstY[static_cast<std::size_t> (cell.row)] + j))];
                    unknown >= 0)
                {
                    members.push_back ({ i, j, kink });
                    numbers.push_back (unknown);
                }
    };

    addFunctions (space.unknownOf, nullptr);

    // Where a kink's function is 0, all that it is a factor of are.
    for (const auto& family : space.families)
        if (std::any_of (places.begin(), places.end(),
                         [&] (const Eigen::Vector2d& place) { return family.kink (place) > 0; }))
            addFunctions (family.unknownOf, &family.kink);
}

Eigen::VectorXd CellFunctions::kinkDerivative (const KinkFunction& kink, int dx, int dy) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero (static_cast<Eigen::Index> (places.size()));

    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const Eigen::Vector2d offset = places[i] - kink.centre;
        const auto s = kink (places[i]);

        if (s <= 0)
            continue;

        // Of s^2, whose second derivatives are the same along x and y, and 0 across.
        const Eigen::Vector2d slope = kink.gradient + kink.curvature * offset;
        const auto along = dx >= dy ? slope.x() : slope.y(), across = dx >= dy ? slope.y() : slope.x();
        const auto most = std::max (dx, dy), least = std::min (dx, dy);
        const auto value = most == 0                 ? s * s
                           : most == 1 && least == 0 ? 2 * s * along
                           : most == 1               ? 2 * along * across
                           : most == 2 && least == 0 ? 2 * (along * along + s * kink.curvature)
                           : most == 2 && least == 1 ? 2 * across * kink.curvature
                           : most == 3 && least == 0 ? 6 * along * kink.curvature
                                                     : 0;
        result[static_cast<Eigen::Index> (i)] = value;
    }

    return result;
}

Eigen::MatrixXd CellFunctions::derivative (int dx, int dy) const
{
    Eigen::MatrixXd result (static_cast<Eigen::Index> (places.size()), static_cast<Eigen::Index> (members.size()));
    writeDerivative (dx, dy, result);
    return result;
}

void CellFunctions::writeDerivative (int dx, int dy, Eigen::Ref<Eigen::MatrixXd> result) const
{
    const KinkFunction* last = nullptr;
    std::vector<Eigen::VectorXd> factors; // Of the kink's derivatives, i along x and j along y.

    for (std::size_t m = 0; m < members.size(); ++m)
    {
        const auto& member = members[m];
        auto column = result.col (static_cast<Eigen::Index> (m));
        const auto product = [&] (int x, int y)
        {
            return alongX[static_cast<std::size_t> (x)]
                .col (member.ofX)
                .cwiseProduct (alongY[static_cast<std::size_t> (y)].col (member.ofY));
        };

        if (member.kink == nullptr)
        {
            column = product (dx, dy);
            continue;
        }

        if (member.kink != last)
        {
            factors.clear();
            last = member.kink;

            for (int j = 0; j <= dy; ++j)
                for (int i = 0; i <= dx; ++i)
                    factors.emplace_back (binomial (dx, i) * binomial (dy, j) * kinkDerivative (*last, i, j));
        }

        auto factor = factors.cbegin();

        for (int j = 0; j <= dy; ++j)
            for (int i = 0; i <= dx; ++i, ++factor)
                if (i == 0 && j == 0)
                    column = factor->cwiseProduct (product (dx, dy));
                else
                    column += factor->cwiseProduct (product (dx - i, dy - j));
    }
}

// What functions of the space are at places: the fields of its coefficients.
const ImmersedCell* ImmersedSpace::cellAt (double xPlace, double yPlace) const
{
    const auto place = axisX.cellAt (xPlace) + axisY.cellAt (yPlace) * axisX.cells();
    const auto number = cellNumber[static_cast<std::size_t> (place)];
    return number < 0 ? nullptr : &activeCells[static_cast<std::size_t> (number)];
}

const ImmersedCell* ImmersedSpace::cellNear (double xPlace, double yPlace) const
{
    constexpr double little = 1e-9; // Of a cell.
    const auto alongX = little * axisX.cellLength (axisX.cellAt (xPlace));
    const auto alongY = little * axisY.cellLength (axisY.cellAt (yPlace));

    for (const auto right : { 0, 1, -1 })
        for (const auto up : { 0, 1, -1 })
            if (const auto* cell = cellAt (xPlace + right * alongX, yPlace + up * alongY))
                return cell;

    return nullptr;
}

Eigen::VectorXd ImmersedSpace::plane (double c, double a, double b) const
{
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero (count);

    for (Eigen::Index j = 0; j < axisY.size(); ++j)
        for (Eigen::Index i = 0; i < axisX.size(); ++i)
            if (const auto number = unknownOf[static_cast<std::size_t> (tensorIndex (i, j))]; number >= 0)
                coefficients[number] = c + a * axisX.centre (i) + b * axisY.centre (j);

    return coefficients;
}

Eigen::MatrixXd ImmersedSpace::evaluate (const Eigen::MatrixX2d& places, const Eigen::MatrixXd& coefficients, int dx,
                                         int dy) const
{
    Eigen::MatrixXd fields = Eigen::MatrixXd::Zero (places.rows(), coefficients.cols());
    std::vector<std::vector<Eigen::Index>> rowsOf (activeCells.size());

    for (Eigen::Index p = 0; p < places.rows(); ++p)
        if (const auto* const cell = cellNear (places (p, 0), places (p, 1)))
            rowsOf[static_cast<std::size_t> (cell - activeCells.data())].push_back (p);

    for (std::size_t c = 0; c < activeCells.size(); ++c)
    {
        const auto& rows = rowsOf[c];

        if (rows.empty())
            continue;

        checkWatch();
        std::vector<Eigen::Vector2d> here;

        for (const auto row : rows)
            here.emplace_back (places.row (row).transpose());

        const CellFunctions functions (*this, activeCells[c], here, std::max (dx, dy));
        const Eigen::MatrixXd local = coefficients (functions.unknowns(), Eigen::all);
        Eigen::MatrixXd values = Eigen::MatrixXd::Zero (static_cast<Eigen::Index> (rows.size()), coefficients.cols());
        addProduct (values, 1, functions.derivative (dx, dy), local);
        fields (rows, Eigen::all) = values;
    }

    return fields;
}
} // namespace antinode
