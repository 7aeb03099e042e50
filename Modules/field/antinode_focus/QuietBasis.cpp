#include "QuietBasis.h"

#include <antinode_numerics/DenseKernels.h>

#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double knotsPerSecond = 4000; // of the splines that a correction consists of: to about 1 kHz
constexpr auto guardStiffening = 1e4;   // of guards against changes: less felt elsewhere is to leave the field as it is

double cubicSpline (double knots)
{
    const auto distance = std::abs (knots);

    if (distance < 1)
        return 2.0 / 3 - distance * distance * (1 - 0.5 * distance);

    return distance < 2 ? std::pow (2 - distance, 3) / 6 : 0;
}

/** Cubic B-splines that begin and end within so many samples, one a row. A knot is at the focus, and the two beside it
   count as one: so no sum of them has a slope there, which all stiff modes would follow. */
Eigen::MatrixXd sampledSplines (Eigen::Index samples, Eigen::Index focus, double sampleRate)
{
    constexpr double reach = 2; // knots
    const auto perKnot = sampleRate / knotsPerSecond;
    const auto place = [&] (Eigen::Index n) { return static_cast<double> (n - focus) / perKnot; };
    const auto first = static_cast<int> (std::ceil (place (0) + reach));
    const auto last = static_cast<int> (std::floor (place (samples - 1) - reach));
    std::vector<int> centres;

    for (auto centre = first; centre <= last; ++centre)
        if (centre != 1)
            centres.push_back (centre);

    Eigen::MatrixXd splines (centres.size(), samples);

    for (Eigen::Index n = 0; n < samples; ++n)
        for (Eigen::Index m = 0; m < splines.rows(); ++m)
        {
            const auto centre = centres[static_cast<std::size_t> (m)];
            splines (m, n) = cubicSpline (place (n) - centre) + (centre == -1 ? cubicSpline (place (n) - 1) : 0);
        }

    return splines;
}
} // namespace

QuietBasis::QuietBasis (const QuietTask& task, Playback playback, Eigen::Index samples)
    : participation (task.problem.participation), costs (task.problem.costs), range (task.range),
      splines (sampledSplines (samples, task.range.focus, playback.sampleRate))
{
    const auto count = task.problem.weights.rows();
    const std::vector<int> modes (task.modes.begin(), task.modes.begin() + count);
    rowWaves = task.problem.weights * costs.cwiseInverse().asDiagonal();
    gram = Eigen::MatrixXd::Zero (count, count);
    addTransposedRight (gram, 1, task.problem.weights, rowWaves);
    Eigen::MatrixXd overlaps = Eigen::MatrixXd::Zero (count, count);
    addTransposedRight (overlaps, 1, participation, participation);
    gram = gram.cwiseProduct (overlaps);
    gram.diagonal() += task.problem.compliance / guardStiffening;
    scale = (gram.diagonal().array() > 0).select (gram.diagonal().cwiseSqrt().cwiseInverse(), 0.0);
    factor = scale.asDiagonal() * gram * scale.asDiagonal();
    factor.diagonal() = (scale.array() > 0).select (factor.diagonal().array() + rounding, 1.0);
    factorLower (factor);
    const auto seen = range.count + range.mirrored;
    plainWeights = plainVelocityWeights (task.model, modes, playback, range);
    plainRows = Eigen::MatrixXd::Zero (count, splines.rows());
    addTransposedRight (plainRows, 1, plainWeights, splines.leftCols (seen));
    foldedRows = Eigen::MatrixXd::Zero (count, splines.rows());
    addTransposedRight (foldedRows, 1, task.problem.weights, splines.leftCols (range.count));
    Eigen::VectorXd allCosts = Eigen::VectorXd::Ones (samples);
    allCosts.head (range.count) = costs;
    energy = Eigen::MatrixXd::Zero (splines.rows(), splines.rows());
    addTransposedRight (energy, 1, splines * allCosts.asDiagonal(), splines);
    energyFactor = energy;
    factorLower (energyFactor);
}

QuietCorrection QuietBasis::allowed (Eigen::MatrixXd s) const
{
    auto rows = restored (valuesOf (plainRows, s));
    return { std::move (s), std::move (rows) };
}

Eigen::MatrixXd QuietBasis::slopeOf (const QuietCorrection& slope) const
{
    return slope.splines + pullOf (plainRows, restored (slope.rows));
}

QuietCorrection QuietBasis::energySlope (const QuietCorrection& change) const
{
    QuietCorrection slope { -pullOf (foldedRows, change.rows),
                            gram * change.rows - valuesOf (foldedRows, change.splines) };
    addProduct (slope.splines, 1, change.splines, energy);
    return slope;
}

Eigen::MatrixXd QuietBasis::preconditioned (const Eigen::MatrixXd& slope) const
{
    return solveFactored (energyFactor, slope.transpose()).transpose();
}

Eigen::MatrixXd QuietBasis::voltages (const QuietCorrection& change) const
{
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero (change.splines.rows(), splines.cols());
    addProduct (all, 1, change.splines, splines);
    Eigen::MatrixXd taken = Eigen::MatrixXd::Zero (all.rows(), range.count);
    addTransposedLeft (taken, 1, change.rows.asDiagonal() * participation, rowWaves);
    const auto mirrored = withMirrorImage (taken, range);
    all.leftCols (mirrored.cols()) -= mirrored;
    return all;
}

Eigen::VectorXd QuietBasis::rowValues (const Eigen::MatrixXd& samples) const
{
    return valuesOf (plainWeights, samples.leftCols (plainWeights.cols()));
}

Eigen::VectorXd QuietBasis::valuesOf (const Eigen::MatrixXd& weights, const Eigen::MatrixXd& waves) const
{
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero (weights.rows(), waves.rows());
    addTransposedRight (values, 1, weights, waves);
    return values.cwiseProduct (participation).rowwise().sum();
}

Eigen::MatrixXd QuietBasis::pullOf (const Eigen::MatrixXd& weights, const Eigen::VectorXd& multipliers) const
{
    Eigen::MatrixXd pull = Eigen::MatrixXd::Zero (participation.cols(), weights.cols());
    addTransposedLeft (pull, 1, multipliers.asDiagonal() * participation, weights);
    return pull;
}

Eigen::VectorXd QuietBasis::restored (const Eigen::VectorXd& values) const
{
    constexpr auto refinements = 2;
    Eigen::VectorXd multipliers = Eigen::VectorXd::Zero (values.size());

    for (int i = 0; i <= refinements; ++i)
        multipliers +=
            scale.cwiseProduct (solveFactored (factor, scale.cwiseProduct (values - gram * multipliers)).col (0));

    return multipliers;
}
} // namespace antinode
