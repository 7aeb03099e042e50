#include "SparseSamples.h"

#include <antinode_numerics/KaiserSinc.h>
#include <antinode_numerics/SampleInterpolation.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
/** Of the grid that free samples are interpolated to, the places before the focus: the kernel of the first free one
   begins earlier. */
Eigen::Index fineBeforeFocus (const SparseSamples& sparse)
{
    return (sparse.range.focus + kaiserSincHalfWidth) * sparse.ratio.played;
}

/** Of that grid, the first that is played: so that the focus is. */
Eigen::Index firstPlayed (const SparseSamples& sparse)
{
    return fineBeforeFocus (sparse) % sparse.ratio.free;
}

Eigen::Index playedBeforeFocus (const SparseSamples& sparse)
{
    return fineBeforeFocus (sparse) / sparse.ratio.free;
}
} // namespace

double SparseSamples::placeOf (Eigen::Index index) const
{
    const auto fine = firstPlayed (*this) + index * ratio.free;
    return static_cast<double> (fine) / static_cast<double> (ratio.played) - kaiserSincHalfWidth;
}

SparseSamples sparseSamples (const FocusDescription& description, Playback playback, std::size_t rows,
                             SampleRatio ratio)
{
    auto own = playback;
    own.sampleRate /= ratio.value();
    auto range = findSampleRange (description, own, rows);

    // What is interpolated begins half a kernel before the first free sample, and not before the waveform may begin.
    if (! ratio.isOne())
    {
        range.focus = std::max<Eigen::Index> (range.focus - kaiserSincHalfWidth, 1);
        range.count = range.focus + 1;
        range.mirrored = std::min<Eigen::Index> (range.focus, kaiserSincHalfWidth);
    }

    return { ratio, playback, range };
}

std::vector<SampleRatio> sparseRatios (Playback playback, double frequency)
{
    constexpr double ratesPerFrequency = 3;
    constexpr SampleRatio between { 3, 2 };
    std::vector<SampleRatio> ratios;
    const auto largest = playback.reconstruction == Reconstruction::zeroOrderHold
                             ? 1
                             : playback.sampleRate / (ratesPerFrequency * frequency);

    for (auto factor = static_cast<Eigen::Index> (largest); factor > 1; --factor)
        ratios.push_back ({ factor, 1 });

    if (largest >= between.value())
        ratios.push_back (between);

    ratios.push_back ({});
    return ratios;
}

Eigen::MatrixXd velocityWeights (const ModalModel& model, const std::vector<int>& modes, const SparseSamples& sparse)
{
    const auto& range = sparse.range;

    if (sparse.ratio.isOne())
        return velocityWeights (model, modes, sparse.playback, range);

    const auto focus = playedBeforeFocus (sparse);
    const SampleRange played { focus, focus + 1, kaiserSincHalfWidth };
    const auto free = range.count + mirrorLength (range);
    Eigen::MatrixXd ofFine = Eigen::MatrixXd::Zero ((free - 1 + 2 * kaiserSincHalfWidth) * sparse.ratio.played + 1,
                                                    static_cast<Eigen::Index> (modes.size()));
    const auto acting = plainVelocityWeights (model, modes, sparse.playback, played);
    ofFine (Eigen::seqN (firstPlayed (sparse), acting.cols(), sparse.ratio.free), Eigen::all) = acting.transpose();
    Eigen::MatrixXd weights = interpolationAdjoint (ofFine, sparse.ratio.played).transpose();

    for (Eigen::Index m = 1; m <= mirrorLength (range); ++m)
        weights.col (range.focus - m) += mirrorLevel (range, m) * weights.col (range.focus + m);

    return weights.leftCols (range.count);
}

SampledVoltages playedSamples (const Eigen::MatrixXd& samples, const SparseSamples& sparse, double focusTime)
{
    const auto all = withMirrorImage (samples, sparse.range);

    if (sparse.ratio.isOne())
        return { sparse.playback, focusTime - static_cast<double> (sparse.range.focus) / sparse.playback.sampleRate,
                 all };

    const auto fine = interpolated (all.transpose(), sparse.ratio.played);
    const auto first = firstPlayed (sparse), step = sparse.ratio.free;
    return { sparse.playback, focusTime - static_cast<double> (playedBeforeFocus (sparse)) / sparse.playback.sampleRate,
             fine (Eigen::seqN (first, (fine.rows() - first + step - 1) / step, step), Eigen::all).transpose() };
}
} // namespace antinode
