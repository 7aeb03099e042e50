#include "SampleRange.h"

#include "DriveAllocation.h"
#include "SampledPrediction.h"

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
} // namespace antinode
