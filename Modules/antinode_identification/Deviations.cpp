#include "Deviations.h"

#include "NormalModeFit.h"

#include <antinode_numerics/DenseKernels.h>

#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
/** How the length of one mode's shape follows all unknowns, relative to itself, with its sign turned. */
Eigen::VectorXd lengthChange (const FitState& state, const std::vector<ShapeCoupling>& couplings, Eigen::Index mode)
{
    const auto modes = state.modes(), others = state.unknowns() - 1;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero (modes * (state.references() + 3));

    for (std::size_t g = 0; g < state.groups.size(); ++g)
    {
        const Eigen::MatrixXd shapes = state.shapes (state.groups[g].points, Eigen::all);
        const Eigen::VectorXd withOthers = shapes.transpose() * shapes.col (mode);

        for (Eigen::Index a = 0; a < state.references() + 3; ++a)
            sum.segment (a * modes, modes) +=
                couplings[g].perUnknown.row (mode).segment (a * modes, modes).transpose().cwiseProduct (withOthers);
    }

    Eigen::VectorXd result (state.unknowns());
    result << sum.head (others), sum.tail (modes).sum();
    return result / state.shapes.col (mode).squaredNorm();
}

/** The part of the variance of the length, relative, that the unknowns do not cause. */
double ownLengthVariance (const FitState& state, const std::vector<ShapeCoupling>& couplings, Eigen::Index mode)
{
    double sum = 0;

    for (std::size_t g = 0; g < state.groups.size(); ++g)
        for (std::size_t n = 0; n < state.groups[g].points.size(); ++n)
            sum += std::pow (state.shapes (state.groups[g].points[n], mode), 2) * couplings[g].inverseDiagonal[mode]
                   / state.groups[g].pointWeights[static_cast<Eigen::Index> (n)];

    return sum / std::pow (state.shapes.col (mode).squaredNorm(), 2);
}

/** What the data do not tell apart is lifted until it can be factored: it is then known badly, all else as well as it
    is. */
Eigen::MatrixXd inverse (Eigen::MatrixXd matrix)
{
    const Eigen::VectorXd scale = matrix.diagonal().cwiseMax (1e-300).cwiseSqrt().cwiseInverse();
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();

    for (auto lift = 1e-14;; lift *= 10)
    {
        if (lift > 1)
            return matrix * std::numeric_limits<double>::infinity();

        Eigen::MatrixXd factor = matrix;
        factor.diagonal().array() += lift;

        if (! factorLower (factor))
            continue;

        Eigen::MatrixXd result = Eigen::MatrixXd::Identity (matrix.rows(), matrix.cols());
        solveLower (factor, result);
        solveLowerTransposed (factor, result);
        return scale.asDiagonal() * result * scale.asDiagonal();
    }
}

void addShapes (ModeDeviations& result, const FitState& state, const std::vector<ShapeCoupling>& couplings,
                double variance)
{
    result.shapes.setConstant (state.shapes.rows(), state.modes(), std::numeric_limits<double>::quiet_NaN());

    for (std::size_t g = 0; g < state.groups.size(); ++g)
        for (std::size_t n = 0; n < state.groups[g].points.size(); ++n)
            result.shapes.row (state.groups[g].points[n]) =
                (couplings[g].inverseDiagonal.transpose()
                 * (variance / 2 / state.groups[g].pointWeights[static_cast<Eigen::Index> (n)]))
                    .cwiseSqrt();
}
} // namespace

ModeDeviations computeDeviations (const FitState& state, double variance, bool delayIsKnown, double ridge)
{
    auto equations = normalEquations (state, ridge);
    holdWhatIsNotSeen (equations, state, delayIsKnown);
    // Real and imaginary part have half of the variance each.
    const Eigen::MatrixXd covariance = inverse (std::move (equations.matrix)) * (variance / 2);
    std::vector<ShapeCoupling> couplings;

    for (const auto& group : state.groups)
        couplings.push_back (shapeCoupling (state, group, ridge));

    ModeDeviations result { Eigen::VectorXd (state.modes()),
                            Eigen::VectorXd (state.modes()),
                            {},
                            Eigen::MatrixXd (state.modes(), state.references()),
                            0 };
    const auto deviation = [&covariance] (Eigen::Index n) { return std::sqrt (covariance (n, n)); };

    for (Eigen::Index k = 0; k < state.modes(); ++k)
    {
        const auto resonance = state.basis.angularFrequencies[k], damping = state.basis.dampingRatios[k];
        result.angularFrequencies[k] = damping * resonance * deviation (state.unknown (k, state.references()));
        result.dampingRatios[k] = damping * deviation (state.unknown (k, state.references() + 1));
        const auto change = lengthChange (state, couplings, k);
        const Eigen::VectorXd withAll = covariance * change;
        const auto own = ownLengthVariance (state, couplings, k) * variance / 2;

        // A strength at fixed length of the shape: itself plus what the length changed by, in units of itself.
        for (Eigen::Index i = 0; i < state.references(); ++i)
        {
            const auto strength = state.strengths (k, i);
            const auto n = state.unknown (k, i);
            result.participation (k, i) =
                resonance
                * std::sqrt (std::max (0.0, covariance (n, n) - 2 * strength * withAll[n]
                                                + strength * strength * (change.dot (withAll) + own)));
        }
    }

    addShapes (result, state, couplings, variance);
    result.delay = delayIsKnown ? 0 : deviation (state.unknowns() - 1) * state.delayUnit();
    return result;
}
} // namespace antinode
