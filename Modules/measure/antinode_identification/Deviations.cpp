#include "Deviations.h"

#include "NormalModeFit.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
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
/** What deviations are computed from at the end of a fit. */
struct Curvature
{
    Eigen::MatrixXd inverse; ///< Of the normal equations.
    std::vector<ShapeCoupling> couplings;
    Eigen::MatrixXd lengthChanges; ///< U x N_m
};

Curvature curvatureOf (const FitState& state, bool delayIsKnown, double ridge)
{
    auto equations = normalEquations (state, ridge);
    holdWhatIsNotSeen (equations, state, delayIsKnown);
    Curvature result { inverse (std::move (equations.matrix)), {}, { state.unknowns(), state.modes() } };

    for (const auto& group : state.groups)
        result.couplings.push_back (shapeCoupling (state, group, ridge));

    for (Eigen::Index k = 0; k < state.modes(); ++k)
        result.lengthChanges.col (k) = lengthChange (state, result.couplings, k);

    return result;
}

ModeDeviations noiseDeviations (const FitState& state, const Curvature& curvature, double variance, bool delayIsKnown)
{
    // Real and imaginary part have half of the variance each.
    const Eigen::MatrixXd covariance = curvature.inverse * (variance / 2);
    Eigen::MatrixXd withLengths = Eigen::MatrixXd::Zero (state.unknowns(), state.modes());
    addProduct (withLengths, 1, covariance, curvature.lengthChanges);
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
        const auto change = curvature.lengthChanges.col (k);
        const auto withAll = withLengths.col (k);
        const auto own = ownLengthVariance (state, curvature.couplings, k) * variance / 2;

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

    addShapes (result, state, curvature.couplings, variance);
    result.delay = delayIsKnown ? 0 : deviation (state.unknowns() - 1) * state.delayUnit();
    return result;
}

/** Weighted mean square of a mode's frequencies at single points about their mean, half widths squared, from what that
    does to the variance of the mean. */
double frequencySpread (const FitState& state, Eigen::Index mode, double varianceOfMean)
{
    double sum = 0, squares = 0;

    for (const auto& group : state.groups)
        for (std::size_t n = 0; n < group.points.size(); ++n)
        {
            const auto share =
                group.pointWeights[static_cast<Eigen::Index> (n)] * std::pow (state.shapes (group.points[n], mode), 2);
            sum += share;
            squares += share * share;
        }

    return std::max (0.0, varianceOfMean) * sum * sum / std::max (squares, 1e-300);
}

/** Linear functions of the unknowns: all of them, but strengths at fixed lengths of their shapes. U x U */
Eigen::MatrixXd statedFunctions (const FitState& state, const Curvature& curvature, bool delayIsKnown)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Identity (state.unknowns(), state.unknowns());

    for (Eigen::Index k = 0; k < state.modes(); ++k)
        for (Eigen::Index i = 0; i < state.references(); ++i)
            result.col (state.unknown (k, i)) -= state.strengths (k, i) * curvature.lengthChanges.col (k);

    if (delayIsKnown)
        result.row (state.unknowns() - 1).setZero();

    return result;
}

/** What references show of a shape: its deviations over those of noise, and the deviation of its length, relative. */
struct ShapeSpread
{
    double overNoise = 1, length = 0;
};

