#include "FocusPlayer.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double longestFade = 1; // s
} // namespace

FocusVoices::FocusVoices (int ceramicsToUse, double sampleRate, PlayerSettings settingsToUse, int maximumForcesToUse)
    : ceramics (ceramicsToUse),
      fadeLength (std::max<std::int64_t> (1, std::llround (settingsToUse.fadeTime * sampleRate))),
      settings (settingsToUse), maximumForces (maximumForcesToUse)
{
    if (ceramics < 1 || ! (sampleRate > 0 && std::isfinite (sampleRate)))
        throw InputError ("player", "needs at least one ceramic and a positive sample rate");

    if (! (settings.fadeTime >= 0 && settings.fadeTime <= longestFade))
        throw InputError ("player", "fade time is " + std::to_string (settings.fadeTime) + " s; allowed: 0 to 1 s");

    for (std::int64_t n = 0; n < fadeLength; ++n)
        fadeGains.push_back (
            0.5 + 0.5 * std::cos (std::numbers::pi * static_cast<double> (n + 1) / static_cast<double> (fadeLength)));

    brakeFactors.resize (allVoices);
}

void FocusVoices::setSettings (const PlayerSettings& wanted)
{
    const auto fadeTime = settings.fadeTime;
    settings = wanted;
    settings.fadeTime = fadeTime;
}

FocusVoices::~FocusVoices()
{
    for (const auto& used : banks)
        delete used.bank;
}

std::int64_t FocusVoices::Voice::end (std::int64_t fadeLength) const
{
    auto own = trigger + focus->endSample;

    if (const auto& brake = focus->brake)
        own = std::max (
            own,
            trigger + (holdsBrake ? brake->startSample() + brake->longestDelay() : brake->endSample() + brakeDelay));

    return fadeStart == never ? own : std::min (own, fadeStart + fadeLength);
}

int FocusVoices::activeVoices() const
{
    return static_cast<int> (
        std::count_if (voices.begin(), voices.end(), [] (const Voice& voice) { return voice.focus != nullptr; }));
}

void FocusVoices::reset()
{
    for (auto& voice : voices)
        if (voice.focus != nullptr)
            finish (voice);
}

void FocusVoices::takeBank()
{
    // The last place for a bank is found again only when voices end: until then the newest bank waits where it is.
    const auto place =
        std::find_if (banks.begin(), banks.end(), [] (const UsedBank& used) { return used.bank == nullptr; });

    if (place == banks.end())
        return;

    if (const auto* const bank = exchange.take())
    {
        *place = { bank, 0 };
        current = static_cast<int> (place - banks.begin());
        latency = bank->latestFocusSample();
    }
}

void FocusVoices::giveUnusedBanks()
{
    for (int i = 0; i < static_cast<int> (banks.size()); ++i)
    {
        auto& used = banks[static_cast<std::size_t> (i)];

        if (used.bank != nullptr && used.users == 0 && i != current && exchange.canGiveBack())
        {
            exchange.giveBack (used.bank);
            used.bank = nullptr;
        }
    }
}

void FocusVoices::finish (Voice& voice)
{
    --banks[static_cast<std::size_t> (voice.bank)].users;
    voice = {};
}

void FocusVoices::finishEnded()
{
    for (auto& voice : voices)
        if (voice.focus != nullptr && voice.end (fadeLength) <= clock)
            finish (voice);
}

void FocusVoices::fade (Voice& voice)
{
    if (voice.fadeStart == never)
        voice.fadeStart = clock;
}

template <typename Condition>
void FocusVoices::fadeWhere (Condition condition)
{
    for (auto& voice : voices)
        if (voice.focus != nullptr && condition (voice))
            fade (voice);
}

void FocusVoices::releaseBrake (Voice& voice)
{
    const auto& brake = *voice.focus->brake;
    voice.holdsBrake = false;
    voice.brakeDelay = std::max<std::int64_t> (0, clock - voice.trigger - brake.startSample());

    if (voice.brakeDelay > 0)
        brake.factorsAfter (voice.brakeDelay, brakeFactors[voiceIndex (voice)]);
}

