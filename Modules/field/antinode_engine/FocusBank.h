#pragma once

#include "AlignedBuffers.h"
#include "SampleKernel.h"
#include "VoltageSynthesiser.h"

#include <antinode_base/LockFreeExchange.h>
#include <antinode_model/VoltageProgram.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace antinode
{
/** The brakes of a focus, ready to be begun when they were designed to, or later, when a note ends: they meet their
   modes where free decay has taken them. Read only once made. Docs/Theory.md, section 6.6. */
class PlayableBrake
{
public:
    static constexpr std::size_t maximumOscillations = 2048;

    /** @param brakes  a program of brakes only, 1 to maximumOscillations of them
        @throws InputError  as VoltageSynthesiser
        [worker] allocates */
    PlayableBrake (const VoltageProgram& brakes, Playback);

    /** The brakes as they were designed. [any] */
    const VoltageSynthesiser& designed() const { return synthesiser; }

    /** The first sample that may be played, from the trigger, where the brakes begin as designed. [any] */
    std::int64_t startSample() const { return start; }

    /** Nothing sounds from this sample on where they begin as designed. [any] */
    std::int64_t endSample() const { return end; }

    /** The number of samples of free decay after which every mode is down to 0.1 %, with nothing left to brake. [any]
     */
    std::int64_t longestDelay() const { return longest; }

    /** The factors of the brakes if they start later.
        @param delay    samples, 0 or more
        @param factors  room for one an oscillation
        [audio thread] an exponential, a sine and a cosine for every mode: some 10 us for 2048 of them */
    void factorsAfter (std::int64_t delay, std::span<std::complex<double>> factors) const;

private:
    /** The mode of an oscillation, and how its brake rotates with it. */
    struct Mode
    {
        double decay = 0, frequency = 0;    // a, 1/s, and b, rad/s
        std::complex<double> with, against; // the factor is with e^{s tau} - against conj (e^{s tau})

        bool isAs (const Mode& other) const
        {
            return decay == other.decay && frequency == other.frequency && with == other.with
                   && against == other.against;
        }
    };

    static Mode toMode (const Oscillation&);

    VoltageSynthesiser synthesiser;
    double rate;
    std::int64_t start = 0, end = 0, longest = 0;
    std::vector<Mode> modes;
};

/** The sample, from the trigger, on which the first of a program's own samples falls.
    @param focusSample  on which the focus falls
    @throws InputError  where they were made for another playback, or not for every ceramic
    [any] */
std::int64_t firstOwnSample (const VoltageProgram&, Playback, std::int64_t focusSample);

/** A free waveform, ready to be played: samples in single precision, each ceramic's one after the other. Read only once
    made. Docs/Theory.md, section 6.6. */
class PlayableSamples
{
public:
    /** @param program  with samples
        @throws InputError  as firstOwnSample, or where a sample is not finite
        [worker] allocates */
    PlayableSamples (const VoltageProgram& program, Playback, std::int64_t focusSample);

    /** From the trigger: none of the samples sounds before it. [any] */
    std::int64_t startSample() const { return start; }

    /** Nothing sounds from this sample on. [any] */
    std::int64_t endSample() const { return end; }

    /** The number of channels. [any] */
    int channelCount() const { return static_cast<int> (samples.size()); }

    /** What they take of the memory. [any] */
    std::size_t bytes() const { return channelCount() * static_cast<std::size_t> (end - start) * sizeof (float); }

    /** Adds the samples first .. first + count - 1, times an amplitude, to planar channels.
        @param amplitude  no unit
        @param channels   channelCount() pointers, V; sample n of the block is added at channels[i][offset + n]
        [audio thread] allocates nothing, locks nothing, any count >= 0, any order of blocks */
    void add (std::int64_t first, int count, double amplitude, double* const* channels,
              std::ptrdiff_t offset = 0) const;

    /** The same, where a voice fades.
        @param gains  of each sample of the block
        [audio thread] as add */
    void addFaded (std::int64_t first, int count, double amplitude, const double* gains, double* const* channels) const;

private:
    std::int64_t start = 0, end = 0;
    PlanarBuffer<float> samples;
    SampleKernel kernel = sampleKernel();
};

/** A designed focus, ready to play; read-only. */
struct PlayableFocus
{
    /** @throws InputError  as VoltageSynthesiser and PlayableSamples [worker] allocates */
    PlayableFocus (const VoltageProgram&, Playback);

    /** The channels that it takes where forces stand apart: its oscillations, brakes included, and for samples the
       ceramics. [any] */
    int forceCount() const
    {
        return synthesiser.oscillationCount() + (brake ? brake->designed().oscillationCount() : 0)
               + (samples ? samples->channelCount() : 0);
    }

    /** Whether it plays anything but samples. [any] */
    bool oscillates() const { return synthesiser.oscillationCount() > 0 || brake; }

    /** What its samples take of the memory. [any] */
    std::size_t sampleBytes() const { return samples ? samples->bytes() : 0; }

    VoltageSynthesiser synthesiser;         ///< Plays all oscillations but the brakes.
    std::optional<PlayableSamples> samples; ///< Of a free waveform.
    std::int64_t firstSample = 0;           ///< From the trigger: none of these sounds before it,
    std::int64_t endSample = 0;             ///< and none from it on.
    std::optional<PlayableBrake> brake;     ///< None if there are no brakes, or more than can be held.

private:
    PlayableFocus (const VoltageProgram&, Playback, bool isBraked);
};

/** The foci of the triggers, each place with a focus or none: 128 places of notes, the one that is edited, some that
   were touched last, and behind them those that were prepared one by one. Made on a worker, handed over whole, never
   changed. */
struct FocusBank
{
    static constexpr int notePlaces = 128;
    static constexpr int livePlace = notePlaces; ///< The focus as it is described, at its own place.
    static constexpr int firstTouchPlace = livePlace + 1;
    static constexpr int touchPlaces = 16;
    static constexpr int places = firstTouchPlace + touchPlaces;
    static constexpr int firstPreparedPlace = places;
    static constexpr int mostPrepared = 4096;
    static constexpr std::size_t mostSampleBytes = 256U << 20U; ///< Of all places together.

    std::array<std::shared_ptr<const PlayableFocus>, places> foci;
    std::vector<std::shared_ptr<const PlayableFocus>> prepared; ///< From firstPreparedPlace on.

    /** The focus of a place; null where it has none, or there is no such place. [audio thread] */
    const PlayableFocus* at (int place) const;

    /** The latest focus of all but the prepared ones, in samples after its trigger: the delay that lets every focus
        fall on its note. [any] */
    std::int64_t latestFocusSample() const;

    /** The first sample after a trigger from which on no focus sounds, its brake included. [any] */
    std::int64_t latestEndSample() const;
};

/** Whether a bank has room for a focus beside those that it holds prepared.
    @throws InputError  where their samples would take more than mostSampleBytes
    [any] */
void requireRoomBeside (const FocusBank&, const PlayableFocus&);

/** Whether a bank has room for as many foci like this one.
    @throws InputError  where their samples would take more than mostSampleBytes
    [any] */
void requireRoomInBank (const PlayableFocus&, std::size_t foci);

/** Banks of foci between the worker that designs them and the player. */
using BankHandOver = HandOver<FocusBank>;
} // namespace antinode