/** Deviations of one mode become those of clusters where these are larger. @param scatter  of statedFunctions */
void enlarge (ModeDeviations& stated, const FitState& state, Eigen::Index k, const Eigen::VectorXd& scatter,
              const ShapeSpread& shape)
{
    const auto resonance = state.basis.angularFrequencies[k], damping = state.basis.dampingRatios[k];
    const auto ofFrequency = scatter[state.unknown (k, state.references())]; // in half widths
    const auto noise = stated.angularFrequencies[k] / (damping * resonance);
    const auto take = [&] (double& value, double by) { value = std::max (value, by); };
    take (stated.angularFrequencies[k], damping * resonance * ofFrequency);
    take (stated.dampingRatios[k], damping * scatter[state.unknown (k, state.references() + 1)]);

    for (Eigen::Index i = 0; i < state.references(); ++i)
        take (stated.participation (k, i),
              resonance * std::hypot (scatter[state.unknown (k, i)], state.strengths (k, i) * shape.length));

    // Resonances that differ widen the common one by their mean square, and lower shapes by a quarter of theirs.
    const auto spread = frequencySpread (state, k, ofFrequency * ofFrequency - noise * noise);
    stated.dampingRatios[k] = std::hypot (stated.dampingRatios[k], damping * spread);
    stated.shapes.col (k) = ((stated.shapes.col (k).array() * shape.overNoise).square()
                             + (state.shapes.col (k).array() * (spread / 3)).square())
                                .sqrt();
}
} // namespace

ModeDeviations computeDeviations (const FitState& state, double variance, bool delayIsKnown, double ridge)
{
    return noiseDeviations (state, curvatureOf (state, delayIsKnown, ridge), variance, delayIsKnown);
}

StatedDeviations stateDeviations (const FitState& state, const ErrorVariances& variances, bool delayIsKnown,
                                  double ridge)
{
    const auto curvature = curvatureOf (state, delayIsKnown, ridge);
    const auto scores = clusterScores (state, curvature.couplings);
    // Clusters show what misfit does. Where there are none, it counts as noise.
    const auto variance = scores.unknowns.empty() ? variances.left : variances.noise;
    StatedDeviations result { noiseDeviations (state, curvature, variances.noise, delayIsKnown),
                              noiseDeviations (state, curvature, variance, delayIsKnown) };
    const Eigen::VectorXd scatter =
        clusterVariances (scores.unknowns, curvature.inverse, statedFunctions (state, curvature, delayIsKnown))
            .cwiseSqrt();

    for (Eigen::Index k = 0; k < state.modes(); ++k)
    {
        // A single reference has no other to disagree with.
        const auto least = state.references() > 1 ? 1.0 : variances.left / variance;
        const auto ofShapes = std::sqrt (std::max (least, scores.shapeSpreads[k] / (variance / 2)));
        const auto length = ofShapes * std::sqrt (ownLengthVariance (state, curvature.couplings, k) * variance / 2);
        enlarge (result.stated, state, k, scatter, { ofShapes, length });
    }

    if (! delayIsKnown)
        result.stated.delay = std::max (result.stated.delay, scatter[state.unknowns() - 1] * state.delayUnit());

    return result;
}

StatedDeviations statedForComplex (StatedDeviations ofReal, const ErrorVariances& realVariances,
                                   const FreeResidues& fit, const ErrorVariances& variances,
                                   const PreparedResponses& data, double ridge)
{
    auto equations = poleEquations (fit.basis, fit.products, data.columnWeights, ridge);
    const auto curvature = inverse (std::move (equations.matrix));
    const auto modes = fit.basis.modes();
    const auto scores = clustered (equations.scores, data.columnWeights, data.points());
    const auto ofVariance = [&] (double variance) -> Eigen::VectorXd
    { return (curvature.diagonal() * (variance / 2)).cwiseSqrt(); };
    const Eigen::VectorXd scatter =
        clusterVariances (scores, curvature, Eigen::MatrixXd::Identity (2 * modes, 2 * modes)).cwiseSqrt();
    const auto take = [&] (ModeDeviations& deviations, const Eigen::VectorXd& relative, double ratio)
    {
        const auto scale = std::sqrt (ratio);
        deviations.dampingRatios = fit.basis.dampingRatios.cwiseProduct (relative.tail (modes));
        deviations.angularFrequencies =
            fit.basis.angularFrequencies.cwiseProduct (fit.basis.dampingRatios).cwiseProduct (relative.head (modes));
        deviations.shapes *= scale;
        deviations.participation *= scale;
        deviations.delay *= scale;
    };
    take (ofReal.noise, ofVariance (variances.noise), variances.noise / std::max (realVariances.noise, 1e-300));
    take (ofReal.stated, ofVariance (scores.empty() ? variances.left : variances.noise).cwiseMax (scatter),
          variances.left / std::max (realVariances.left, 1e-300));
    return ofReal;
}

