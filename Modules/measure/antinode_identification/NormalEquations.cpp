#include "NormalEquations.h"

#include <antinode_numerics/Decompositions.h>

#include <algorithm>
#include <array>

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
} // namespace antinode
