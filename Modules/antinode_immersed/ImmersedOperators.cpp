#include "ImmersedOperators.h"

#include "CellFunctions.h"
#include "EdgeTerms.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussLegendre.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
/** What a place weighs and how stiff it is: the plate's own and what lies on it. */
struct LocalSection
{
    Eigen::Matrix3d stiffness;
    double massPerArea = 0, foundation = 0;
};

LocalSection sectionOn (const BendingProblem& problem, const std::vector<bool>& isOn)
{
    LocalSection section { problem.section.stiffness, problem.section.massPerArea, problem.foundation };

    for (std::size_t p = 0; p < problem.patches.size(); ++p)
        if (isOn[p])
        {
            section.stiffness += problem.patches[p].added.stiffness;
            section.massPerArea += problem.patches[p].added.massPerArea;
            section.foundation += problem.patches[p].foundation;
        }

    return section;
}

/** The stiffness by w,12 in place of 2 w,12. */
Eigen::Matrix3d twistDoubled (Eigen::Matrix3d stiffness)
{
    stiffness.row (2) *= 2;
    stiffness.col (2) *= 2;
    return stiffness;
}

/** The lower triangle R with R R' = a of a positive definite matrix. */
Eigen::Matrix3d lowerRoot (const Eigen::Matrix3d& a)
{
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();

    for (int j = 0; j < 3; ++j)
        for (int i = j; i < 3; ++i)
        {
            const auto rest = a (i, j) - root.row (i).head (j).dot (root.row (j).head (j));
            root (i, j) = i == j ? std::sqrt (rest) : rest / root (j, j);
        }

    return root;
}

/** Memory for matrices of all sizes, one after the other: the heap would give it back and ask for it again at every
 * cell. */
class MatrixSpace
{
public:
    /** Its values are any. */
    Eigen::Map<Eigen::MatrixXd> matrix (Eigen::Index rows, Eigen::Index columns)
    {
        if (memory.size() < rows * columns)
            memory.resize (rows * columns);

        return { memory.data(), rows, columns };
    }

private:
    Eigen::VectorXd memory;
};

/** The terms of cells, one after the other. */
class CellTerms
{
public:
    CellTerms (const BendingProblem& problemToUse, const ImmersedSpace& spaceToUse, ImmersedOperators& operatorsToFill)
        : problem (problemToUse), space (spaceToUse), operators (operatorsToFill)
    {
        const auto rule = gaussLegendre (space.x().degree() + 1, 1);
        nodes = rule.nodes;
        weights = rule.weights;
    }

    void add (const ImmersedCell& cell)
    {
        checkWatch();

        if (cell.kind == CellKind::cut)
            addPoints (cell, cell.points);
        else
            addPoints (cell, wholePoints (cell));
    }

private:
    CellPoints wholePoints (const ImmersedCell& cell) const
    {
        const auto extent = space.extent (cell.column, cell.row);
        CellPoints points;
        points.sections = { cell.points.sections[cell.points.section.front()] };

        for (Eigen::Index j = 0; j < nodes.size(); ++j)
            for (Eigen::Index i = 0; i < nodes.size(); ++i)
            {
                points.places.emplace_back (extent.left + (extent.right - extent.left) * nodes[i],
                                            extent.bottom + (extent.top - extent.bottom) * nodes[j]);
                points.weights.push_back (extent.area() * weights[i] * weights[j]);
                points.section.push_back (0);
            }

        return points;
    }

    void addPoints (const ImmersedCell& cell, const CellPoints& points)
    {
        const CellFunctions functions (space, cell, points.places, 2);
        const auto number = static_cast<Eigen::Index> (points.places.size());
        const auto members = static_cast<Eigen::Index> (functions.unknowns().size());
        auto values = valueSpace.matrix (number, members);
        std::array bending { curvatureSpaces[0].matrix (number, members), curvatureSpaces[1].matrix (number, members),
                             curvatureSpaces[2].matrix (number, members) };
        functions.writeDerivative (0, 0, values);
        functions.writeDerivative (2, 0, bending[0]);
        functions.writeDerivative (0, 2, bending[1]);
        functions.writeDerivative (1, 1, bending[2]);
        std::vector<LocalSection> sections;
        std::vector<Eigen::Matrix3d> roots;

        for (const auto& isOn : points.sections)
        {
            sections.push_back (sectionOn (problem, isOn));
            roots.push_back (lowerRoot (twistDoubled (sections.back().stiffness)));
        }

        const auto weighted = [&] (const auto& value) -> Eigen::VectorXd
        {
            return Eigen::VectorXd::NullaryExpr (number,
                                                 [&] (Eigen::Index q)
                                                 {
                                                     const auto i = static_cast<std::size_t> (q);
                                                     return std::sqrt (points.weights[i]) * value (points.section[i]);
                                                 });
        };

        // With D = R R' and the weights in it the stiffness is a product of R' curvatures with itself, half of which is
        // computed.
        auto stiffness = stiffnessSpace.matrix (members, members), mass = massSpace.matrix (members, members);
        auto bent = factorSpace.matrix (members, 3 * number);
        stiffness.setZero();
        mass.setZero();

        for (int a = 0; a < 3; ++a)
        {
            auto part = bent.middleCols (a * number, number);
            const auto factorsOf = [&] (int b) { return weighted ([&] (std::size_t s) { return roots[s](b, a); }); };
            part = bending[static_cast<std::size_t> (a)].transpose() * factorsOf (a).asDiagonal();

            for (int b = a + 1; b < 3; ++b)
                if (const auto factors = factorsOf (b); factors.any())
                    part += bending[static_cast<std::size_t> (b)].transpose() * factors.asDiagonal();
        }

        addGram (stiffness, 1, bent);
        auto moved = factorSpace.matrix (members, number);
        moved = values.transpose()
                * weighted ([&] (std::size_t s) { return std::sqrt (sections[s].massPerArea); }).asDiagonal();
        addGram (mass, 1, moved);

        if (const auto founded = weighted ([&] (std::size_t s) { return std::sqrt (sections[s].foundation); });
            founded.any())
        {
            moved = values.transpose() * founded.asDiagonal();
            addGram (stiffness, 1, moved);
        }

        addToMatrix (operators.stiffness, functions.unknowns(), stiffness);
        addToMatrix (operators.mass, functions.unknowns(), mass);
        addLoads (functions, points, bending);
    }

