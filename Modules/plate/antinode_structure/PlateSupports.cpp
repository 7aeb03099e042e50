#include "PlateSupports.h"

#include "ImmersedOperators.h"
#include "ImmersedSpace.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** Places along a part of an edge, with the normals that point away from the plate. */
struct EdgePoints
{
    std::vector<Eigen::Vector2d> places, normals;
    std::vector<double> weights; ///< m
};

/** @param turn  1 where the plate lies at the left of the path, else -1 */
EdgePoints edgePoints (const PathPiece& piece, double from, double to, const Quadrature& rule, double turn)
{
    const auto direction = piece.to < piece.from ? -turn : turn;
    EdgePoints points;

    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
    {
        const auto t = from + (to - from) * rule.nodes[i];
        const auto derivative = piece.derivative (t);
        const Eigen::Vector2d tangent = direction * derivative.normalized();
        points.places.push_back (piece.at (t));
        points.normals.emplace_back (tangent.y(), -tangent.x());
        points.weights.push_back (rule.weights[i] * std::abs (to - from) * derivative.norm());
    }

    return points;
}

/** The parameters at which a piece passes from cell to cell, with its ends. */
std::vector<double> cellParameters (const PathPiece& piece, const ImmersedSpace& space)
{
    std::vector<double> parameters { std::min (piece.from, piece.to), std::max (piece.from, piece.to) };
    const auto add = [&] (PlaneAxis axis, const SplineAxis& splines)
    {
        for (Eigen::Index cell = 1; cell < splines.cells(); ++cell)
            if (const auto line = splines.cellStart (cell); line > piece.least (axis) && line < piece.largest (axis))
                parameters.push_back (piece.parameterAt (axis, line));
    };
    add (PlaneAxis::x, space.x());
    add (PlaneAxis::y, space.y());
    std::sort (parameters.begin(), parameters.end());
    return parameters;
}

/** The derivatives of all functions at places of an edge, along the plate's axes. */
class EdgeFields
{
public:
    EdgeFields (const CellFunctions& functionsToUse, const EdgePoints& pointsToUse, const Eigen::Matrix3d& stiffness)
        : functions (functionsToUse), points (pointsToUse), d (stiffness)
    {
        const auto number = static_cast<Eigen::Index> (points.places.size());
        normalX.resize (number);
        normalY.resize (number);

        for (Eigen::Index i = 0; i < number; ++i)
        {
            normalX[i] = points.normals[static_cast<std::size_t> (i)].x();
            normalY[i] = points.normals[static_cast<std::size_t> (i)].y();
        }
    }

    Eigen::MatrixXd value() const { return functions.derivative (0, 0); }

    Eigen::MatrixXd normalSlope() const
    {
        return normalX.asDiagonal() * functions.derivative (1, 0) + normalY.asDiagonal() * functions.derivative (0, 1);
    }

    Eigen::MatrixXd tangentSlope() const
    {
        return normalX.asDiagonal() * functions.derivative (0, 1) - normalY.asDiagonal() * functions.derivative (1, 0);
    }

    /** The moments M11, M22, M12 of curvatures that are derived further along x and y. */
    Eigen::MatrixXd moment (int row, int dx, int dy) const
    {
        return d (row, 0) * functions.derivative (2 + dx, dy) + d (row, 1) * functions.derivative (dx, 2 + dy)
               + 2 * d (row, 2) * functions.derivative (1 + dx, 1 + dy);
    }

    Eigen::MatrixXd normalMoment() const
    {
        return normalX.cwiseAbs2().asDiagonal() * moment (0, 0, 0) + normalY.cwiseAbs2().asDiagonal() * moment (1, 0, 0)
               + (2 * normalX.cwiseProduct (normalY)).asDiagonal() * moment (2, 0, 0);
    }

    Eigen::MatrixXd twistingMoment() const
    {
        return normalX.cwiseProduct (normalY).asDiagonal() * (moment (1, 0, 0) - moment (0, 0, 0))
               + (normalX.cwiseAbs2() - normalY.cwiseAbs2()).asDiagonal() * moment (2, 0, 0);
    }

