#include "ClusterScores.h"

#include <antinode_numerics/DenseKernels.h>

#include <algorithm>

namespace antinode
{
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
