#include "FocusPlayer.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace antinode
{
namespace
{
template <typename Sample>
std::vector<Sample*> pointersInto (std::vector<Sample>& samples, std::size_t count, std::size_t stride)
{
    std::vector<Sample*> pointers;

    for (std::size_t i = 0; i < count; ++i)
        pointers.push_back (samples.data() + i * stride);

    return pointers;
}
} // namespace

FocusPlayer::FocusPlayer (int ceramicsToUse, double sampleRate, PlayerSettings playerSettings)
    : FocusVoices (ceramicsToUse, sampleRate, playerSettings, std::numeric_limits<int>::max())
{
    const auto count = static_cast<std::size_t> (ceramics);
    scratchDouble.resize (count * fadeChunk);
    scratchFloat.resize (count * fadeChunk);
    channelsDouble = pointersInto (scratchDouble, count, fadeChunk);
    channelsFloat = pointersInto (scratchFloat, count, fadeChunk);
    shiftedDouble.resize (count);
    shiftedFloat.resize (count);

    for (const auto gain : fadeGains)
        floatGains.push_back (static_cast<float> (gain));
}

template <>
const double* FocusPlayer::gainsFrom<double> (std::int64_t sampleOfFade) const
{
    return fadeGains.data() + sampleOfFade;
}

template <>
const float* FocusPlayer::gainsFrom<float> (std::int64_t sampleOfFade) const
{
    return floatGains.data() + sampleOfFade;
}

template <>
double* const* FocusPlayer::scratchChannels<double>()
{
    std::fill (scratchDouble.begin(), scratchDouble.end(), 0.0);
    return channelsDouble.data();
}

template <>
float* const* FocusPlayer::scratchChannels<float>()
{
    std::fill (scratchFloat.begin(), scratchFloat.end(), 0.0F);
    return channelsFloat.data();
}

template <typename Sample>
Sample* const* FocusPlayer::shiftedBy (std::int64_t samples, Sample* const* channels)
{
    auto& shifted = [this]() -> auto&
    {
        if constexpr (std::is_same_v<Sample, float>)
            return shiftedFloat;
        else
            return shiftedDouble;
    }
    ();

    for (int i = 0; i < ceramics; ++i)
        shifted[static_cast<std::size_t> (i)] = channels[i] + samples;

    return shifted.data();
}

/** Adds samples of the player's clock, as they are without a fade. */
template <typename Sample>
void FocusPlayer::addOscillations (const Voice& voice, std::int64_t from, std::int64_t to,
                                   Sample* const* channels) const
{
    const auto count = static_cast<int> (to - from);

    if (from < voice.trigger + voice.focus->endSample)
        voice.focus->synthesiser.add (from - voice.trigger, count, voice.amplitude, channels);

    if (const auto& brake = voice.focus->brake; brake && ! voice.holdsBrake)
    {
        const auto start = voice.trigger + voice.brakeDelay;

        if (to > start + brake->startSample())
            brake->designed().add (from - start, count, voice.amplitude, channels, findBrakeFactors (voice));
    }
}

template <typename Sample>
void FocusPlayer::fadeOscillations (const Voice& voice, Sample* const* channels, int offset, std::int64_t from,
                                    std::int64_t to)
{
    for (auto at = from; at < to; at += fadeChunk)
    {
        const auto length = static_cast<int> (std::min<std::int64_t> (fadeChunk, to - at));
        auto* const* const scratch = scratchChannels<Sample>();
        addOscillations (voice, at, at + length, scratch);
        const auto* const gains = gainsFrom<Sample> (at - voice.fadeStart);

        for (int i = 0; i < ceramics; ++i)
        {
            auto* const sums = channels[i] + offset + (at - clock);
            const auto* const values = scratch[i];

            for (int n = 0; n < length; ++n)
                sums[n] += gains[n] * values[n];
        }
    }
}

template <typename Sample>
void FocusPlayer::renderFade (const Voice& voice, Sample* const* channels, int offset, std::int64_t from,
                              std::int64_t to)
{
    if (voice.focus->oscillates())
        fadeOscillations (voice, channels, offset, from, to);

    if (const auto& samples = voice.focus->samples; samples && from < to)
        samples->addFaded (from - voice.trigger, static_cast<int> (to - from), voice.amplitude,
                           gainsFrom<Sample> (from - voice.fadeStart), shiftedBy (offset + (from - clock), channels));
}

template <typename Sample>
void FocusPlayer::renderVoice (const Voice& voice, Sample* const* channels, int offset, int count)
{
    const auto begin = std::max (clock, voice.trigger + voice.focus->firstSample);
    const auto end = std::min (clock + count, voice.end (fadeLength));
    const auto fadeBegin = std::clamp (voice.fadeStart, begin, std::max (begin, end));

    if (fadeBegin > begin)
    {
        auto* const* const shifted = shiftedBy (offset + (begin - clock), channels);
        addOscillations (voice, begin, fadeBegin, shifted);

        if (const auto& samples = voice.focus->samples)
            samples->add (begin - voice.trigger, static_cast<int> (fadeBegin - begin), voice.amplitude, shifted);
    }

    renderFade (voice, channels, offset, fadeBegin, end);
}

template <typename Sample>
void FocusPlayer::render (Sample* const* channels, int offset, int count)
{
    for (const auto& voice : voices)
        if (voice.focus != nullptr)
            renderVoice (voice, channels, offset, count);
}

template <typename Sample>
void FocusPlayer::process (Sample* const* channels, int count, std::span<const FocusEvent> events)
{
    for (int i = 0; i < ceramics; ++i)
        std::fill (channels[i], channels[i] + count, Sample (0));

    playStretches (count, events, [&] (int offset, int length) { render (channels, offset, length); });
    giveUnusedBanks();
}

template void FocusPlayer::process (float* const*, int, std::span<const FocusEvent>);
template void FocusPlayer::process (double* const*, int, std::span<const FocusEvent>);
} // namespace antinode
