#include "WaveformDual.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
WaveformDual::WaveformDual (const BoundedWaveformProblem& problem)
    : roots (Eigen::VectorXd::Ones (problem.weights.cols())), participation (problem.participation)
{
    if (problem.costs.size() > 0)
        roots = problem.costs.cwiseSqrt();

    caps = problem.limits * roots.transpose();

    if (problem.shares.size() > 0)
        caps = caps.cwiseProduct (problem.shares);

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

Eigen::MatrixXd WaveformDual::curvature (const Eigen::MatrixXd& pulls, FreeGrams& seen) const
{
    Eigen::MatrixXd sum = compliance.asDiagonal();
    seen.follow (pulls, caps);

    for (Eigen::Index i = 0; i < pulls.rows(); ++i)
    {
        checkWatch();
        const auto& part = seen.of (i);
        const auto column = participation.col (i);

        for (Eigen::Index k = 0; k < sum.cols(); ++k)
            sum.col (k).tail (sum.rows() - k) +=
                column[k] * column.tail (sum.rows() - k).cwiseProduct (part.col (k).tail (sum.rows() - k));
    }

    return sum;
}
} // namespace antinode
