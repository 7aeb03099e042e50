#pragma once

#include "BankHandOver.h"
#include "FocusEvent.h"

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace antinode
{
/** What a note-off does to the foci that its note has started. */
enum class NoteOffBehaviour
{
    ignore, ///< The focus plays to its end: the default, since notes are mostly shorter than foci.
    fade,   ///< The focus fades out.
    brake   ///< The plate rings on while the note is held; then the brake starts, never before its designed time.
};

/** What a trigger does while its note still plays. */
enum class RetriggerBehaviour
{
    overlap, ///< Both play: velocities add up.
    restart  ///< The earlier focus fades out.
};

struct PlayerSettings
{
    NoteOffBehaviour noteOff = NoteOffBehaviour::ignore;
    RetriggerBehaviour retrigger = RetriggerBehaviour::overlap;
    bool focusOnNote = false; ///< Delays voices so that every focus falls latestFocusSample() after its event.
    double fadeTime = 0.002;  ///< s, of stolen, released and stopped voices.
};

/** Event counters since the start. */
struct PlayerCounters
{
    std::int64_t triggered = 0; ///< Voices started.
    std::int64_t empty = 0;     ///< Triggers of places without a focus.
    std::int64_t stolen = 0;    ///< Voices faded out for a newer one.
    std::int64_t cut = 0;       ///< Fading voices ended early because all voices were in use.
};

/** Voices: overlapping foci, each with its own design and amplitude, summed into one channel per ceramic.

    A voice keeps the design that it began with, also when a new bank arrives. Output depends on the samples' and events' places in time only,
    not, to the bit, on how time is cut into blocks. Limits are not its concern: VoltageLimiter stands behind it.

    A voice that holds its brake back is silent after its focus. It ends for good when its modes have decayed by themselves, or when it fades:
    then nothing is braked.
    Docs/Theory.md, section 6.6. */
class FocusPlayer
{
public:
    static constexpr int soundingVoices = 24; ///< At once; one more and the oldest fades out.

    /** @param ceramics    channels, 1 or more
        @param sampleRate  Hz
        @throws InputError  when one of them, or the fade time, is not usable
        [worker] allocates */
    FocusPlayer (int ceramics, double sampleRate, PlayerSettings);

    /** No block may be in process. [worker] */
    ~FocusPlayer();
    FocusPlayer (const FocusPlayer&) = delete;
    FocusPlayer& operator= (const FocusPlayer&) = delete;

    /** Where a worker hands banks over. They are taken at the start of a block. [any] */
    BankHandOver& handOver() { return exchange; }

    /** Writes a block.
        @param channels  one pointer per ceramic, to count samples each, V; overwritten
        @param count     0 or more
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (Sample* const* channels, int count, std::span<const FocusEvent> events);

    /** Samples from an event to its focus in the current bank if foci are delayed onto notes; else 0. [audio thread] */
    std::int64_t latencySamples() const { return settings.focusOnNote ? latency : 0; }

    /** The number of voices that play or fade. [audio thread] */
    int activeVoices() const;

    const PlayerCounters& counters() const { return counts; }

    /** Ends all voices at once, without a fade. [audio thread] */
    void reset();

private:
    static constexpr int allVoices = 32; ///< Those that fade among them.
    static constexpr int fadeChunk = 64; ///< Samples.
    static constexpr std::int64_t never = INT64_MAX;
    using Factors = std::array<std::complex<double>, PlayableBrake::mostOscillations>;

    struct UsedBank
    {
        const FocusBank* bank = nullptr;
        int users = 0;
    };

    struct Voice
    {
        const PlayableFocus* focus = nullptr;
        int bank = 0; ///< Index into banks.
        int place = 0;
        double amplitude = 0;
        std::int64_t trigger = 0; ///< The sample of the player's clock at which the focus' own time is 0.
        std::int64_t order = 0;   ///< The number of its trigger.
        std::int64_t fadeStart = never;
        bool holdsBrake = false;     ///< Until its note ends.
        std::int64_t brakeDelay = 0; ///< Samples by which the brake begins later than designed.

        std::int64_t end (std::int64_t fadeLength) const;
    };

    void takeBank();
    void giveUnusedBanks();
    void handle (const FocusEvent&);
    void trigger (const FocusEvent&);
    void fade (Voice&);
    void release (int place);
    void releaseBrake (Voice&);
    std::size_t indexOf (const Voice& voice) const { return static_cast<std::size_t> (&voice - voices.data()); }
    void finish (Voice&);
    void finishEnded();
    Voice& freeVoice();
    template <typename Condition>
    void fadeWhere (Condition);
    template <typename Sample>
    void render (Sample* const* channels, int offset, int count);
    template <typename Sample>
    void add (const Voice&, std::int64_t from, std::int64_t to, Sample* const* channels) const;
    template <typename Sample>
    void renderVoice (const Voice&, Sample* const* channels, int offset, int count);
    template <typename Sample>
    void renderFade (const Voice&, Sample* const* channels, int offset, std::int64_t from, std::int64_t to);
    template <typename Sample>
    Sample* const* scratchChannels();
    template <typename Sample>
    Sample* const* shiftedBy (std::int64_t samples, Sample* const* channels);

    int ceramics;
    PlayerSettings settings;
    std::int64_t fadeLength, clock = 0, latency = 0;
    std::vector<double> fadeGains; ///< fadeLength of them, falling from 1 to 0.
    BankHandOver exchange;
    std::array<UsedBank, allVoices + 2> banks {};
    int current = -1; ///< Index into banks of the one that triggers use.
    std::array<Voice, allVoices> voices {};
    std::vector<Factors> brakeFactors; ///< A set for each voice where notes hold brakes back, else none.
    std::vector<double> scratchDouble;
    std::vector<float> scratchFloat;
    std::vector<double*> channelsDouble, shiftedDouble;
    std::vector<float*> channelsFloat, shiftedFloat;
    PlayerCounters counts;
};
} // namespace antinode
