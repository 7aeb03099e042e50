#include "NormalModeFit.h"

#include "NormalEquations.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
constexpr double gaugeWeight = 1; // of the mean diagonal: fixes lengths that the data leave free.

FitState stateAt (const PreparedResponses& data, LineMoments& moments, const NormalModes& modes, double ridge)
{
    if (! isNear (moments, modes.delay))
        moments = lineMoments (data, modes.delay);

    FitState state;
    state.basis = makeBasis (modes.angularFrequencies, modes.dampingRatios, data);
    state.products = modalProducts (state.basis, data, moments, modes.delay);
    state.reduced = withoutPowers (state.basis, state.products);
    state.groups = groupPoints (data.columnWeights, data.points(), data.references());
    state.columnWeights = data.columnWeights;
    state.strengths = modes.angularFrequencies.cwiseInverse().asDiagonal() * modes.participation;
    state.shapes = bestShapes (state, ridge);
    return state;
}

/** Only products of shape and participation are seen: the length of each mode's participation is held. */
void holdLengths (Eigen::MatrixXd& matrix, const FitState& state)
{
    for (Eigen::Index k = 0; k < state.modes(); ++k)
    {
        const Eigen::VectorXd direction = state.strengths.row (k).normalized();
        double weight = 0;

        for (Eigen::Index i = 0; i < state.references(); ++i)
            weight += gaugeWeight * matrix (state.unknown (k, i), state.unknown (k, i));

        for (Eigen::Index i = 0; i < state.references(); ++i)
            for (Eigen::Index j = 0; j <= i; ++j)
                matrix (state.unknown (k, i), state.unknown (k, j)) += weight * direction[i] * direction[j];
    }
}

void holdDelay (NormalEquations& equations)
{
    const auto last = equations.matrix.rows() - 1;
    equations.matrix.row (last).setZero();
    equations.matrix (last, last) = 1;
    equations.gradient[last] = 0;
}

std::optional<Eigen::VectorXd> solveDamped (Eigen::MatrixXd matrix, const Eigen::VectorXd& right, double damping)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    matrix.diagonal().array() += std::max (damping, 1e-14);
    Eigen::MatrixXd solution = scale.cwiseProduct (right);

    if (! factorLower (matrix))
        return {};

    solveLower (matrix, solution);
    solveLowerTransposed (matrix, solution);
    return Eigen::VectorXd (scale.cwiseProduct (solution.col (0)));
}

/** Modes after a step; no pole moves further than a half width at a time. */
NormalModes stepped (const NormalModes& modes, const FitState& state, const Eigen::VectorXd& step)
{
    auto result = modes;

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto resonance = modes.angularFrequencies[k];

        for (Eigen::Index i = 0; i < state.references(); ++i)
            result.participation (k, i) += resonance * step[state.unknown (k, i)];

        result.angularFrequencies[k] +=
            modes.dampingRatios[k] * resonance * std::clamp (step[state.unknown (k, state.references())], -1.0, 1.0);
        result.dampingRatios[k] = std::clamp (
            modes.dampingRatios[k] * std::exp (std::clamp (step[state.unknown (k, state.references() + 1)], -0.7, 0.7)),
            1e-9, 0.999);
    }

    result.delay += step[state.unknowns() - 1] * state.delayUnit();
    return result;
}

} // namespace

void holdWhatIsNotSeen (NormalEquations& equations, const FitState& state, bool delayIsKnown)
{
    holdLengths (equations.matrix, state);

    if (delayIsKnown)
        holdDelay (equations);
}

NormalModeFit fitNormalModes (const PreparedResponses& data, const NormalModeStart& start, double ridge,
                              double precision, int maximum)
{
    NormalModes modes { start.angularFrequencies, start.dampingRatios, {}, start.participation, start.delay };
    auto moments = lineMoments (data, modes.delay);
    auto state = stateAt (data, moments, modes, ridge);
    auto equations = normalEquations (state, ridge);
    const auto values = 2 * static_cast<double> (data.lines() * (data.columnWeights.array() > 0).count());
    const auto energy = state.reduced.energies.dot (data.columnWeights);
    constexpr double whole = 1e-3; // of damping: hardly any
    double damping = 1e-4;
    int iteration = 0;
    auto isConverged = false;

    for (; iteration < maximum; ++iteration)
    {
        auto held = equations;
        holdWhatIsNotSeen (held, state, start.delayIsKnown);
        const auto step = solveDamped (held.matrix, held.gradient, damping);

        if (! step)
            break;

        const auto expected = step->dot (held.gradient);

        // Nor is what rounding hides worth a step.
        isConverged = expected <= precision * equations.cost / values || expected < 1e-20 * energy;

        if (isConverged)
            break;

        auto nextModes = stepped (modes, state, *step);
        auto nextState = stateAt (data, moments, nextModes, ridge);
        auto next = normalEquations (nextState, ridge);

        const auto rounding = 1e-9 * equations.cost + 1e-14 * energy;
        // A whole step that changes the cost by its rounding ends a fit that has converged.
        isConverged = damping <= whole && std::abs (next.cost - equations.cost) <= rounding;

        if (next.cost > equations.cost + rounding)
        {
            damping = std::max (damping, 1e-6) * 10;

            if (damping > 1e6)
                break;

            continue;
        }

        damping = damping < 1e-9 ? 0 : damping / 10;
        modes = std::move (nextModes);
        state = std::move (nextState);
        equations = std::move (next);

        if (isConverged)
            break;
    }

    modes.shapes = state.shapes;
    return { std::move (modes), std::move (state), equations.cost, iteration, isConverged };
}
Eigen::MatrixXd strongestParticipation (const Eigen::MatrixXd& residues, const PreparedResponses& data)
{
    const auto points = data.points(), references = data.references();
    Eigen::MatrixXd result (residues.rows(), references);

    for (Eigen::Index k = 0; k < residues.rows(); ++k)
    {
        const Eigen::RowVectorXd weighted = residues.row (k).cwiseProduct (data.columnWeights.cwiseSqrt().transpose());
        const Eigen::MatrixXd table = weighted.reshaped (points, references);
        result.row (k) = symmetricEigen (table.transpose() * table).vectors.rightCols (1).transpose();
    }

    return result;
}
} // namespace antinode
