#include "StaticShare.h"

#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "ElementChain.h"
#include "FrequencyCorrection.h"
#include "SolvedPlate.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/Decompositions.h>

#include <cmath>
#include <functional>

namespace antinode
{
namespace
{
/** What each ceramic does to the splines per volt, unknowns x N_b. */
Eigen::MatrixXd ceramicLoads (const PlateDescription& plate, const PlateSolution& solution)
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
Eigen::MatrixXd balancedDeflections (const PlateProblem& problem, int rigidBodyModes, const Eigen::MatrixXd& loads)
{
    // K x = f is singular where the plate may move freely. (K + M) x = f + M x is not, and as a fixed point it gains a
    // factor of 1 + lambda_1, more than 10 for any plate, a step.
    constexpr double shift = -1;
    constexpr int steps = 16;
    const auto factor = factorShifted (problem.stiffness, problem.mass, shift, problem.outer);
    constexpr auto converged = 1e-10; // what the last step may change
    const auto rigid =
        lowestEigenpairs (factor, std::cref (problem.mass), problem.unknowns(), shift, std::max (rigidBodyModes, 1));
    const Eigen::MatrixXd motions = rigid.vectors.leftCols (rigidBodyModes);
    const Eigen::MatrixXd weighted = problem.mass (motions);
    const Eigen::MatrixXd flexible = loads - weighted * (motions.transpose() * loads);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero (loads.rows(), loads.cols()), before;

    for (int step = 0; step < steps; ++step)
    {
        checkWatch();
        before = x;
        x = flexible + problem.mass (x);
        factor.solveInPlace (x);
        x -= motions * (weighted.transpose() * x);
    }

    if (! rigid.areConverged || ! ((x - before).norm() <= converged * x.norm()))
        throwNumbersTooFarApart();

    return x;
}

/** Columns of length 1 that are orthogonal in mass to modes, and span with them what they did before. */
Eigen::MatrixXd besides (const PlateProblem& problem, const Eigen::MatrixXd& modes, Eigen::MatrixXd columns)
{
    const Eigen::MatrixXd weighted = problem.mass (modes);

    for (int pass = 0; pass < 2; ++pass) // the second removes what rounding left
    {
        columns -= modes * (weighted.transpose() * columns);
        columns.colwise().normalize();
    }

    return columns;
}
} // namespace

Eigen::MatrixXd staticDeflections (const PlateDescription& plate, const PlateSolution& solution)
{
    const auto unit = solution.layout.unit;
    const auto scale = unit * unit / bareSection (plate.common).d11;
    return scale * balancedDeflections (solution.problem, solution.rigidBodyModes, ceramicLoads (plate, solution));
}

PlateSolution withStaticShare (const PlateDescription& plate, PlateSolution solution)
{
    const auto& problem = solution.problem;
    const auto modes = solution.coefficients.cols();
    const Eigen::VectorXd last = solution.coefficients.col (modes - 1);
    const auto massScale = 1 / std::sqrt (last.dot (problem.mass (last).col (0)));
    const auto eigenvalue = massScale * massScale * last.dot (problem.stiffness (last).col (0));
    const auto rest = besides (problem, massScale * solution.coefficients, staticDeflections (plate, solution));
    const auto ritz =
        generalizedEigen (rest.transpose() * problem.stiffness (rest), rest.transpose() * problem.mass (rest));

    if (! ritz || ! (ritz->values[0] > 0))
        throwNumbersTooFarApart();

    const auto highest = solution.angularFrequencies[modes - 1];
    const auto count = modes + ritz->values.size();
    solution.angularFrequencies.conservativeResize (count);
    solution.angularFrequencies.tail (count - modes) = (ritz->values / eigenvalue).cwiseSqrt().cwiseMax (1.0) * highest;
    solution.coefficients.conservativeResize (Eigen::NoChange, count);
    solution.coefficients.rightCols (count - modes) = rest * ritz->vectors / massScale;
    const auto error = solution.frequencyErrors[modes - 1];
    solution.frequencyErrors.conservativeResize (count);
    solution.frequencyErrors.tail (count - modes).setConstant (error);
    return solution;
}

ModalModel solveWithStaticShare (const DeviceDescription& device, std::optional<int> modeCount)
{
    const auto* const plate = std::get_if<PlateDescription> (&device.body);

    if (plate == nullptr || plate->common.ceramics.empty())
        return solveStructure (device, modeCount);

    requireSolvable (*plate);
    const auto solved = asSolved (*plate, modeCount);
    auto model = makeModel (solved, withStaticShare (solved, solvePlateModes (solved, modeCount)));
    describe (model, device.name, plate->common);
    correctFrequencies (model, solved.common);
    validate (model);
    return model;
}
} // namespace antinode