namespace
{
auto everyFunction (const FitState& state, ModalFunction function)
{
    return Eigen::seqN (static_cast<Eigen::Index> (function), state.modes(), Eigen::fix<realModeFunctions>);
}

/** Scores of the channels of one reference for the unknowns, U x N_p, and for the shapes, N_m x N_p. */
struct ReferenceScores
{
    Eigen::MatrixXd unknowns, shapes;
};

ReferenceScores referenceScores (const FitState& state, const Eigen::MatrixXd& errors, Eigen::Index reference)
{
    const auto modes = state.modes(), references = state.references(), points = state.shapes.rows();
    const auto columns = Eigen::seqN (reference * points, points);
    const Eigen::VectorXd weights = state.columnWeights (columns);
    const Eigen::VectorXd strengths = state.strengths.col (reference);
    const Eigen::MatrixXd weighted = state.shapes.transpose() * weights.asDiagonal();
    const auto of = [&] (ModalFunction function) -> Eigen::MatrixXd
    { return errors (everyFunction (state, function), columns); };
    const auto velocity = of (ModalFunction::velocity);
    ReferenceScores result { Eigen::MatrixXd::Zero (state.unknowns(), points),
                             strengths.asDiagonal() * velocity * weights.asDiagonal() };
    result.unknowns.middleRows (reference * modes, modes) = velocity.cwiseProduct (weighted);
    result.unknowns.middleRows (references * modes, modes) =
        strengths.asDiagonal() * of (ModalFunction::frequency).cwiseProduct (weighted);
    result.unknowns.middleRows ((references + 1) * modes, modes) =
        strengths.asDiagonal() * of (ModalFunction::damping).cwiseProduct (weighted);
    const Eigen::VectorXd delays = strengths.cwiseProduct (state.basis.angularFrequencies) * state.delayUnit();
    result.unknowns.bottomRows (1) = delays.transpose() * of (ModalFunction::delay).cwiseProduct (weighted);
    return result;
}

/** Takes out of scores what the best shapes of the same channels take up. */
void eliminateShapes (ReferenceScores& scores, const FitState& state, const std::vector<ShapeCoupling>& couplings)
{
    const auto modes = state.modes(), blocks = state.references() + 3;

    for (std::size_t g = 0; g < state.groups.size(); ++g)
    {
        const auto& points = state.groups[g].points;
        const Eigen::MatrixXd ofShapes = couplings[g].perUnknown.transpose() * scores.shapes (Eigen::all, points);
        const Eigen::MatrixXd shapes = state.shapes (points, Eigen::all).transpose();

        for (Eigen::Index a = 0; a < blocks; ++a)
        {
            const Eigen::MatrixXd part = ofShapes.middleRows (a * modes, modes).cwiseProduct (shapes);

            if (a + 1 < blocks)
                scores.unknowns (Eigen::seqN (a * modes, modes), points) -= part;
            else
                scores.unknowns (Eigen::seqN (a * modes, 1), points) -= part.colwise().sum();
        }
    }
}

/** Adds squares of the steps of the shapes when a reference is left out, over the curvature's variances, as means over
    points. */
void addShapeSpreads (Eigen::VectorXd& spreads, const ReferenceScores& scores, const FitState& state,
                      const std::vector<ShapeCoupling>& couplings, Eigen::Index reference)
{
    constexpr double least = 0.05; // of what the other references say of a shape
    const Eigen::VectorXd others = (1
                                    - state.strengths.col (reference).array().square()
                                          / state.strengths.rowwise().squaredNorm().array().max (1e-300))
                                       .max (least);
    double points = 0;

    for (const auto& group : state.groups)
        points += static_cast<double> (group.points.size());

    for (std::size_t g = 0; g < state.groups.size(); ++g)
    {
        const auto& group = state.groups[g];
        const Eigen::MatrixXd steps = couplings[g].inverse * scores.shapes (Eigen::all, group.points)
                                      * group.pointWeights.cwiseSqrt().cwiseInverse().asDiagonal();
        spreads +=
            steps.rowwise().squaredNorm().cwiseQuotient (couplings[g].inverseDiagonal.cwiseProduct (others.cwiseAbs2()))
            / points;
    }
}

double activeCount (const Eigen::VectorXd& weights)
{
    return static_cast<double> ((weights.array() > 0).count());
}
} // namespace

