#include "FocusPlayer.h"

#include <algorithm>
#include <limits>

namespace antinode
{
FocusPlayer::FocusPlayer (int ceramicsToUse, double sampleRate, PlayerSettings playerSettings)
    : FocusVoices (ceramicsToUse, sampleRate, playerSettings, std::numeric_limits<int>::max()),
      scratch (ceramics, fadeChunk), shifted (static_cast<std::size_t> (ceramics))
{
}

double* const* FocusPlayer::shiftedBy (std::int64_t samples, double* const* channels)
{
    for (int i = 0; i < ceramics; ++i)
        shifted[static_cast<std::size_t> (i)] = channels[i] + samples;

    return shifted.data();
}

/** Adds samples of the player's clock, as they are without a fade. */
void FocusPlayer::addOscillations (const Voice& voice, std::int64_t from, std::int64_t to,
                                   double* const* channels) const
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

void FocusPlayer::fadeOscillations (const Voice& voice, double* const* channels, int offset, std::int64_t from,
                                    std::int64_t to)
{
    for (auto at = from; at < to; at += fadeChunk)
    {
        const auto length = static_cast<int> (std::min<std::int64_t> (fadeChunk, to - at));
        scratch.fill (0);
        addOscillations (voice, at, at + length, scratch.channels());
        const auto* const gains = fadeGains.data() + (at - voice.fadeStart);

        for (int i = 0; i < ceramics; ++i)
        {
            auto* const sums = channels[i] + offset + (at - clock);
            const auto* const values = scratch.channels()[i];

            for (int n = 0; n < length; ++n)
                sums[n] += gains[n] * values[n];
        }
    }
}

void FocusPlayer::renderFade (const Voice& voice, double* const* channels, int offset, std::int64_t from,
                              std::int64_t to)
{
    if (voice.focus->oscillates())
        fadeOscillations (voice, channels, offset, from, to);

    if (const auto& samples = voice.focus->samples; samples && from < to)
        samples->addFaded (from - voice.trigger, static_cast<int> (to - from), voice.amplitude,
                           fadeGains.data() + (from - voice.fadeStart), shiftedBy (offset + (from - clock), channels));
}

void FocusPlayer::renderVoice (const Voice& voice, double* const* channels, int offset, int count)
{
    const auto begin = std::max (clock, voice.trigger + voice.focus->firstSample);
    const auto end = std::min (clock + count, voice.end (fadeLength));
    const auto fadeBegin = std::clamp (voice.fadeStart, begin, std::max (begin, end));

    if (fadeBegin > begin)
    {
        auto* const* const sums = shiftedBy (offset + (begin - clock), channels);
        addOscillations (voice, begin, fadeBegin, sums);

        if (const auto& samples = voice.focus->samples)
            samples->add (begin - voice.trigger, static_cast<int> (fadeBegin - begin), voice.amplitude, sums);
    }

    renderFade (voice, channels, offset, fadeBegin, end);
}

void FocusPlayer::render (double* const* channels, int offset, int count)
{
    for (const auto& voice : voices)
        if (voice.focus != nullptr)
            renderVoice (voice, channels, offset, count);
}

void FocusPlayer::process (double* const* channels, int count, std::span<const FocusEvent> events)
{
    for (int i = 0; i < ceramics; ++i)
        std::fill (channels[i], channels[i] + count, 0.0);

    playStretches (count, events, [&] (int offset, int length) { render (channels, offset, length); });
    giveUnusedBanks();
}
} // namespace antinode
