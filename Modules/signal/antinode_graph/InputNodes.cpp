#include "InputNodes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
namespace
{
template <typename Sample>
void copyScaled (const Sample* from, double* to, int count, double gain)
{
    for (int n = 0; n < count; ++n)
        to[n] = static_cast<double> (from[n]) * gain;
}
} // namespace

void InputNode::give (std::span<const float* const> from, double scale)
{
    floats = from;
    doubles = {};
    gain = scale;
    position = 0;
}

void InputNode::give (std::span<const double* const> from, double scale)
{
    floats = {};
    doubles = from;
    gain = scale;
    position = 0;
}

void InputNode::process (const NodeBlock& block)
{
    for (int i = 0; i < channels; ++i)
    {
        const auto channel = static_cast<std::size_t> (i);

        if (channel < floats.size())
            copyScaled (floats[channel] + position, block.outputs[i], block.count, gain);
        else if (channel < doubles.size())
            copyScaled (doubles[channel] + position, block.outputs[i], block.count, gain);
        else
            std::fill_n (block.outputs[i], block.count, 0.0);
    }

    position += block.count;
}

namespace
{
std::unique_ptr<const FilterBank> bankAtFirst (int ceramics, int inputs, TrackBand band, const FilterSettings& settings)
{
    return std::make_unique<const FilterBank> (silentBank (ceramics, inputs, filterTiming (band, settings)));
}

double filterRate (const FilterSettings& settings, const FilterBank& bank)
{
    return settings.sampleRate / static_cast<double> (bank.factor);
}

Eigen::Index fadeSamples (const FilterSettings& settings, const FilterBank& bank)
{
    return std::max<Eigen::Index> (1, std::llround (FilterNode::fadeTime * filterRate (settings, bank)));
}

double usableSample (double value)
{
    constexpr auto most = static_cast<double> (FilterNode::largestSample);
    return std::isfinite (value) ? std::clamp (value, -most, most) : 0.0;
}
} // namespace

FilterNode::FilterNode (int ceramicsToDrive, int inputsToTake, TrackBand band, const FilterSettings& settings,
                        const SkinThreshold& threshold)
    : ceramics (ceramicsToDrive), factorOfFilters (filterTiming (band, settings).factor),
      playing (bankAtFirst (ceramics, inputsToTake, band, settings)),
      player (*playing, fadeSamples (settings, *playing)),
      asked (filterRate (settings, *playing), band, threshold, playing->taps, inputsToTake),
      offsets (static_cast<std::size_t> (inputsToTake), 0.0), wantedLevels (offsets), levels (wantedLevels),
      gains (static_cast<std::size_t> (inputsToTake), SafetyRamp (0)), sample (inputsToTake), voltages (ceramics)
{
}

FilterNode::~FilterNode() = default;

void FilterNode::prepare (const NodeFormat& format)
{
    rampSamples = std::max<std::int64_t> (1, std::llround (rampTime * format.sampleRate));
    offsetShare = 1 - std::exp (-2 * std::numbers::pi * offsetCorner / format.sampleRate);
    scaled = PlanarBuffer<float> (inputs(), format.longestBlock);
}

void FilterNode::reset()
{
    player.reset();
    asked.reset();
    std::fill (offsets.begin(), offsets.end(), 0.0);
}

/** A bank waits while two of them sound; the one that has faded out goes back. */
void FilterNode::exchangeBanks()
{
    if (player.isFading())
        return;

    if (coming != nullptr && exchange.canGiveBack())
    {
        exchange.giveBack (playing.release());
        playing = std::move (coming);
    }

    if (coming == nullptr)
        if (const auto* const newer = exchange.take(); newer != nullptr)
        {
            coming.reset (newer);
            player.fadeTo (*coming);
        }
}

/** In m at the largest level. */
float FilterNode::withoutOffset (std::size_t input, double sample)
{
    const auto rest = sample - offsets[input];
    offsets[input] += offsetShare * rest;
    return static_cast<float> (largestLevel * rest);
}

void FilterNode::takeInputs (const NodeBlock& block)
{
    for (std::size_t j = 0; j < gains.size(); ++j)
    {
        auto* const channel = scaled.channel (j);

        for (int n = 0; n < block.count; ++n)
            channel[n] = withoutOffset (j, usableSample (block.inputs[j][n]));

        if (std::exchange (levels[j], wantedLevels[j]) != wantedLevels[j])
            gains[j].setTarget (wantedLevels[j], rampSamples);

        gains[j].process (scaled.channels() + j, 1, block.count);
    }
}

void FilterNode::process (const NodeBlock& block)
{
    takeInputs (block);

    for (int n = 0; n < block.count; ++n)
    {
        exchangeBanks();

        for (std::size_t j = 0; j < gains.size(); ++j)
            sample[static_cast<Eigen::Index> (j)] = scaled.channel (j)[n];

        player.process (sample, voltages);

        for (int i = 0; i < ceramics; ++i)
            block.outputs[i][n] = voltages[i];

        if (player.hasDecimated())
            for (std::size_t j = 0; j < gains.size(); ++j)
                asked.take (j, player.decimated (j));
    }
}
} // namespace antinode