    void addLoads (const CellFunctions& functions, const CellPoints& points,
                   const std::array<Eigen::Map<Eigen::MatrixXd>, 3>& bending)
    {
        for (std::size_t p = 0; p < problem.patches.size(); ++p)
        {
            const auto& moment = problem.patches[p].moment;

            if (! moment.any()
                || std::none_of (points.sections.begin(), points.sections.end(),
                                 [p] (const std::vector<bool>& isOn) { return isOn[p]; }))
                continue;

            const auto number = static_cast<Eigen::Index> (points.places.size());
            const Eigen::RowVectorXd onPatch = Eigen::RowVectorXd::NullaryExpr (
                number,
                [&] (Eigen::Index q)
                {
                    const auto i = static_cast<std::size_t> (q);
                    return points.sections[points.section[i]][p] ? points.weights[i] : 0.0;
                });

            const Eigen::RowVectorXd load = moment[0] * (onPatch * bending[0]) + moment[1] * (onPatch * bending[1])
                                            + 2 * moment[2] * (onPatch * bending[2]);

            for (std::size_t i = 0; i < functions.unknowns().size(); ++i)
                operators.loads (functions.unknowns()[i], static_cast<Eigen::Index> (p)) +=
                    load[static_cast<Eigen::Index> (i)];
        }
    }

    const BendingProblem& problem;
    const ImmersedSpace& space;
    ImmersedOperators& operators;
    Eigen::VectorXd nodes, weights;
    std::array<MatrixSpace, 3> curvatureSpaces; ///< Of w,11, w,22 and w,12.
    MatrixSpace valueSpace, stiffnessSpace, massSpace, factorSpace;
};

void addAttachments (ImmersedOperators& operators, const BendingProblem& problem, const ImmersedSpace& space)
{
    for (const auto& point : problem.points)
        if (const auto* cell = space.cellAt (point.place.x(), point.place.y()))
        {
            const CellFunctions functions (space, *cell, { point.place }, 0);
            const auto values = functions.derivative (0, 0);
            const Eigen::MatrixXd product = values.transpose() * values;
            addToMatrix (operators.stiffness, functions.unknowns(), point.stiffness * product);
            addToMatrix (operators.mass, functions.unknowns(), point.mass * product);
        }
}
} // namespace

void addToMatrix (BlockBandedMatrix& matrix, const std::vector<Eigen::Index>& numbers,
                  const Eigen::Ref<const Eigen::MatrixXd>& local)
{
    for (std::size_t j = 0; j < numbers.size(); ++j)
    {
        const auto block = matrix.blockOf (numbers[j]);
        const auto begin = matrix.begin (block);
        auto column = matrix.panel (block).col (numbers[j] - begin);

        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (numbers[i] >= numbers[j])
                column[numbers[i] - begin] +=
                    local (static_cast<Eigen::Index> (std::max (i, j)), static_cast<Eigen::Index> (std::min (i, j)));
    }
}

ImmersedOperators immersedOperators (const BendingProblem& problem, const ImmersedSpace& space)
{
    ImmersedOperators operators { space.zeroMatrix(), space.zeroMatrix(),
                                  Eigen::MatrixXd::Zero (space.unknowns(),
                                                         static_cast<Eigen::Index> (problem.patches.size())) };
    CellTerms terms (problem, space, operators);

    for (const auto& active : space.cells())
        terms.add (active);

    addEdgeTerms (operators.stiffness, problem, space);
    addAttachments (operators, problem, space);
    return operators;
}

BlockBandedFactor factorShifted (const ImmersedOperators& operators, double shift)
{
    auto matrix = operators.stiffness;
    matrix.addMultiple (-shift, operators.mass);
    return BlockBandedFactor (std::move (matrix));
}
} // namespace antinode
