#include "ImmersedOperators.h"

#include "ImmersedSpace.h"
#include "PlateSupports.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Quadrature.h>

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
    Eigen::Matrix3d stiffness; ///< Without what is bonded.
    double massPerArea = 0, rotaryInertia = 0, foundation = 0;
    std::vector<const BondedPart*> bonded;
};

LocalSection sectionOn (const BendingProblem& problem, const std::vector<bool>& isOn)
{
    LocalSection section {
        problem.section.stiffness, problem.section.massPerArea, problem.section.rotaryInertia, problem.foundation, {}
    };

    for (std::size_t p = 0; p < problem.patches.size(); ++p)
        if (isOn[p])
        {
            const auto& patch = problem.patches[p];
            section.stiffness += patch.added.stiffness;
            section.massPerArea += patch.added.massPerArea;
            section.rotaryInertia += patch.added.rotaryInertia;
            section.foundation += patch.foundation;

            if (patch.bonded)
                section.bonded.push_back (&*patch.bonded);
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

    /** R with R R' = D at each place, by w,12 in place of 2 w,12. */
    static std::vector<Eigen::Matrix3d> rootsAt (const CellPoints& points, const std::vector<LocalSection>& sections)
    {
        std::vector<Eigen::Matrix3d> ofSections, roots;

        for (const auto& section : sections)
            ofSections.push_back (lowerRoot (twistDoubled (section.stiffness)));

        for (std::size_t i = 0; i < points.places.size(); ++i)
        {
            const auto& section = sections[points.section[i]];

            if (section.bonded.empty())
            {
                roots.push_back (ofSections[points.section[i]]);
                continue;
            }

            auto stiffness = section.stiffness;

            for (const auto* const part : section.bonded)
                stiffness += part->stiffnessAt (points.places[i]);

            roots.push_back (lowerRoot (twistDoubled (stiffness)));
        }

        return roots;
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

        for (const auto& isOn : points.sections)
            sections.push_back (sectionOn (problem, isOn));

        const auto roots = rootsAt (points, sections);
        const auto weighted = [&] (const auto& value) -> Eigen::VectorXd
        {
            return Eigen::VectorXd::NullaryExpr (number,
                                                 [&] (Eigen::Index q)
                                                 {
                                                     const auto i = static_cast<std::size_t> (q);
                                                     return std::sqrt (points.weights[i]) * value (i);
                                                 });
        };
        const auto weightedBy = [&] (double LocalSection::*value)
        { return weighted ([&] (std::size_t i) { return std::sqrt (sections[points.section[i]].*value); }); };

        // With D = R R' and the weights in it the stiffness is a product of R' curvatures with itself, half of which is
        // computed.
        auto stiffness = stiffnessSpace.matrix (members, members), mass = massSpace.matrix (members, members);
        auto bent = factorSpace.matrix (members, 3 * number);
        stiffness.setZero();
        mass.setZero();

        for (int a = 0; a < 3; ++a)
        {
            auto part = bent.middleCols (a * number, number);
            const auto factorsOf = [&] (int b) { return weighted ([&] (std::size_t i) { return roots[i](b, a); }); };
            part = bending[static_cast<std::size_t> (a)].transpose() * factorsOf (a).asDiagonal();

            for (int b = a + 1; b < 3; ++b)
                if (const auto factors = factorsOf (b); factors.any())
                    part += bending[static_cast<std::size_t> (b)].transpose() * factors.asDiagonal();
        }

        addGram (stiffness, 1, bent);
        auto moved = factorSpace.matrix (members, number);
        moved = values.transpose() * weightedBy (&LocalSection::massPerArea).asDiagonal();
        addGram (mass, 1, moved);

        if (const auto founded = weightedBy (&LocalSection::foundation); founded.any())
        {
            moved = values.transpose() * founded.asDiagonal();
            addGram (stiffness, 1, moved);
        }

        // The last that needs room: slopes take that of the values.
        if (const auto turned = weightedBy (&LocalSection::rotaryInertia); turned.any())
            for (const auto along : { 1, 0 })
            {
                auto slopes = valueSpace.matrix (number, members);
                functions.writeDerivative (along, 1 - along, slopes);
                moved = slopes.transpose() * turned.asDiagonal();
                addGram (mass, 1, moved);
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
            const auto& patch = problem.patches[p];

            if (! patch.hasMoment()
                || std::none_of (points.sections.begin(), points.sections.end(),
                                 [p] (const std::vector<bool>& isOn) { return isOn[p]; }))
                continue;

            const auto number = static_cast<Eigen::Index> (points.places.size());
            Eigen::Matrix3Xd moments = Eigen::Matrix3Xd::Zero (3, number);

            for (Eigen::Index q = 0; q < number; ++q)
                if (const auto i = static_cast<std::size_t> (q); points.sections[points.section[i]][p])
                    moments.col (q) = points.weights[i] * patch.momentAt (points.places[i]);

            const Eigen::RowVectorXd load =
                moments.row (0) * bending[0] + moments.row (1) * bending[1] + 2 * moments.row (2) * bending[2];

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
