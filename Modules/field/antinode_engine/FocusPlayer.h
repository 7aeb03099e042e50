#pragma once

#include "AlignedBuffers.h"
#include "FocusBank.h"
#include "FocusEvents.h"

#include <algorithm>
#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** What a note-off does to the foci that its place plays. */
enum class NoteOffBehaviour
{
    ignore, ///< A focus plays to its end: the default, notes are mostly shorter than foci.
    fade,   ///< It fades out.
    brake   ///< While the note is held, the plate rings on after the focus; then the brake begins, not before its own
            ///< time.
};

/** What a trigger does where its place sounds already. */
enum class RetriggerBehaviour
{
    overlap, ///< Both play: velocities add up.
    restart  ///< The earlier one fades out.
};

struct PlayerSettings
{
    NoteOffBehaviour noteOff = NoteOffBehaviour::ignore;
    RetriggerBehaviour retrigger = RetriggerBehaviour::overlap;
    bool focusOnNote = false; ///< Delays voices so that every focus falls latestFocusSample() after its event.
    double fadeTime = 0.002;  ///< s, of stolen, released and stopped voices.
};

/** A trigger that was played: the samples of the player's clock that it takes. */
struct BegunVoice
{
    std::uint32_t request = 0; ///< Of its event.
    bool plays = false;        ///< False: its place has no focus, and all that follows means nothing.
    std::int64_t onset = 0;    ///< The first sample that sounds,
    std::int64_t focus = 0;    ///< that on which the focus falls,
    std::int64_t end = 0;      ///< and the one from which nothing sounds any more, where it is neither held nor faded.
};

/** How often things happened since the start. */
struct PlayerCounters
{
    std::int64_t triggered = 0; ///< Voices begun.
    std::int64_t empty = 0;     ///< Triggers of places without a focus.
    std::int64_t stolen = 0;    ///< Voices faded out for a newer one.
    std::int64_t cut = 0;       ///< Fading voices ended early since even those were needed.
};

/** Voices: which foci play, since when and how loud, without their samples. A trigger begins a voice, a newer one
    may steal it, a note-off may fade it or begin its brake.

    A voice keeps the design that it began with, also when a new bank arrives. A voice that holds its brake back is
    silent after its focus. It ends for good when its modes have decayed by themselves, or when it fades: then
    nothing is braked. Docs/Theory.md, section 6.6. */
class FocusVoices
{
public:
    static constexpr int soundingVoices = 24; ///< At once; one more and the oldest fades out.

    FocusVoices (const FocusVoices&) = delete;
    FocusVoices& operator= (const FocusVoices&) = delete;

    /** Where a worker gives banks. They are taken at the start of a block. [any] */
    BankHandOver& handOver() { return exchange; }

    /** What events do from the next block on; the fade time stays. Voices that play go on. [audio thread] */
    void setSettings (const PlayerSettings&);

    /** Samples from an event to its focus where foci fall on notes, of the bank that plays; else 0. [audio thread] */
    std::int64_t latencySamples() const { return settings.focusOnNote ? latency : 0; }

    /** Voices that play or fade just now. [audio thread] */
    int activeVoices() const;

    const PlayerCounters& counters() const { return counts; }

    /** The sample of the player's clock that comes next. [audio thread] */
    std::int64_t time() const { return clock; }

    /** The triggers since the last call, at most mostBegun; valid until the next block. [audio thread] */
    std::span<const BegunVoice> takeBegun() { return std::span (begun).first (std::exchange (begunCount, 0)); }

    /** Ends all voices at once, without a fade. [audio thread] */
    void reset();

protected:
    static constexpr int allVoices = 32; ///< Those that fade among them.
    static constexpr std::int64_t never = INT64_MAX;

    struct Voice
    {
        const PlayableFocus* focus = nullptr;
        int bank = 0; ///< Index into banks.
        int place = 0;
        double amplitude = 0;
        std::int64_t trigger = 0; ///< The sample of the player's clock at which the focus' own time is 0.
        std::int64_t order = 0;   ///< Which trigger it was.
        std::int64_t fadeStart = never;
        bool holdsBrake = false;     ///< Until its note ends.
        std::int64_t brakeDelay = 0; ///< Samples by which the brake begins later than designed.

        std::int64_t end (std::int64_t fadeLength) const;
    };

