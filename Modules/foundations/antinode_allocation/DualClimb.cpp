#include "DualClimb.h"

#include <antinode_base/Watch.h>
#include <antinode_numerics/DenseKernels.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace
{
constexpr auto rowTolerance = 1e-12; // aimed at
constexpr auto maximumWaveformSteps = 40;
constexpr std::size_t fewHeld = 48; // columns that cost less than a matrix a ceramic

/** The lower triangle. */
Eigen::MatrixXd gramOf (const Eigen::MatrixXd& rows)
{
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero (rows.rows(), rows.rows());
    addGram (gram, 1, rows);
    return gram;
}

double dot (const WaveformMultipliers& a, const WaveformMultipliers& b)
{
    return a.rows.dot (b.rows) + a.own.cwiseProduct (b.own).sum();
}

WaveformMultipliers sum (const WaveformMultipliers& a, double length, const WaveformMultipliers& b)
{
    return { a.rows + length * b.rows, a.own + length * b.own };
}

DualPoint pointAt (const WaveformDual& dual, WaveformMultipliers y)
{
    auto pulls = dual.computePulls (y);
    auto slope = dual.slope (y, pulls);
    return { std::move (y), std::move (slope), std::move (pulls) };
}

/** The length at which the dual, concave along a line, is highest: doubled while it rises, then bisected. */
double bestLength (const WaveformDual& dual, const DualPoint& point, const WaveformMultipliers& step,
                   const Eigen::MatrixXd& change)
{
    constexpr auto longest = 1024.0;
    constexpr auto bisections = 12;
    constexpr auto flat = 0.05; // of the slope at the start: as good as the highest
    const auto slopeAt = [&] (double length)
    {
        const Eigen::MatrixXd pulls = point.pulls + length * change;
        const auto y = sum (point.multipliers, length, step);
        return dual.wanted.dot (step.rows) - dual.clipped (pulls).cwiseProduct (change).sum()
               - dual.compliance.cwiseProduct (y.rows).dot (step.rows) - y.own.cwiseProduct (step.own).sum();
    };
    const auto enough = flat * dot (point.slope, step);
    double low = 0, high = 1;
    auto slope = slopeAt (high);

    while (slope > enough && high < longest)
    {
        low = high;
        high *= 2;
        slope = slopeAt (high);
    }

    for (int i = 0; i < bisections && slope < -enough; ++i)
    {
        const auto middle = 0.5 * (low + high);
        const auto between = slopeAt (middle);

        if (between < -enough)
            high = middle;
        else if (between > enough)
            low = middle;
        else
            return middle;
    }

    return slope < -enough ? 0.5 * (low + high) : high;
}

/** max |row error| / max |wanted| of the hard rows, as they were before they were scaled. */
double worstHardRow (const WaveformDual& dual, const Eigen::VectorXd& slope)
{
    double worst = 0, largest = 0;

    for (Eigen::Index k = 0; k < slope.size(); ++k)
        if (dual.compliance[k] == 0 && dual.scale[k] > 0)
        {
            worst = std::max (worst, std::abs (slope[k]) / dual.scale[k]);
            largest = std::max (largest, std::abs (dual.wanted[k]) / dual.scale[k]);
        }

    return largest > 0 ? worst / largest : worst;
}
} // namespace

DualClimb::DualClimb (const WaveformDual& dualToClimb)
    : dual (dualToClimb), gram (gramOf (dualToClimb.weights)),
      seen (dualToClimb.weights, gram, dualToClimb.participation.cols(), dualToClimb.hasOwnRows() ? 0 : fewHeld)
{
    if (dual.hasOwnRows())
        own.emplace (dual.spread, dual.participation);
}

/** Compliance and the rows as the samples within the limits see them. Lower triangle. */
Eigen::MatrixXd DualClimb::curvature (const Eigen::MatrixXd& pulls)
{
    Eigen::MatrixXd sum = dual.compliance.asDiagonal();
    seen.follow (pulls, dual.caps);

    if (! own)
    {
        seen.addWeighted (sum, dual.participation);
        return sum;
    }

    const auto left = own->eliminate (seen);

    for (Eigen::Index i = 0; i < pulls.rows(); ++i)
        addWeightedLower (sum, dual.participation.col (i), left[static_cast<std::size_t> (i)]);

    return sum;
}

/** The Newton step; the curvature is lifted until it can be factored and leads upwards. */
WaveformMultipliers DualClimb::newtonStep (const DualPoint& point)
{
    const auto matrix = curvature (point.pulls);
    const Eigen::VectorXd slope =
        own ? Eigen::VectorXd (point.slope.rows - own->takenBySlope (point.slope.own)) : point.slope.rows;

    for (auto lift = 1e-13;; lift *= 100)
    {
        Eigen::MatrixXd factor = matrix;
        factor.diagonal().array() += lift;

        if (! factorLower (factor))
            continue;

        WaveformMultipliers step { solveFactored (factor, slope), {} };

        if (own)
            step.own = own->steps (point.slope.own, step.rows);

        if (step.rows.allFinite() && dot (step, point.slope) > 0)
            return step;

        if (lift > 1)
            return point.slope;
    }
}

WaveformMultipliers DualClimb::unlimited()
{
    const auto none = dual.scaled ({ Eigen::VectorXd::Zero (dual.wanted.size()), {} });
    return newtonStep (pointAt (dual, none));
}

DualSummit DualClimb::from (const WaveformMultipliers& start)
{
    DualSummit summit;
    summit.point = pointAt (dual, start);
    auto& point = summit.point;
    const auto look = [&]
    {
        summit.residual = worstHardRow (dual, point.slope.rows);
        summit.peakBound = std::max (summit.peakBound, computePeakBound (dual, point.multipliers));
    };
    const auto isOpen = [&]
    {
        return summit.residual > rowTolerance
               || std::sqrt (dot (point.slope, point.slope)) > rowTolerance * dual.wanted.norm();
    };
    look();

    for (; isOpen() && summit.peakBound <= 1 && summit.iterations < maximumWaveformSteps; ++summit.iterations)
    {
        const auto step = newtonStep (point);
        const auto length = bestLength (dual, point, step, dual.computePulls (step));
        point = pointAt (dual, sum (point.multipliers, length, step));
        look();
    }

    return summit;
}

double computePeakBound (const WaveformDual& dual, const WaveformMultipliers& y)
{
    auto hard = y;
    hard.rows = (dual.compliance.array() == 0).select (y.rows, 0.0);
    hard.own.setZero();
    const auto price = dual.computePulls (hard).cwiseAbs().cwiseProduct (dual.caps).sum();
    return price > 0 ? std::max (0.0, dual.wanted.dot (hard.rows) / price) : 0;
}

double computePeakBound (const WaveformDual& dual, const WaveformMultipliers& y, double softCost)
{
    // A soft row r of cost r^2 / (2 c) brings at most |y r| = |y| sqrt (c) |r| / sqrt (c), and all together the product
    // of two lengths.
    const auto soft = std::sqrt (dual.compliance.dot (y.rows.cwiseAbs2()) + y.own.squaredNorm());
    const auto price = dual.computePulls (y).cwiseAbs().cwiseProduct (dual.caps).sum();
    const auto gain = dual.wanted.dot (y.rows) - soft * std::sqrt (2 * softCost);
    return price > 0 ? std::max (0.0, gain / price) : 0;
}
} // namespace antinode
