#include "StaticShare.h"

#include "DescribedCeramic.h"
#include "DescribedModel.h"
#include "DescriptionChecks.h"
#include "ElementChain.h"
#include "ImmersedOperators.h"
#include "MeasuredModel.h"
#include "OutlinedModel.h"
#include "PlateSupports.h"
#include "PlateWaves.h"
#include "SolvedPlate.h"

#include <Eigen/SVD>
#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_numerics/BlockLanczos.h>

#include <algorithm>
#include <cmath>
#include <functional>

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

namespace
{
/** What each ceramic does to the splines per volt, unknowns x N_b. */
Eigen::MatrixXd ceramicLoads (const PlateDescription& plate, const PlateSolution& solution)
{
    const auto& layout = solution.layout;
    Eigen::MatrixXd loads (solution.problem.unknowns(), static_cast<Eigen::Index> (layout.patches.size()));

    for (std::size_t i = 0; i < layout.patches.size(); ++i)
    {
        checkWatch();
        loads.col (static_cast<Eigen::Index> (i)) =
            ceramicLoad (solution.problem, plate.common, onLines (plate, layout, i), layout.unit);
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

/** The measured share as one more mode per ceramic at most, behind the others: the sum of shape times participation
   over the squared frequency is the share. */
ModalModel measuredWithStaticShare (ModalModel model)
{
    constexpr double behind = 2, relative = 1e-9;
    // As large as modes of the same mass are: about so much do fingers move them.
    const auto size = std::sqrt (static_cast<double> (model.points()) / model.surface.masses.sum());
    const Eigen::JacobiSVD<Eigen::MatrixXd> parts (model.staticShare, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const auto& values = parts.singularValues();
    const auto before = model.modes();
    const auto count = (values.array() > relative * values[0]).count();
    const auto all = before + count;
    const auto frequency = behind * model.angularFrequencies[before - 1];
    model.angularFrequencies.conservativeResize (all);
    model.dampingRatios.conservativeResize (all);
    model.shapes.conservativeResize (Eigen::NoChange, all);
    model.participation.conservativeResize (all, Eigen::NoChange);
    model.frequencyErrors.resize (0);

    for (Eigen::Index j = 0; j < count; ++j)
    {
        const auto k = before + j;
        model.angularFrequencies[k] = frequency;
        model.dampingRatios[k] = model.dampingRatios[before - 1];
        model.shapes.col (k) = size * parts.matrixU().col (j);
        model.participation.row (k) = frequency * frequency / size * values[j] * parts.matrixV().col (j).transpose();
    }

    model.staticShare.resize (0, 0);
    return model.slopes.size() > 0 ? withSplineSlopes (std::move (model)) : model;
}

ModalModel alignedWithStaticShare (const std::string& name, const PlateDescription& plate, std::optional<int> modeCount)
{
    requireSolvable (plate);
    const auto solved = asSolved (plate, modeCount);
    auto model = makeModel (solved, withStaticShare (solved, solvePlateModes (solved, modeCount)));
    describe (model, name, plate.common);
    correctFrequencies (model, solved.common);
    validate (model);
    return model;
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
    const auto ritz = ritzPairsBehind (std::cref (problem.stiffness), std::cref (problem.mass),
                                       massScale * solution.coefficients, staticDeflections (plate, solution));

    if (! ritz)
        throwNumbersTooFarApart();

    const auto highest = solution.angularFrequencies[modes - 1];
    const auto count = modes + ritz->values.size();
    solution.angularFrequencies.conservativeResize (count);
    solution.angularFrequencies.tail (count - modes) = (ritz->values / eigenvalue).cwiseSqrt().cwiseMax (1.0) * highest;
    solution.coefficients.conservativeResize (Eigen::NoChange, count);
    solution.coefficients.rightCols (count - modes) = ritz->vectors / massScale;
    const auto error = solution.frequencyErrors[modes - 1];
    solution.frequencyErrors.conservativeResize (count);
    solution.frequencyErrors.tail (count - modes).setConstant (error);
    return solution;
}

bool hasStaticShare (const DeviceDescription& device)
{
    const auto has = [] (const auto& body)
    {
        using Body = std::decay_t<decltype (body)>;

        if constexpr (std::is_same_v<Body, MeasuredDevice>)
            return hasStaticShare (*body.drawing);
        else if constexpr (std::is_same_v<Body, ModalModel>)
            return body.staticShare.size() > 0;
        else if constexpr (std::is_same_v<Body, PlateDescription> || std::is_same_v<Body, OutlinedPlate>)
            return ! body.common.ceramics.empty();
        else
            return false;
    };
    return std::visit (has, device.body);
}

ModalModel solveWithStaticShare (const DeviceDescription& device, std::optional<int> modeCount)
{
    if (! hasStaticShare (device))
        return solveStructure (device, modeCount);

    if (const auto* const measured = std::get_if<ModalModel> (&device.body))
        return measuredWithStaticShare (*measured);

    if (const auto* const measured = std::get_if<MeasuredDevice> (&device.body))
    {
        const auto drawn = solveWithStaticShare (*measured->drawing, {});
        return measuredModel (*measured, drawn, drawn.actuators());
    }

    const auto* const outlined = std::get_if<OutlinedPlate> (&device.body);

    if (outlined != nullptr)
        return solveOutlinedWithStaticShare (device.name, *outlined, modeCount);

    const auto& plate = std::get<PlateDescription> (device.body);
    const auto& ceramics = plate.common.ceramics;
    return std::all_of (ceramics.begin(), ceramics.end(), fillsItsRectangle)
               ? alignedWithStaticShare (device.name, plate, modeCount)
               : solveOutlinedWithStaticShare (device.name, outlinedPlate (plate), modeCount);
}
} // namespace antinode
