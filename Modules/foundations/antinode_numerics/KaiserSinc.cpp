#include "KaiserSinc.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
/** The modified Bessel function I0 (x) from r = (x/2)^2: the series sum_k r^k / k!^2, all terms positive. */
double besselI0 (double r)
{
    double term = 1, sum = 1;

    for (int k = 1; term > 1e-17 * sum; ++k)
    {
        term *= r / (static_cast<double> (k) * k);
        sum += term;
    }

    return sum;
}

/** sin (pi x) / (pi x), without cancellation near the integers. */
double sinc (double x)
{
    const auto nearest = std::nearbyint (x);

    if (x == 0)
        return 1;

    const auto sign = std::fmod (nearest, 2.0) == 0 ? 1.0 : -1.0;
    return sign * std::sin (std::numbers::pi * (x - nearest)) / (std::numbers::pi * x);
}
} // namespace

double kaiserSinc (double x)
{
    const auto u = x / kaiserSincHalfWidth;

    if (std::abs (u) >= 1)
        return 0;

    constexpr auto quarter = kaiserSincShape * kaiserSincShape / 4;
    static const double atCentre = besselI0 (quarter);
    return sinc (x) * besselI0 (quarter * (1 - u * u)) / atCentre;
}

double kaiserSinc (double x, double halfWidth, double shape)
{
    const auto u = x / halfWidth;
    const auto quarter = shape * shape / 4;
    return std::abs (u) < 1 ? sinc (x) * besselI0 (quarter * (1 - u * u)) / besselI0 (quarter) : 0;
}

namespace
{
/** The interpolation at all samples between two, one column for each; its rows are the samples around. */
Eigen::MatrixXd phaseTaps (Eigen::Index factor)
{
    Eigen::MatrixXd taps (2 * kaiserSincHalfWidth, factor);

    for (Eigen::Index phase = 0; phase < factor; ++phase)
        for (Eigen::Index tap = 0; tap < taps.rows(); ++tap)
            taps (tap, phase) = kaiserSinc (static_cast<double> (phase) / static_cast<double> (factor)
                                            - static_cast<double> (tap - (kaiserSincHalfWidth - 1)));

    return taps;
}
} // namespace

Eigen::MatrixXd interpolated (const Eigen::MatrixXd& signals, Eigen::Index factor)
{
    constexpr Eigen::Index reach = kaiserSincHalfWidth;
    const auto taps = phaseTaps (factor);
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero (signals.rows() + 4 * reach, signals.cols());
    padded.middleRows (2 * reach, signals.rows()) = signals;
    Eigen::MatrixXd result ((signals.rows() - 1 + 2 * reach) * factor + 1, signals.cols());
    Eigen::VectorXd sum;

    for (Eigen::Index i = 0; i < signals.cols(); ++i)
    {
        checkWatch();

        for (Eigen::Index phase = 0; phase < factor; ++phase)
        {
            const auto count = (result.rows() - phase + factor - 1) / factor;
            sum.setZero (count);

            for (Eigen::Index tap = 0; tap < taps.rows(); ++tap)
                if (taps (tap, phase) != 0)
                    sum += taps (tap, phase) * padded.col (i).segment (tap + 1, count);

            result.col (i) (Eigen::seqN (phase, count, factor)) = sum;
        }
    }

    return result;
}

Eigen::MatrixXd interpolationAdjoint (const Eigen::MatrixXd& values, Eigen::Index factor)
{
    const auto reach = kaiserSincHalfWidth * factor;
    Eigen::VectorXd taps (2 * reach + 1);

    for (Eigen::Index n = 0; n < taps.size(); ++n)
        taps[n] = kaiserSinc (static_cast<double> (n - reach) / static_cast<double> (factor));

    Eigen::MatrixXd result ((values.rows() - taps.size()) / factor + 1, values.cols());

    for (Eigen::Index n = 0; n < result.rows(); ++n)
        result.row (n) = taps.transpose() * values.middleRows (n * factor, taps.size());

    return result;
}
} // namespace antinode