    /** @param ceramics          of the foci that are played: others count as empty
        @param maximumForces     foci with a larger forceCount() count as empty
        @throws InputError       as FocusPlayer
        [worker] allocates */
    FocusVoices (int ceramics, double sampleRate, PlayerSettings, int maximumForces);

    /** Nothing may be processing. [worker] */
    ~FocusVoices();

    /** Goes through a block from event to event.
        @param render  called with the first sample and the length of each stretch between two events, while the
                       clock stands at its first sample [audio thread] */
    template <typename Render>
    void playStretches (int count, std::span<const FocusEvent> events, Render&& render)
    {
        takeBank();
        auto done = 0;
        const auto playTo = [&] (int end)
        {
            render (done, end - done);
            clock += end - done;
            finishEnded();
            done = end;
        };

        for (const auto& event : events)
        {
            playTo (std::clamp (event.offset, done, std::max (done, count - 1)));
            handle (event);
        }

        playTo (count);
    }

    /** Gives banks back that no voice plays; afterwards nothing of them may be looked at. [audio thread] */
    void giveUnusedBanks();

    /** Ends a voice at once. [audio thread] */
    void finish (Voice&);

    /** Ends the voice that matters least: the one whose fade began first, else the oldest. @return  false where
        there is none but this one [audio thread] */
    bool cutAnother (const Voice&);

    std::size_t voiceIndex (const Voice& voice) const { return static_cast<std::size_t> (&voice - voices.data()); }

    /** What a late brake is to be multiplied with; none where it begins as designed. */
    const std::complex<double>* findBrakeFactors (const Voice& voice) const
    {
        return voice.brakeDelay > 0 ? brakeFactors[voiceIndex (voice)].data() : nullptr;
    }

    int ceramics;
    std::int64_t fadeLength, clock = 0;
    std::vector<double> fadeGains; ///< fadeLength of them, falling from 1 to 0.
    std::array<Voice, allVoices> voices {};

private:
    static constexpr std::size_t mostBegun = 256;

    using Factors = std::array<std::complex<double>, PlayableBrake::maximumOscillations>;

    struct UsedBank
    {
        const FocusBank* bank = nullptr;
        int users = 0;
    };

    void takeBank();
    void handle (const FocusEvent&);
    void trigger (const FocusEvent&);
    void noteBegun (const FocusEvent&, const Voice*);
    void fade (Voice&);
    void release (int place);
    void releaseBrake (Voice&);
    void finishEnded();
    Voice& freeVoice();
    template <typename Condition>
    void fadeWhere (Condition);

    PlayerSettings settings;
    int maximumForces;
    std::int64_t latency = 0;
    BankHandOver exchange;
    std::array<UsedBank, allVoices + 2> banks {};
    int current = -1;                  ///< Index into banks of the one that triggers use.
    std::vector<Factors> brakeFactors; ///< A set for each voice.
    PlayerCounters counts;
    std::array<BegunVoice, mostBegun> begun {};
    std::size_t begunCount = 0;
};

/** Overlapping foci, each with its own design and amplitude, summed into one channel per ceramic: the voices with their
   synthesis and mixing fused.

    Output depends on the samples' and events' places in time only, not, to the bit, on how time is cut into blocks.
   Limits are not its concern: VoltageLimiter stands behind it. */
class FocusPlayer : public FocusVoices
{
public:
    /** @param ceramics    channels, 1 or more
        @param sampleRate  Hz
        @throws InputError  when one of them, or the fade time, is not usable
        [worker] allocates */
    FocusPlayer (int ceramics, double sampleRate, PlayerSettings);

    /** Writes a block.
        @param channels  one pointer per ceramic, to count samples each, V; overwritten
        @param count     0 or more
        [audio thread] allocates nothing, locks nothing */
    void process (double* const* channels, int count, std::span<const FocusEvent> events);

private:
    static constexpr int fadeChunk = 64; ///< Samples.

    void render (double* const* channels, int offset, int count);
    void addOscillations (const Voice&, std::int64_t from, std::int64_t to, double* const* channels) const;
    void renderVoice (const Voice&, double* const* channels, int offset, int count);
    void renderFade (const Voice&, double* const* channels, int offset, std::int64_t from, std::int64_t to);
    void fadeOscillations (const Voice&, double* const* channels, int offset, std::int64_t from, std::int64_t to);
    double* const* shiftedBy (std::int64_t samples, double* const* channels);

    PlanarBuffer<double> scratch; ///< Of a fading voice.
    std::vector<double*> shifted; ///< A pointer a ceramic.
};
} // namespace antinode
