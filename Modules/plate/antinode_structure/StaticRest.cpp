#include "StaticRest.h"

#include "ImmersedOperators.h"
#include "RigidMotions.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/RitzPairs.h>

namespace antinode
{
namespace
{
[[noreturn]] void throwTooFewModes()
{
    throw InputError ("device", "has too few modes for the static share of the others; allowed: some more modes");
}

/** The loads of the patches that have a moment. */
Eigen::MatrixXd momentLoads (const BendingProblem& problem, const Eigen::MatrixXd& loads)
{
    std::vector<Eigen::Index> columns;

    for (std::size_t p = 0; p < problem.patches.size(); ++p)
        if (problem.patches[p].hasMoment())
            columns.push_back (static_cast<Eigen::Index> (p));

    return loads (Eigen::all, columns);
}

/** What motions leave of the static deflections under loads.
    @param motions  rigid ones and modes, orthonormal in M */
Eigen::MatrixXd deflectionsBeyond (const BendingProblem& problem, const ImmersedOperators& operators,
                                   const Eigen::MatrixXd& motions, const Eigen::MatrixXd& loads)
{
    // K x = f is singular where the plate may move freely; (K + s M) x = f + s M x is not. As a fixed point it gains a
    // factor of 1 + lambda / s a step, lambda the first eigenvalue beyond the modes.
    constexpr int mostSteps = 40;
    constexpr auto converged = 1e-10; // what the last step may change
    const auto shift = eigenvalueUnit (problem);
    const auto factor = factorShifted (operators, -shift);
    const Eigen::MatrixXd weighted = operators.mass * motions;
    const Eigen::MatrixXd rest = loads - weighted * (motions.transpose() * loads);
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero (loads.rows(), loads.cols()), before;

    for (int step = 0; step < mostSteps; ++step)
    {
        checkWatch();
        before = x;
        x = rest + shift * (operators.mass * x);
        factor.solveInPlace (x);
        x -= motions * (weighted.transpose() * x);

        if ((x - before).norm() <= converged * x.norm())
            return x;
    }

    throwTooFewModes();
}
} // namespace

BendingModes withStaticRest (const BendingProblem& problem, BendingModes modes)
{
    const auto operators = immersedOperators (problem, modes.space);
    const auto loads = momentLoads (problem, operators.loads);
    const auto rigid = freeMotions (problem, modes.space, operators.mass);
    Eigen::MatrixXd motions (rigid.rows(), rigid.cols() + modes.coefficients.cols());
    motions << rigid, modes.coefficients;
    const auto pairs = ritzPairsBehind ([&] (const Eigen::MatrixXd& x) { return operators.stiffness * x; },
                                        [&] (const Eigen::MatrixXd& x) { return operators.mass * x; }, motions,
                                        deflectionsBeyond (problem, operators, motions, loads));

    if (! pairs)
        throwTooFewModes();

    const auto count = modes.eigenvalues.size(), all = count + pairs->values.size();
    const auto highest = modes.eigenvalues[count - 1];
    modes.eigenvalues.conservativeResize (all);
    modes.eigenvalues.tail (all - count) = pairs->values.cwiseMax (highest);
    modes.coefficients.conservativeResize (Eigen::NoChange, all);
    modes.coefficients.rightCols (all - count) = pairs->vectors;
    modes.participation = modes.coefficients.transpose() * operators.loads;
    return modes;
}
} // namespace antinode
