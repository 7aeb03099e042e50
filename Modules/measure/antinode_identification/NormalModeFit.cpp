#include "NormalModeFit.h"

#include <antinode_numerics/Decompositions.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace antinode
{
namespace
{
constexpr std::array poleFunctions { ModalFunction::frequency, ModalFunction::damping, ModalFunction::delay };

/** The part of a matrix over all functions that belongs to one kind in rows and one in columns: N_m x N_m. */
Eigen::MatrixXd part (const Eigen::MatrixXd& gram, ModalFunction row, ModalFunction column)
{
    const auto modes = gram.rows() / realModeFunctions;
    const auto every = [modes] (ModalFunction function)
    { return Eigen::seqN (static_cast<Eigen::Index> (function), modes, Eigen::fix<realModeFunctions>); };
    return gram (every (row), every (column));
}

Eigen::MatrixXd functionRows (const Eigen::MatrixXd& data, ModalFunction function)
{
    const auto modes = data.rows() / realModeFunctions;
    return data (Eigen::seqN (static_cast<Eigen::Index> (function), modes, Eigen::fix<realModeFunctions>), Eigen::all);
}

/** The amount of a function per unit of an unknown, for each mode: unit modes delayed by the delay's unit. */
Eigen::VectorXd functionUnits (const FitState& state, ModalFunction function)
{
    if (function != ModalFunction::delay)
        return Eigen::VectorXd::Ones (state.modes());

    return state.basis.angularFrequencies * state.delayUnit();
}

Eigen::MatrixXd shapeMatrix (const FitState& state, const PointGroup& group, double ridge)
{
    const Eigen::MatrixXd weighted =
        state.strengths * group.referenceWeights.asDiagonal() * state.strengths.transpose();
    Eigen::MatrixXd matrix =
        part (state.reduced.gram, ModalFunction::velocity, ModalFunction::velocity).cwiseProduct (weighted);
    matrix.diagonal() *= 1 + ridge;
    return matrix;
}

/** X: how unknowns of any mode act on the shape of each, N_m x N_m (N_b + 3). */
Eigen::MatrixXd couplingMatrix (const FitState& state, const PointGroup& group)
{
    const auto modes = state.modes(), references = state.references();
    const auto& strengths = state.strengths;
    const auto velocity = part (state.reduced.gram, ModalFunction::velocity, ModalFunction::velocity);
    const Eigen::MatrixXd weighted = strengths * group.referenceWeights.asDiagonal() * strengths.transpose();
    Eigen::MatrixXd result (modes, modes * (references + 3));

    for (Eigen::Index i = 0; i < references; ++i)
        result.middleCols (i * modes, modes) = group.referenceWeights[i] * strengths.col (i).asDiagonal() * velocity;

    for (std::size_t b = 0; b < poleFunctions.size(); ++b)
        result.middleCols ((references + static_cast<Eigen::Index> (b)) * modes, modes) =
            part (state.reduced.gram, ModalFunction::velocity, poleFunctions[b]).cwiseProduct (weighted)
            * functionUnits (state, poleFunctions[b]).asDiagonal();

    return result;
}

/** F: unknowns with each other for unit shapes; lower block triangle of N_m (N_b + 3) squared. */
Eigen::MatrixXd unknownMatrix (const FitState& state, const PointGroup& group)
{
    const auto modes = state.modes(), references = state.references();
    const auto& gram = state.reduced.gram;
    const auto& c = group.referenceWeights;
    const Eigen::MatrixXd weighted = state.strengths * c.asDiagonal() * state.strengths.transpose();
    const auto velocity = part (gram, ModalFunction::velocity, ModalFunction::velocity);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (modes * (references + 3), modes * (references + 3));

    for (Eigen::Index i = 0; i < references; ++i)
        result.block (i * modes, i * modes, modes, modes) = c[i] * velocity;

    for (std::size_t b = 0; b < poleFunctions.size(); ++b)
    {
        const auto row = (references + static_cast<Eigen::Index> (b)) * modes;
        const auto units = functionUnits (state, poleFunctions[b]);
        const auto withVelocity = part (gram, poleFunctions[b], ModalFunction::velocity);

        for (Eigen::Index i = 0; i < references; ++i)
            result.block (row, i * modes, modes, modes) =
                (units.cwiseProduct (state.strengths.col (i)) * c[i]).asDiagonal() * withVelocity;

        for (std::size_t a = 0; a <= b; ++a)
            result.block (row, (references + static_cast<Eigen::Index> (a)) * modes, modes, modes) =
                units.asDiagonal() * part (gram, poleFunctions[b], poleFunctions[a]).cwiseProduct (weighted)
                * functionUnits (state, poleFunctions[a]).asDiagonal();
    }

    return result;
}

Eigen::MatrixXd groupShapes (const FitState& state, const PointGroup& group)
{
    return state.shapes (group.points, Eigen::all);
}

/** Every mode's own delay becomes the common one: their rows and columns are added. */
Eigen::MatrixXd withCommonDelay (const Eigen::MatrixXd& lower, Eigen::Index modes)
{
    const auto others = lower.rows() - modes;
    Eigen::MatrixXd result (others + 1, others + 1);
    result.topLeftCorner (others, others) = lower.topLeftCorner (others, others);
    result.col (others).setZero();
    result.row (others).head (others) = lower.bottomLeftCorner (modes, others).colwise().sum();
    result (others, others) = lower.bottomRightCorner (modes, modes).sum();
    return result;
}

void addGradient (Eigen::VectorXd& gradient, const FitState& state, const Eigen::MatrixXd& errors)
{
    const auto modes = state.modes(), references = state.references(), points = state.shapes.rows();
    const auto velocity = functionRows (errors, ModalFunction::velocity);

    for (Eigen::Index i = 0; i < references; ++i)
    {
        const auto columns = Eigen::seqN (i * points, points);
        const Eigen::MatrixXd weighted = state.columnWeights (columns).asDiagonal() * state.shapes;
        gradient.segment (i * modes, modes) +=
            velocity (Eigen::all, columns).cwiseProduct (weighted.transpose()).rowwise().sum();

        for (std::size_t b = 0; b < poleFunctions.size(); ++b)
        {
            const Eigen::VectorXd sums = functionRows (errors, poleFunctions[b]) (Eigen::all, columns)
                                             .cwiseProduct (weighted.transpose())
                                             .rowwise()
                                             .sum();
            gradient.segment ((references + static_cast<Eigen::Index> (b)) * modes, modes) +=
                sums.cwiseProduct (state.strengths.col (i)).cwiseProduct (functionUnits (state, poleFunctions[b]));
        }
    }
}
} // namespace

std::vector<PointGroup> groupPoints (const Eigen::VectorXd& columnWeights, Eigen::Index points, Eigen::Index references)
{
    std::vector<PointGroup> groups;
    std::vector<std::vector<double>> weights;

    for (Eigen::Index p = 0; p < points; ++p)
    {
        const Eigen::VectorXd ofPoint = columnWeights (Eigen::seqN (p, references, points));
        const auto largest = ofPoint.maxCoeff();

        if (largest <= 0)
            continue;

        const auto same = [&] (const PointGroup& group)
        { return (group.referenceWeights - ofPoint / largest).cwiseAbs().maxCoeff() < 1e-9; };
        auto group = std::find_if (groups.begin(), groups.end(), same);

        if (group == groups.end())
        {
            groups.push_back ({ ofPoint / largest, {}, {} });
            weights.emplace_back();
            group = groups.end() - 1;
        }

        group->points.push_back (p);
        weights[static_cast<std::size_t> (group - groups.begin())].push_back (largest);
    }

    for (std::size_t g = 0; g < groups.size(); ++g)
        groups[g].pointWeights =
            Eigen::Map<const Eigen::VectorXd> (weights[g].data(), static_cast<Eigen::Index> (weights[g].size()));

    return groups;
}

Eigen::MatrixXd bestShapes (const FitState& state, double ridge)
{
    const auto points = state.columnWeights.size() / state.references();
    const auto data = functionRows (state.reduced.data, ModalFunction::velocity);
    Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero (points, state.modes());

    for (const auto& group : state.groups)
    {
        Eigen::MatrixXd right = Eigen::MatrixXd::Zero (state.modes(), static_cast<Eigen::Index> (group.points.size()));

        for (Eigen::Index i = 0; i < state.references(); ++i)
            for (std::size_t n = 0; n < group.points.size(); ++n)
                right.col (static_cast<Eigen::Index> (n)) +=
                    group.referenceWeights[i]
                    * state.strengths.col (i).cwiseProduct (data.col (i * points + group.points[n]));

        shapes (group.points, Eigen::all) = solveSemidefinite (shapeMatrix (state, group, ridge), right).transpose();
    }

    return shapes;
}

Eigen::MatrixXd amplitudes (const FitState& state)
{
    const auto points = state.shapes.rows();
    Eigen::MatrixXd result (state.modes(), points * state.references());

    for (Eigen::Index i = 0; i < state.references(); ++i)
        result.middleCols (i * points, points) = state.strengths.col (i).asDiagonal() * state.shapes.transpose();

    return result;
}

Eigen::MatrixXd residualCoefficients (const FitState& state)
{
    Eigen::MatrixXd ofAll = Eigen::MatrixXd::Zero (realModeFunctions * state.modes(), state.columnWeights.size());
    ofAll (Eigen::seqN (0, state.modes(), Eigen::fix<realModeFunctions>), Eigen::all) = amplitudes (state);
    return powerCoefficients (state.basis, state.products, ofAll);
}

NormalEquations normalEquations (const FitState& state, double ridge)
{
    const auto modes = state.modes(), blocks = state.references() + 3;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (modes * blocks, modes * blocks);

    for (const auto& group : state.groups)
    {
        const auto shapes = groupShapes (state, group);
        const Eigen::MatrixXd products = shapes.transpose() * group.pointWeights.asDiagonal() * shapes;
        Eigen::MatrixXd perUnit = unknownMatrix (state, group), factor = shapeMatrix (state, group, ridge);
        factorLower (factor);
        Eigen::MatrixXd whitened = couplingMatrix (state, group);
        solveLower (factor, whitened);
        addGram (perUnit, -1, whitened.transpose());

        for (Eigen::Index a = 0; a < blocks; ++a)
            for (Eigen::Index b = 0; b <= a; ++b)
                sum.block (a * modes, b * modes, modes, modes) +=
                    perUnit.block (a * modes, b * modes, modes, modes).cwiseProduct (products);
    }

    // Blocks on the diagonal were added in their lower triangles only.
    Eigen::MatrixXd whole = sum.selfadjointView<Eigen::Lower>();
    NormalEquations result;
    result.matrix = withCommonDelay (whole, modes);

    const auto given = amplitudes (state);
    const auto data = functionRows (state.reduced.data, ModalFunction::velocity);
    Eigen::MatrixXd errors = state.reduced.data;
    const Eigen::MatrixXd toVelocity =
        state.reduced.gram (Eigen::all, Eigen::seqN (0, modes, Eigen::fix<realModeFunctions>));
    addProduct (errors, -1, toVelocity, given);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero (modes * blocks);
    addGradient (gradient, state, errors);
    result.gradient.resize (state.unknowns());
    result.gradient << gradient.head (state.unknowns() - 1), gradient.tail (modes).sum();
    const Eigen::VectorXd costs =
        state.reduced.energies
        - (given.cwiseProduct (data + functionRows (errors, ModalFunction::velocity))).colwise().sum().transpose();
    result.cost = std::max (0.0, costs.dot (state.columnWeights));
    return result;
}

ShapeCoupling shapeCoupling (const FitState& state, const PointGroup& group, double ridge)
{
    const auto coupling = couplingMatrix (state, group);
    Eigen::MatrixXd right (state.modes(), coupling.cols() + state.modes());
    right << coupling, Eigen::MatrixXd::Identity (state.modes(), state.modes());
    const auto solved = solveSemidefinite (shapeMatrix (state, group, ridge), right);
    Eigen::MatrixXd inverse = solved.rightCols (state.modes());
    Eigen::VectorXd diagonal = inverse.diagonal();
    return { solved.leftCols (coupling.cols()), std::move (inverse), std::move (diagonal) };
}

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
