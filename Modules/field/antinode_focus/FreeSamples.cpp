#include "FreeSamples.h"

#include "DriveAllocation.h"
#include "Prediction.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/KaiserSinc.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
constexpr auto maximumWeights = 128.0 * 1024 * 1024; // row weights: 1 GiB
}

SampleRange findSampleRange (const FocusDescription& description, Playback playback, std::size_t rows)
{
    constexpr auto onSample = 1e-6;

    if (! (playback.sampleRate > 0))
        throw InputError ("sample rate", "is missing; a free waveform consists of samples and needs a rate");

    const auto before = std::floor (longestDrive (description) * playback.sampleRate + onSample);

    if (before * static_cast<double> (rows) > maximumWeights)
        throw InputError ("sample rate", "is too high for this focus time: a free waveform would need more than 1 GiB; "
                                         "choose a lower rate, a shorter focus time or fewer guard modes");

    const auto focus = static_cast<Eigen::Index> (before);
    const auto isHeld = playback.reconstruction == Reconstruction::zeroOrderHold;

    if (isHeld)
        return { focus, std::max<Eigen::Index> (focus, 1), 0 };

    return { focus, focus + 1, std::min<Eigen::Index> (focus, kaiserSincHalfWidth) };
}

Eigen::MatrixXd plainVelocityWeights (const ModalModel& model, const std::vector<int>& modes, Playback playback,
                                      const SampleRange& range)
{
    const Eigen::VectorXd ratio = (decayRates (model).array() / dampedFrequencies (model).array()) (modes);
    const auto responses = sampleResponses (model, modes, playback, range.count + range.mirrored, range.focus);
    return responses.real() - ratio.asDiagonal() * responses.imag();
}

Eigen::MatrixXd velocityWeights (const ModalModel& model, const std::vector<int>& modes, Playback playback,
                                 const SampleRange& range)
{
    auto weights = plainVelocityWeights (model, modes, playback, range);

    for (Eigen::Index m = 1; m <= range.mirrored; ++m)
        weights.col (range.focus - m) += weights.col (range.focus + m);

    weights.conservativeResize (Eigen::NoChange, range.count);
    return weights;
}

double mirrorLevel (const SampleRange& range, Eigen::Index behind)
{
    const auto beyond = static_cast<double> (std::max<Eigen::Index> (behind - range.mirrored, 0));
    const auto level = std::cos (0.5 * std::numbers::pi * beyond / static_cast<double> (range.mirrored + 1));
    return level * level;
}

Eigen::Index mirrorLength (const SampleRange& range)
{
    return std::min (range.focus, 2 * range.mirrored);
}

Eigen::MatrixXd withMirrorImage (const Eigen::MatrixXd& samples, const SampleRange& range)
{
    Eigen::MatrixXd all (samples.rows(), samples.cols() + mirrorLength (range));
    all.leftCols (samples.cols()) = samples;

    for (Eigen::Index m = 1; m <= mirrorLength (range); ++m)
        all.col (range.focus + m) = mirrorLevel (range, m) * samples.col (range.focus - m);

    return all;
}

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

Eigen::MatrixXd withSmoothEdges (const Eigen::MatrixXd& samples, double timeConstant)
{
    if (! (timeConstant > 0))
        return samples;

    const auto part = -std::expm1 (-1 / timeConstant);
    Eigen::MatrixXd smooth = part * samples;

    for (Eigen::Index n = 1; n < smooth.cols(); ++n)
        smooth.col (n) += (1 - part) * smooth.col (n - 1);

    return smooth;
}

Eigen::MatrixXd smoothEdgesAdjoint (Eigen::MatrixXd weights, double timeConstant)
{
    if (! (timeConstant > 0))
        return weights;

    const auto part = -std::expm1 (-1 / timeConstant);
    weights *= part;

    for (auto n = weights.cols() - 2; n >= 0; --n)
        weights.col (n) += (1 - part) * weights.col (n + 1);

    return weights;
}

SampledSlopes slopesOf (const SampledVoltages& voltages)
{
    constexpr Eigen::Index places = 8;
    const auto rate = voltages.playback.sampleRate;
    const Eigen::MatrixXd fine = interpolated (voltages.values.transpose(), places).transpose();
    const auto count = fine.cols() - 1;
    const auto interval = 1 / (rate * places);
    const auto first = voltages.firstTime - kaiserSincHalfWidth / rate + interval / 2;
    return { (fine.rightCols (count) - fine.leftCols (count)) / interval, first,
             first + static_cast<double> (count - 1) * interval };
}

SampledVoltages withSlowEnd (const SampledVoltages& voltages, const Eigen::VectorXd& slewLimits, double focusTime)
{
    constexpr double room = 0.9; // of the limit: where the fade begins it bends
    const auto rate = voltages.playback.sampleRate;
    const auto acting = static_cast<Eigen::Index> (std::ceil ((focusTime - voltages.firstTime) * rate - 1e-6))
                        + kaiserSincHalfWidth + 1;
    const auto kept = std::min (acting, voltages.values.cols());
    const Eigen::VectorXd end = voltages.values.col (kept - 1);
    double duration = 0; // samples

    for (Eigen::Index i = 0; i < end.size(); ++i)
        if (slewLimits[i] > 0)
            duration = std::max (duration, std::abs (end[i]) * 0.5 * std::numbers::pi * rate / (room * slewLimits[i]));

    const auto fade = static_cast<Eigen::Index> (std::ceil (duration)) + kaiserSincHalfWidth;
    auto result = voltages;
    result.values.resize (end.size(), kept + fade);
    result.values.leftCols (kept) = voltages.values.leftCols (kept);

    for (Eigen::Index n = 0; n < fade; ++n)
    {
        const auto level = std::cos (0.5 * std::numbers::pi * static_cast<double> (n + 1) / static_cast<double> (fade));
        result.values.col (kept + n) = level * level * end;
    }

    return result;
}
} // namespace antinode
