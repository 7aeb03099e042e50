#include "SampleInterpolation.h"

#include "KaiserSinc.h"

#include <antinode_base/Watch.h>

#include <algorithm>

namespace antinode
{
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
