#include "SparseSamples.h"

#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/SampleInterpolation.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** Samples from the first that is played to that at the focus: the kernel of the first free one begins earlier. */
Eigen::Index playedBeforeFocus (const SparseSamples& sparse)
{
    return (sparse.range.focus + kaiserSincHalfWidth) * sparse.factor;
}
} // namespace

SparseSamples sparseSamples (const FocusDescription& description, Playback playback, std::size_t rows,
                             Eigen::Index factor)
{
    auto own = playback;
    own.sampleRate /= static_cast<double> (factor);
    auto range = findSampleRange (description, own, rows);

    // What is interpolated begins half a kernel before the first free sample, and not before the waveform may begin.
    if (factor > 1)
    {
        range.focus = std::max<Eigen::Index> (range.focus - kaiserSincHalfWidth, 1);
        range.count = range.focus + 1;
        range.mirrored = std::min<Eigen::Index> (range.focus, kaiserSincHalfWidth);
    }

    return { factor, playback, range };
}

Eigen::Index largestFactor (Playback playback, double frequency)
{
    constexpr double ratesPerFrequency = 3;

    if (playback.reconstruction == Reconstruction::zeroOrderHold)
        return 1;

    return std::max<Eigen::Index> (static_cast<Eigen::Index> (playback.sampleRate / (ratesPerFrequency * frequency)),
                                   1);
}

Eigen::MatrixXd velocityWeights (const ModalModel& model, const std::vector<int>& modes, const SparseSamples& sparse)
{
    const auto& range = sparse.range;

    if (sparse.factor == 1)
        return velocityWeights (model, modes, sparse.playback, range);

    const auto focus = playedBeforeFocus (sparse);
    const SampleRange played { focus, focus + 1, kaiserSincHalfWidth };
    const auto free = range.count + mirrorLength (range);
    Eigen::MatrixXd ofPlayed = Eigen::MatrixXd::Zero ((free - 1 + 2 * kaiserSincHalfWidth) * sparse.factor + 1,
                                                      static_cast<Eigen::Index> (modes.size()));
    const auto acting = plainVelocityWeights (model, modes, sparse.playback, played);
    ofPlayed.topRows (acting.cols()) = acting.transpose();
    Eigen::MatrixXd weights = interpolationAdjoint (ofPlayed, sparse.factor).transpose();

    for (Eigen::Index m = 1; m <= mirrorLength (range); ++m)
        weights.col (range.focus - m) += mirrorLevel (range, m) * weights.col (range.focus + m);

    return weights.leftCols (range.count);
}

SampledVoltages playedSamples (const Eigen::MatrixXd& samples, const SparseSamples& sparse, double focusTime)
{
    const auto all = withMirrorImage (samples, sparse.range);

    if (sparse.factor == 1)
        return { sparse.playback, focusTime - static_cast<double> (sparse.range.focus) / sparse.playback.sampleRate,
                 all };

    return { sparse.playback, focusTime - static_cast<double> (playedBeforeFocus (sparse)) / sparse.playback.sampleRate,
             interpolated (all.transpose(), sparse.factor).transpose() };
}
} // namespace antinode