    Eigen::MatrixXd shearForce() const
    {
        return normalX.asDiagonal() * (moment (0, 1, 0) + moment (2, 0, 1))
               + normalY.asDiagonal() * (moment (2, 1, 0) + moment (1, 0, 1));
    }

private:
    const CellFunctions& functions;
    const EdgePoints& points;
    Eigen::Matrix3d d;
    Eigen::VectorXd normalX, normalY;
};

/** The terms of a part of an edge within one cell. */
Eigen::MatrixXd localTerms (const EdgeFields& fields, const EdgePoints& points, const EdgeSupport& support,
                            double plateStiffness, double cell)
{
    // Large enough for functions that have much of a cell; too large ones make a curved edge stiff.
    constexpr double penalty = 1e5;
    const auto value = fields.value();
    const auto slope = fields.normalSlope();
    const Eigen::Map<const Eigen::VectorXd> weights (points.weights.data(),
                                                     static_cast<Eigen::Index> (points.weights.size()));
    Eigen::MatrixXd terms = Eigen::MatrixXd::Zero (value.cols(), value.cols());
    const auto addSquare = [&] (double factor, const Eigen::MatrixXd& a)
    { addTransposedLeft (terms, factor, a, weights.asDiagonal() * a); };
    const auto addBoth = [&] (double factor, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    {
        addTransposedLeft (terms, factor, a, weights.asDiagonal() * b);
        addTransposedLeft (terms, factor, b, weights.asDiagonal() * a);
    };

    if (support.translation > 0)
        addSquare (support.translation, value);

    if (support.rotation > 0)
        addSquare (support.rotation, slope);

    if (support.holdsDisplacement)
    {
        addBoth (1, value, fields.shearForce());
        addBoth (-1, fields.tangentSlope(), fields.twistingMoment());
        addSquare (penalty * plateStiffness / (cell * cell * cell), value);
    }

    if (support.holdsSlope)
    {
        addBoth (-1, slope, fields.normalMoment());
        addSquare (penalty * plateStiffness / cell, slope);
    }

    return terms;
}

bool isFree (const EdgeSupport& support)
{
    return ! support.holdsDisplacement && ! support.holdsSlope && support.translation == 0 && support.rotation == 0;
}

template <typename Function>
void forEachHeldPiece (const BendingProblem& problem, const Function& function)
{
    for (const auto& path : problem.outline.paths)
    {
        const auto turn = insideAtLeft (problem.outline, path);

        for (const auto& piece : path)
            if (const auto& support = problem.edges.at (static_cast<std::size_t> (piece.edge)); ! isFree (support))
                function (piece, support, turn);
    }
}

/** The stiffness of the plate with the patches on it beside a place of its edge. */
Eigen::Matrix3d stiffnessBeside (const BendingProblem& problem, const Eigen::Vector2d& place,
                                 const Eigen::Vector2d& normal)
{
    constexpr double step = 1e-6; // of the plate's size, inward
    const Eigen::Vector2d inside = place - step * extentOf (problem.outline).size().maxCoeff() * normal;
    auto stiffness = problem.section.stiffness;

    for (const auto& patch : problem.patches)
        if (patch.outline.contains (inside.x(), inside.y()))
            stiffness += patch.stiffnessAt (inside);

    return stiffness;
}

double largestStiffness (const BendingProblem& problem)
{
    return problem.section.stiffness.diagonal().maxCoeff();
}

/** The rigid motions 1, x and y about the middle of an outline, in units of its size. */
Eigen::Vector3d rigidMotions (const OutlineExtent& extent, const Eigen::Vector2d& place)
{
    const Eigen::Vector2d offset = (place - (extent.least + extent.largest) / 2) / extent.size().maxCoeff();
    return { 1, offset.x(), offset.y() };
}

/** The integral of r r' over an outline, as if it were its rectangle. */
Eigen::Matrix3d overArea (const OutlineExtent& whole, const Outline& part)
{
    const auto extent = extentOf (part);
    const auto middle = rigidMotions (whole, (extent.least + extent.largest) / 2);
    const Eigen::Vector2d size = extent.size() / whole.size().maxCoeff();
    Eigen::Matrix3d sum = middle * middle.transpose();
    sum.diagonal().tail<2>() += size.cwiseAbs2() / 12;
    return areaOf (part) * sum;
}
} // namespace