void FocusVoices::release (int place)
{
    if (settings.noteOff == NoteOffBehaviour::fade)
        fadeWhere ([&] (const Voice& voice) { return voice.place == place; });

    for (auto& voice : voices)
        if (voice.holdsBrake && voice.fadeStart == never && voice.place == place)
            releaseBrake (voice);
}

void FocusVoices::handle (const FocusEvent& event)
{
    switch (event.kind)
    {
        case FocusEventKind::trigger:
            trigger (event);
            break;
        case FocusEventKind::release:
            release (event.place);
            break;
        case FocusEventKind::stopAll:
            fadeWhere ([] (const Voice&) { return true; });
            break;
    }
}

FocusVoices::Voice& FocusVoices::freeVoice()
{
    const auto sounds = [] (const Voice& voice) { return voice.focus != nullptr && voice.fadeStart == never; };
    const auto isOlder = [&] (const Voice& a, const Voice& b)
    { return sounds (a) != sounds (b) ? sounds (a) : a.order < b.order; };

    if (std::count_if (voices.begin(), voices.end(), sounds) >= soundingVoices)
    {
        fade (*std::min_element (voices.begin(), voices.end(), isOlder));
        ++counts.stolen;
    }

    const auto unused =
        std::find_if (voices.begin(), voices.end(), [] (const Voice& voice) { return voice.focus == nullptr; });

    if (unused != voices.end())
        return *unused;

    // All of them play or fade: the one whose fade began first has the least left.
    auto& nearlyDone = *std::min_element (voices.begin(), voices.end(),
                                          [] (const Voice& a, const Voice& b) { return a.fadeStart < b.fadeStart; });
    finish (nearlyDone);
    ++counts.cut;
    return nearlyDone;
}

bool FocusVoices::cutAnother (const Voice& kept)
{
    Voice* leastImportant = nullptr;

    for (auto& voice : voices)
        if (voice.focus != nullptr && &voice != &kept
            && (leastImportant == nullptr
                || std::pair (voice.fadeStart, voice.order)
                       < std::pair (leastImportant->fadeStart, leastImportant->order)))
            leastImportant = &voice;

    if (leastImportant == nullptr)
        return false;

    finish (*leastImportant);
    ++counts.cut;
    return true;
}

/** @param voice  none where it plays nothing */
void FocusVoices::noteBegun (const FocusEvent& event, const Voice* voice)
{
    if (begunCount == begun.size())
        return;

    auto& noted = begun[begunCount++];
    noted = { event.request };

    if (voice != nullptr)
        noted = { event.request, true, voice->trigger + voice->focus->firstSample,
                  voice->trigger + voice->focus->synthesiser.focusSample(), voice->end (fadeLength) };
}

void FocusVoices::trigger (const FocusEvent& event)
{
    const auto* const bank = current >= 0 ? banks[static_cast<std::size_t> (current)].bank : nullptr;
    const auto* const focus = bank != nullptr && std::isfinite (event.amplitude) ? bank->at (event.place) : nullptr;

    if (focus == nullptr || focus->synthesiser.channelCount() != ceramics || focus->forceCount() > maximumForces)
    {
        ++counts.empty;
        return noteBegun (event, nullptr);
    }

    if (settings.retrigger == RetriggerBehaviour::restart)
        fadeWhere ([&] (const Voice& voice) { return voice.place == event.place; });

    auto& voice = freeVoice();
    // A prepared focus may be later than those of notes, and is no note.
    const auto isNote = event.place < FocusBank::firstPreparedPlace;
    const auto delay = settings.focusOnNote && isNote ? latency - focus->synthesiser.focusSample() : 0;
    voice = { focus, current, event.place, event.amplitude, clock + delay, counts.triggered };
    voice.holdsBrake = isNote && settings.noteOff == NoteOffBehaviour::brake && focus->brake.has_value();
    ++banks[static_cast<std::size_t> (current)].users;
    ++counts.triggered;
    noteBegun (event, &voice);
}

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