std::vector<Eigen::MatrixXd> clustered (const Eigen::MatrixXd& channelScores, const Eigen::VectorXd& columnWeights,
                                        Eigen::Index points)
{
    constexpr double fewestPoints = 4, fewestReferences = 3;
    const auto references = channelScores.cols() / points;
    Eigen::MatrixXd byPoint = Eigen::MatrixXd::Zero (channelScores.rows(), points);
    Eigen::MatrixXd byReference (channelScores.rows(), references);
    Eigen::VectorXd ofPoints = Eigen::VectorXd::Zero (points), ofReferences (references);

    for (Eigen::Index i = 0; i < references; ++i)
    {
        const auto columns = channelScores.middleCols (i * points, points);
        byPoint += columns;
        byReference.col (i) = columns.rowwise().sum();
        ofPoints += columnWeights.segment (i * points, points);
        ofReferences[i] = columnWeights.segment (i * points, points).sum();
    }

    std::vector<Eigen::MatrixXd> result;

    if (activeCount (ofPoints) >= fewestPoints)
        result.push_back (std::move (byPoint));

    if (activeCount (ofReferences) >= fewestReferences)
        result.push_back (std::move (byReference));

    if (result.empty() && activeCount (columnWeights) >= fewestPoints)
        result.push_back (channelScores);

    return result;
}

ClusterScores clusterScores (const FitState& state, const std::vector<ShapeCoupling>& couplings)
{
    const auto points = state.shapes.rows(), references = state.references();
    const Eigen::MatrixXd toVelocity = state.reduced.gram (Eigen::all, everyFunction (state, ModalFunction::velocity));
    const Eigen::MatrixXd errors = state.reduced.data - toVelocity * amplitudes (state);
    Eigen::MatrixXd ofChannels (state.unknowns(), points * references);
    ClusterScores result { {}, Eigen::VectorXd::Zero (state.modes()) };

    for (Eigen::Index i = 0; i < references; ++i)
    {
        auto scores = referenceScores (state, errors, i);
        eliminateShapes (scores, state, couplings);
        addShapeSpreads (result.shapeSpreads, scores, state, couplings, i);
        ofChannels.middleCols (i * points, points) = scores.unknowns;
    }

    result.unknowns = clustered (ofChannels, state.columnWeights, points);
    result.shapeSpreads *= static_cast<double> (references - 1) / static_cast<double> (references);
    return result;
}

Eigen::VectorXd clusterVariances (const std::vector<Eigen::MatrixXd>& clusters, const Eigen::MatrixXd& inverse,
                                  const Eigen::MatrixXd& functions)
{
    Eigen::VectorXd largest = Eigen::VectorXd::Zero (functions.cols());

    for (const auto& scores : clusters)
    {
        const auto count = static_cast<double> ((scores.colwise().squaredNorm().array() > 0).count());
        Eigen::MatrixXd steps = Eigen::MatrixXd::Zero (inverse.rows(), scores.cols());
        Eigen::MatrixXd changes = Eigen::MatrixXd::Zero (functions.cols(), scores.cols());
        addProduct (steps, 1, inverse, scores);
        addTransposedLeft (changes, 1, functions, steps);
        const Eigen::VectorXd sums = changes.rowwise().squaredNorm();
        largest = largest.cwiseMax (sums * (count / std::max (count - 1, 1.0)));
    }

    return largest;
}
} // namespace antinode
