#include "PlateStatics.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_structure/ElementChain.h>
#include <antinode_structure/SolvedPlate.h>

namespace antinode
{
namespace
{
/** What each ceramic does to the splines per volt, unknowns x N_b. */
Eigen::MatrixXd computeLoads (const PlateDescription& plate, const PlateSolution& solution)
{
    const auto& [unit, linesX, linesY, patches] = solution.layout;
    Eigen::MatrixXd loads (solution.problem.unknowns(), static_cast<Eigen::Index> (patches.size()));

    for (std::size_t i = 0; i < patches.size(); ++i)
    {
        checkWatch();
        const auto& patch = patches[i];
        const auto section = ceramicSection (plate.common, plate.common.ceramics[i]);
        loads.col (static_cast<Eigen::Index> (i)) =
            rectangleLoad (solution.problem, section, linesX[patch.left], linesX[patch.right], linesY[patch.bottom],
                           linesY[patch.top]);
    }

    return loads;
}

/** The deflections, free of rigid motion, that balance loads once their rigid part is borne by the plate's inertia. */
Eigen::MatrixXd deflections (const PlateProblem& problem, int rigidBodyModes, const Eigen::MatrixXd& loads)
{
    // K x = f is singular where the plate may move freely. (K + M) x = f + M x is not, and as a fixed point it gains a
    // factor of 1 + lambda_1, more than 10 for any plate, a step.
    constexpr double shift = -1;
    constexpr int steps = 16;
    const BlockBandedFactor factor (problem.stiffness, problem.mass, shift, problem.outer);
    constexpr auto converged = 1e-10; // what the last step may change
    const auto rigid = lowestEigenpairs (factor, problem.mass, shift, std::max (rigidBodyModes, 1));
    const Eigen::MatrixXd motions = rigid.vectors.leftCols (rigidBodyModes);
    const Eigen::MatrixXd weighted = problem.mass (motions);
    const Eigen::MatrixXd flexible = loads - weighted * (motions.transpose() * loads);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero (loads.rows(), loads.cols()), before;

    for (int step = 0; step < steps; ++step)
    {
        before = x;
        x = flexible + problem.mass (x);
        factor.solveInPlace (x);
        x -= motions * (weighted.transpose() * x);
    }

    if (! rigid.areConverged || ! ((x - before).norm() <= converged * x.norm()))
        throwNumbersTooFarApart();

    return x;
}
} // namespace

Eigen::MatrixXd staticShapes (const PlateDescription& plate, const PlateSolution& solution, const PlateGrid& grid)
{
    const auto& problem = solution.problem;
    const auto unit = solution.layout.unit;
    const auto scale = unit * unit / bareSection (plate.common).d11;
    return shapesOn (grid, problem, unit,
                     scale * deflections (problem, solution.rigidBodyModes, computeLoads (plate, solution)));
}
} // namespace antinode
