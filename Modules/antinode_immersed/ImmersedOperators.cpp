#include "ImmersedOperators.h"

#include "CellFunctions.h"
#include "EdgeTerms.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/GaussLegendre.h>

#include <array>
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

/** Curvatures of all functions: of (w,11 w,22 2 w,12) each places x functions. */
std::array<Eigen::MatrixXd, 3> curvatures (const CellFunctions& functions)
{
    return { functions.derivative (2, 0), functions.derivative (0, 2), 2 * functions.derivative (1, 1) };
}

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
        const auto bending = curvatures (functions);
        const auto values = functions.derivative (0, 0);
        std::vector<LocalSection> sections;

        for (const auto& isOn : points.sections)
            sections.push_back (sectionOn (problem, isOn));

        const auto weighted = [&] (const auto& value)
        {
            return Eigen::VectorXd::NullaryExpr (number,
                                                 [&] (Eigen::Index q)
                                                 {
                                                     const auto i = static_cast<std::size_t> (q);
                                                     return points.weights[i] * value (sections[points.section[i]]);
                                                 });
        };

        Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero (members, members);
        Eigen::MatrixXd mass = stiffness;

        for (int a = 0; a < 3; ++a)
        {
            Eigen::MatrixXd moments = Eigen::MatrixXd::Zero (number, members);

            for (int b = 0; b < 3; ++b)
            {
                const Eigen::VectorXd factor = weighted ([&] (const LocalSection& s) { return s.stiffness (a, b); });

                if (factor.any())
                    moments += factor.asDiagonal() * bending[static_cast<std::size_t> (b)];
            }

            addTransposedLeft (stiffness, 1, bending[static_cast<std::size_t> (a)], moments);
        }

        const Eigen::VectorXd foundation = weighted ([] (const LocalSection& s) { return s.foundation; });

        if (foundation.any())
            addTransposedLeft (stiffness, 1, values, foundation.asDiagonal() * values);

        addTransposedLeft (mass, 1, values,
                           weighted ([] (const LocalSection& s) { return s.massPerArea; }).asDiagonal() * values);
        addToMatrix (operators.stiffness, functions.unknowns(), stiffness);
        addToMatrix (operators.mass, functions.unknowns(), mass);
        addLoads (functions, points, bending);
    }

    void addLoads (const CellFunctions& functions, const CellPoints& points,
                   const std::array<Eigen::MatrixXd, 3>& bending)
    {
        for (std::size_t p = 0; p < problem.patches.size(); ++p)
        {
            const auto& moment = problem.patches[p].moment;
            const auto number = static_cast<Eigen::Index> (points.places.size());
            const Eigen::RowVectorXd onPatch = Eigen::RowVectorXd::NullaryExpr (
                number,
                [&] (Eigen::Index q)
                {
                    const auto i = static_cast<std::size_t> (q);
                    return points.sections[points.section[i]][p] ? points.weights[i] : 0.0;
                });

            if (! onPatch.any() || ! moment.any())
                continue;

            const Eigen::RowVectorXd load =
                onPatch * (moment[0] * bending[0] + moment[1] * bending[1] + moment[2] * bending[2]);

            for (std::size_t i = 0; i < functions.unknowns().size(); ++i)
                operators.loads (functions.unknowns()[i], static_cast<Eigen::Index> (p)) +=
                    load[static_cast<Eigen::Index> (i)];
        }
    }

    const BendingProblem& problem;
    const ImmersedSpace& space;
    ImmersedOperators& operators;
    Eigen::VectorXd nodes, weights;
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

void addToMatrix (BlockBandedMatrix& matrix, const std::vector<Eigen::Index>& numbers, const Eigen::MatrixXd& local)
{
    for (std::size_t j = 0; j < numbers.size(); ++j)
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (numbers[i] >= numbers[j])
                matrix.add (numbers[i], numbers[j],
                            local (static_cast<Eigen::Index> (i), static_cast<Eigen::Index> (j)));
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
} // namespace antinode