void addEdgeTerms (BlockBandedMatrix& stiffness, const BendingProblem& problem, const ImmersedSpace& space)
{
    const auto rule = gaussLegendre (space.x().degree() + 3, 1);
    const auto unit = largestStiffness (problem);
    forEachHeldPiece (
        problem,
        [&] (const PathPiece& piece, const EdgeSupport& support, double turn)
        {
            const auto parameters = cellParameters (piece, space);

            for (std::size_t i = 0; i + 1 < parameters.size(); ++i)
            {
                checkWatch();

                if (! (parameters[i + 1] > parameters[i]))
                    continue;

                const auto middle = piece.at ((parameters[i] + parameters[i + 1]) / 2);
                const auto* active = space.cellNear (middle.x(), middle.y());

                if (active == nullptr)
                    continue;

                const auto points = edgePoints (piece, parameters[i], parameters[i + 1], rule, turn);
                const CellFunctions functions (space, *active, points.places, 3);
                const auto centre = points.places.size() / 2;
                const auto local = stiffnessBeside (problem, points.places[centre], points.normals[centre]);
                const EdgeFields fields (functions, points, local);
                const auto extent = space.extent (active->column, active->row);
                const auto cell = std::min (extent.right - extent.left, extent.top - extent.bottom);
                addToMatrix (stiffness, functions.unknowns(), localTerms (fields, points, support, unit, cell));
            }
        });
}

Eigen::Matrix3d rigidSupport (const BendingProblem& problem)
{
    const auto rule = gaussLegendre (8, 1);
    const auto extent = extentOf (problem.outline);
    const auto size = extent.size().maxCoeff();
    const auto unit = largestStiffness (problem) / (size * size);
    Eigen::Matrix3d support = problem.foundation * overArea (extent, problem.outline);
    forEachHeldPiece (problem,
                      [&] (const PathPiece& piece, const EdgeSupport& edge, double turn)
                      {
                          const auto translation = edge.translation + (edge.holdsDisplacement ? unit / size : 0);
                          const auto rotation = edge.rotation / (size * size) + (edge.holdsSlope ? unit / size : 0);
                          const auto points = edgePoints (piece, piece.from, piece.to, rule, turn);

                          for (std::size_t i = 0; i < points.places.size(); ++i)
                          {
                              const auto motion = rigidMotions (extent, points.places[i]);
                              const Eigen::Vector3d slope (0, points.normals[i].x(), points.normals[i].y());
                              support +=
                                  points.weights[i]
                                  * (translation * motion * motion.transpose() + rotation * slope * slope.transpose());
                          }
                      });

    for (const auto& patch : problem.patches)
        support += patch.foundation * overArea (extent, patch.outline);

    for (const auto& point : problem.points)
    {
        const auto motion = rigidMotions (extent, point.place);
        support += point.stiffness * motion * motion.transpose();
    }

    return support / unit;
}

Eigen::MatrixXd freeMotions (const BendingProblem& problem, const ImmersedSpace& space, const BlockBandedMatrix& mass)
{
    constexpr double free = 1e-9; // Of the plate's own stiffness.
    const auto held = symmetricEigen (rigidSupport (problem));
    const auto number = (held.values.array() < free).count();

    if (number == 0)
        return Eigen::MatrixXd (space.unknowns(), 0);

    const auto extent = extentOf (problem.outline);
    const auto size = extent.size().maxCoeff();
    const Eigen::Vector2d middle = (extent.least + extent.largest) / 2;
    Eigen::MatrixXd planes (space.unknowns(), number);

    for (Eigen::Index i = 0; i < number; ++i)
    {
        const Eigen::Vector3d motion = held.vectors.col (i);
        planes.col (i) =
            space.plane (motion[0] - motion.tail<2>().dot (middle) / size, motion[1] / size, motion[2] / size);
    }

    const auto gram = symmetricEigen (planes.transpose() * (mass * planes));
    return planes * gram.vectors * gram.values.cwiseSqrt().cwiseInverse().asDiagonal();
}
} // namespace antinode
