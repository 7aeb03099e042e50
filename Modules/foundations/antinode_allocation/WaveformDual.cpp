#include "WaveformDual.h"

#include <antinode_numerics/DenseKernels.h>

namespace antinode
{
WaveformDual::WaveformDual (const BoundedWaveformProblem& problem)
    : roots (Eigen::VectorXd::Ones (problem.weights.cols())), participation (problem.participation),
      spread (problem.spread)
{
    if (problem.costs.size() > 0)
        roots = problem.costs.cwiseSqrt();

    whole = problem.limits * roots.transpose();
    limit (1, problem.shares);
    weights = problem.weights * roots.cwiseInverse().asDiagonal();
    scale = (weights.rowwise().norm().array() * participation.rowwise().norm().array()).matrix();

    for (auto& value : scale)
        value = value > 0 ? 1 / value : 0;

    participation = scale.asDiagonal() * participation;
    wanted = scale.cwiseProduct (problem.wanted);
    compliance = scale.cwiseAbs2().cwiseProduct (problem.compliance);
}

void WaveformDual::limit (double share, const Eigen::MatrixXd& shares)
{
    caps = share * whole;

    if (shares.size() > 0)
        caps = caps.cwiseProduct (shares);
}

Eigen::MatrixXd WaveformDual::computePulls (const WaveformMultipliers& y) const
{
    Eigen::MatrixXd gains = y.rows.asDiagonal() * participation;

    if (hasOwnRows())
        gains += spread.cwiseProduct (y.own);

    Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero (gains.cols(), weights.cols());
    addTransposedLeft (pulls, 1, gains, weights);
    return pulls;
}

Eigen::MatrixXd WaveformDual::clipped (const Eigen::MatrixXd& pulls) const
{
    return pulls.cwiseMin (caps).cwiseMax (-caps);
}

WaveformMultipliers WaveformDual::values (const Eigen::MatrixXd& samples) const
{
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero (weights.rows(), samples.rows());
    addTransposedRight (seen, 1, weights, samples);
    WaveformMultipliers values { seen.cwiseProduct (participation).rowwise().sum(), {} };

    if (hasOwnRows())
        values.own = seen.cwiseProduct (spread);

    return values;
}

WaveformMultipliers WaveformDual::slope (const WaveformMultipliers& y, const Eigen::MatrixXd& pulls) const
{
    auto slope = values (clipped (pulls));
    slope.rows = wanted - slope.rows - compliance.cwiseProduct (y.rows);

    if (hasOwnRows())
        slope.own = -slope.own - y.own;

    return slope;
}

double WaveformDual::value (const WaveformMultipliers& y, const Eigen::MatrixXd& pulls) const
{
    const auto played = clipped (pulls);
    return wanted.dot (y.rows) - played.cwiseProduct (pulls).sum() + 0.5 * played.squaredNorm()
           - 0.5 * compliance.dot (y.rows.cwiseAbs2()) - 0.5 * y.own.squaredNorm();
}

double WaveformDual::softCost (const Eigen::MatrixXd& samples) const
{
    const auto seen = values (samples);
    auto soft = seen.own.squaredNorm();

    for (Eigen::Index k = 0; k < seen.rows.size(); ++k)
        if (compliance[k] > 0)
            soft += seen.rows[k] * seen.rows[k] / compliance[k];

    return 0.5 * soft;
}

WaveformMultipliers WaveformDual::scaled (const WaveformMultipliers& ofProblem) const
{
    auto y = ofProblem;
    y.rows = (scale.array() > 0).select (y.rows.cwiseQuotient (scale), 0.0);

    if (hasOwnRows() && y.own.size() == 0)
        y.own = Eigen::MatrixXd::Zero (spread.rows(), spread.cols());

    return y;
}

WaveformMultipliers WaveformDual::unscaled (const WaveformMultipliers& y) const
{
    return { scale.cwiseProduct (y.rows), y.own };
}
} // namespace antinode
