#include "WaveformDual.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <cmath>

namespace antinode
{
namespace
{
/** Where the samples of one ceramic are not at their limit. */
std::vector<Eigen::Index> freeSamples (const Eigen::MatrixXd& pulls, const Eigen::MatrixXd& caps, Eigen::Index i)
{
    std::vector<Eigen::Index> found;

    for (Eigen::Index n = 0; n < pulls.cols(); ++n)
        if (std::abs (pulls (i, n)) < caps (i, n))
            found.push_back (n);

    return found;
}
} // namespace

WaveformDual::WaveformDual (const BoundedWaveformProblem& problem)
    : roots (Eigen::VectorXd::Ones (problem.weights.cols())), participation (problem.participation)
{
    if (problem.costs.size() > 0)
        roots = problem.costs.cwiseSqrt();

    caps = problem.limits * roots.transpose();
    weights = problem.weights * roots.cwiseInverse().asDiagonal();
    scale = (weights.rowwise().norm().array() * participation.rowwise().norm().array()).matrix();

    for (auto& value : scale)
        value = value > 0 ? 1 / value : 0;

    participation = scale.asDiagonal() * participation;
    wanted = scale.cwiseProduct (problem.wanted);
    compliance = scale.cwiseAbs2().cwiseProduct (problem.compliance);
    gram = Eigen::MatrixXd::Zero (weights.rows(), weights.rows());
    addGram (gram, 1, weights);
}

Eigen::MatrixXd WaveformDual::computePulls (const Eigen::VectorXd& y) const
{
    const Eigen::MatrixXd gains = y.asDiagonal() * participation;
    Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero (gains.cols(), weights.cols());
    addTransposedLeft (pulls, 1, gains, weights);
    return pulls;
}

Eigen::MatrixXd WaveformDual::clipped (const Eigen::MatrixXd& pulls) const
{
    return pulls.cwiseMin (caps).cwiseMax (-caps);
}

Eigen::VectorXd WaveformDual::rowValues (const Eigen::MatrixXd& samples) const
{
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero (weights.rows(), samples.rows());
    addTransposedRight (seen, 1, weights, samples);
    return seen.cwiseProduct (participation).rowwise().sum();
}

double WaveformDual::value (const Eigen::VectorXd& y, const Eigen::MatrixXd& pulls) const
{
    const auto played = clipped (pulls);
    return wanted.dot (y) - played.cwiseProduct (pulls).sum() + 0.5 * played.squaredNorm()
           - 0.5 * compliance.dot (y.cwiseAbs2());
}

double WaveformDual::objective (const Eigen::MatrixXd& samples) const
{
    const auto values = rowValues (samples);
    double soft = 0;

    for (Eigen::Index k = 0; k < values.size(); ++k)
        if (compliance[k] > 0)
            soft += values[k] * values[k] / compliance[k];

    return 0.5 * (samples.squaredNorm() + soft);
}

Eigen::MatrixXd WaveformDual::curvature (const Eigen::MatrixXd& pulls) const
{
    Eigen::MatrixXd sum = compliance.asDiagonal();

    for (Eigen::Index i = 0; i < pulls.rows(); ++i)
    {
        checkWatch();
        const Eigen::MatrixXd part = seenBy (freeSamples (pulls, caps, i));
        const auto column = participation.col (i);

        for (Eigen::Index k = 0; k < sum.cols(); ++k)
            sum.col (k).tail (sum.rows() - k) +=
                column[k] * column.tail (sum.rows() - k).cwiseProduct (part.col (k).tail (sum.rows() - k));
    }

    return sum;
}

/** The lower triangle of W W' over some samples: over them, or over all less the others, whichever are fewer. */
Eigen::MatrixXd WaveformDual::seenBy (const std::vector<Eigen::Index>& samples) const
{
    const auto count = static_cast<Eigen::Index> (samples.size());

    if (count == weights.cols())
        return gram;

    if (2 * count <= weights.cols())
    {
        Eigen::MatrixXd part = Eigen::MatrixXd::Zero (gram.rows(), gram.cols());
        addGram (part, 1, weights (Eigen::all, samples));
        return part;
    }

    std::vector<Eigen::Index> others;

    for (Eigen::Index n = 0, next = 0; n < weights.cols(); ++n)
        if (next < count && samples[static_cast<std::size_t> (next)] == n)
            ++next;
        else
            others.push_back (n);

    Eigen::MatrixXd part = gram;
    addGram (part, -1, weights (Eigen::all, others));
    return part;
}
} // namespace antinode
