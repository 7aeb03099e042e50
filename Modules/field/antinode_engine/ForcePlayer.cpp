#include "ForcePlayer.h"

#include <algorithm>
#include <utility>

namespace antinode
{
ForcePlayer::ForcePlayer (int ceramicsToUse, double sampleRate, PlayerSettings playerSettings, int channels)
    : FocusVoices (ceramicsToUse, sampleRate, playerSettings, channels), stock (channels)
{
    // The parts of every voice that sounds when a block begins, or begins in it.
    listed.reserve (partKinds * (allVoices + maximumEvents));
}

bool ForcePlayer::hasRoom (const Voice& voice) const
{
    return voice.focus != nullptr && rooms[voiceIndex (voice)].order == voice.order;
}

/** The first channel of so many that no voice uses, or -1: they begin at 0 or behind another voice's. */
int ForcePlayer::freeChannel (const Voice& voice, int size) const
{
    const auto isFree = [&] (int first)
    {
        return first + size <= stock
               && std::none_of (voices.begin(), voices.end(),
                                [&] (const Voice& other)
                                {
                                    const auto& room = rooms[voiceIndex (other)];
                                    return &other != &voice && hasRoom (other) && first < room.first + room.size
                                           && room.first < first + size;
                                });
    };

    if (isFree (0))
        return 0;

    auto found = -1;

    for (const auto& other : voices)
        if (const auto& room = rooms[voiceIndex (other)]; &other != &voice && hasRoom (other)
                                                          && (found < 0 || room.first + room.size < found)
                                                          && isFree (room.first + room.size))
            found = room.first + room.size;

    return found;
}

void ForcePlayer::makeRoom (const Voice& voice)
{
    const auto size = voice.focus->forceCount();
    auto first = freeChannel (voice, size);

    while (first < 0 && cutAnother (voice))
        first = freeChannel (voice, size);

    rooms[voiceIndex (voice)] = { voice.order, std::max (0, first), size };
}

/** For all that begin to sound in the next samples. Before any of these is written: a voice that is cut leaves
    nothing in them. */
void ForcePlayer::makeRooms (int count)
{
    for (const auto& voice : voices)
        if (voice.focus != nullptr && ! hasRoom (voice) && voice.trigger + voice.focus->firstSample < clock + count)
            makeRoom (voice);
}

void ForcePlayer::list (const Voice& voice, const Part& part, int offset)
{
    const auto from = offset + static_cast<int> (part.from - clock), to = offset + static_cast<int> (part.to - clock);
    auto& entry = rooms[voiceIndex (voice)].entries[static_cast<std::size_t> (part.kind)];

    // A voice plays without a gap, also across events.
    if (entry >= 0)
    {
        listed[static_cast<std::size_t> (entry)].to = to;
        return;
    }

    entry = std::ssize (listed);
    listed.push_back (
        { part.design, part.first, from, to, partKinds * static_cast<int> (voiceIndex (voice)) + part.kind });
}

void ForcePlayer::renderPart (const Voice& voice, const Part& part, double* const* channels, int offset)
{
    list (voice, part, offset);
    const auto begin = offset + (part.from - clock);
    const auto count = static_cast<int> (part.to - part.from);
    const auto fadeBegin = std::clamp (voice.fadeStart, part.from, part.to);
    auto* const* const own = channels + part.first;

    for (int c = 0; c < part.size; ++c)
        std::fill_n (own[c] + begin, count, 0.0);

    if (part.design != nullptr)
        part.design->addForces (part.from - part.start, count, voice.amplitude, own, begin, part.factors);
    else
        voice.focus->samples->add (part.from - part.start, count, voice.amplitude, own, begin);

    for (int c = 0; c < part.size; ++c)
        for (auto n = fadeBegin; n < part.to; ++n)
            own[c][offset + (n - clock)] *= fadeGains[static_cast<std::size_t> (n - voice.fadeStart)];
}

void ForcePlayer::renderVoice (const Voice& voice, double* const* channels, int offset, int count)
{
    const auto& focus = *voice.focus;
    const auto from = std::max (clock, voice.trigger + focus.firstSample);
    const auto to = std::min (clock + count, voice.end (fadeLength));

    if (from >= to)
        return;

    const auto oscillations = focus.synthesiser.oscillationCount();
    auto first = rooms[voiceIndex (voice)].first;

    if (from < voice.trigger + focus.endSample)
        renderPart (voice, { &focus.synthesiser, 0, first, oscillations, voice.trigger, from, to, nullptr }, channels,
                    offset);

    first += oscillations;

    if (focus.samples && from < voice.trigger + focus.samples->endSample())
        renderPart (voice, { nullptr, 2, first, ceramics, voice.trigger, from, to, nullptr }, channels, offset);

    if (! focus.brake || voice.holdsBrake)
        return;

    first += focus.samples ? ceramics : 0;
    const auto start = voice.trigger + voice.brakeDelay;
    const auto& brake = focus.brake->designed();

    if (to > start + focus.brake->startSample())
        renderPart (voice, { &brake, 1, first, brake.oscillationCount(), start, from, to, findBrakeFactors (voice) },
                    channels, offset);
}

void ForcePlayer::process (double* const* channels, int count, std::span<const FocusEvent> events)
{
    // Not at the end of a block: what stands in the list is still looked at behind this.
    giveUnusedBanks();
    listed.clear();

    for (auto& room : rooms)
        room.entries = { -1, -1, -1 };

    playStretches (count, events.first (std::min (events.size(), maximumEvents)),
                   [&] (int offset, int length)
                   {
                       makeRooms (length);

                       for (const auto& voice : voices)
                           if (hasRoom (voice))
                               renderVoice (voice, channels, offset, length);
                   });
    std::sort (listed.begin(), listed.end(),
               [] (const ForceStretch& a, const ForceStretch& b)
               { return std::pair (a.rank, a.from) < std::pair (b.rank, b.from); });
}
} // namespace antinode
