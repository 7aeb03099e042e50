#pragma once

#include <antinode_engine/VoltageLimiter.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace antinode
{
/** One output: its amplifier and wiring. */
struct OutputChain
{
    double voltsPerFullScale = 0; ///< V at the ceramic for a sample of 1.0; 0: the device's full scale.
    int polarity = 1;             ///< 1 or -1.

    bool operator== (const OutputChain&) const = default;
};

/** A pulse on an output of its own from each focus on, for recorders, EEG and photodiodes. */
struct SyncMarker
{
    int output = -1;        ///< From 0; below: there is none.
    double level = 0.5;     ///< Share of full scale, 0 to 1.
    double seconds = 0.005; ///< How long it lasts, above 0 to 1 s.

    bool operator== (const SyncMarker&) const = default;
};

/** The output of each ceramic: each ceramic has at most one output, each output at most one ceramic. Counted from 0. */
struct OutputRouting
{
    static constexpr int maximumCeramics = 64, maximumOutputs = 128, monitors = 2;
    static constexpr int none = -1;

    std::array<int, maximumCeramics> outputs {};       ///< Of each ceramic; `none`: nothing drives it.
    std::array<OutputChain, maximumOutputs> chains {}; ///< Of each output.
    int monitor = none;                                ///< The first of two outputs with the velocity at the probes.
    SyncMarker marker;

    bool operator== (const OutputRouting&) const = default;
};

/** Ceramic k on output k, no monitor: an amplifier that got a velocity as a voltage would be a surprise. [any] */
OutputRouting straightRouting();

/** The same with a ceramic on another output, or on none; whatever had that output loses it. [any] */
OutputRouting withOutput (OutputRouting, int ceramic, int output);

/** The same with the monitor on another pair, or on none; whatever had those outputs loses them. [any] */
OutputRouting withMonitor (OutputRouting, int firstOutput);

/** The same with this marker; whatever had its output loses it. [any] */
OutputRouting withMarker (OutputRouting, const SyncMarker&);

/** The volts of a full-scale sample at the output of each ceramic; 0: the device's full scale, or no output. [any] */
std::vector<double> amplifierVoltages (const OutputRouting&);

/** @throws InputError  where an output is no output or is used twice, or a chain has a gain or a polarity that is none
    [any] */
void validate (const OutputRouting&);

/** Meters of each output for other threads: its peak since the last read, and the number of clamped samples. */
class OutputMeters
{
public:
    /** One writer. @param peak  share of full scale [audio thread] */
    void note (int output, float peak, std::int64_t clamped)
    {
        auto& present = peaks[static_cast<std::size_t> (output)];

        if (peak > present.load (std::memory_order_relaxed))
            present.store (peak, std::memory_order_relaxed);

        if (clamped > 0)
            clampedCounts[static_cast<std::size_t> (output)].fetch_add (clamped, std::memory_order_relaxed);
    }

    /** [audio thread] */
    void noteBadNumber() { badNumberCount.fetch_add (1, std::memory_order_relaxed); }

    /** The largest magnitude since the last call, share of full scale. One reader. [any] */
    float takePeak (int output) { return peaks[static_cast<std::size_t> (output)].exchange (0); }

    /** Samples that were beyond full scale and were held there. [any] */
    std::int64_t clampedSamples (int output) const { return clampedCounts[static_cast<std::size_t> (output)]; }

    /** Blocks in which something that is not finite came in: it went out as 0. [any] */
    std::int64_t badNumbers() const { return badNumberCount; }

private:
    std::array<std::atomic<float>, OutputRouting::maximumOutputs> peaks {};
    std::array<std::atomic<std::int64_t>, OutputRouting::maximumOutputs> clampedCounts {};
    std::atomic<std::int64_t> badNumberCount { 0 };
};

/** The channels of a block of the router. */
struct RouterBlock
{
    std::span<const float* const> ceramics; ///< Channel k is ceramic k; 1.0 = fullScaleVolts.
    std::span<const float* const> monitor;  ///< 1.0 = 1 m/s
    std::span<float* const>
        outputs;                   ///< Of the device; null where a channel is not open. Others than these do not exist.
    int count = 0;                 ///< Samples.
    double fullScaleVolts = 0;     ///< 0: nothing is played yet.
    bool isArmed = false;          ///< Else there is no identify tone either.
    const float* marker = nullptr; ///< 1 from each focus on for its time; none: nothing marks.
    int stay = -1; ///< Ceramics and marker are those of a measurement in this stay of the router; -1: of none.
};

/** The last station before the device: from voltages to what each output must give so that the amplifier behind it
   makes them.

    Nothing leaves it that is not finite or is beyond full scale. Whatever changes the routing or the source ramps to 0
   V first. The samples do not depend on how they are cut into blocks, as far as commands come at the same samples. */
class OutputRouter
{
public:
    static constexpr double rampTime = 0.005; ///< s, of each ramp to 0 V and back.

    OutputRouter();
    ~OutputRouter();
    OutputRouter (const OutputRouter&) = delete;
    OutputRouter& operator= (const OutputRouter&) = delete;

    /** To rest, for a sample rate. A mute stays. [worker] nothing may be processing */
    void prepare (double sampleRate);

    /** From one of the next blocks on, after a ramp to 0 V. @param limits  of the ceramics, V @throws InputError  as
       validate [message thread] */
    void setRouting (const OutputRouting&, const std::vector<double>& limits);

    /** Frees what the audio thread has done with; until then it takes no other routing. Now and then. [message thread]
     */
    void collect();

    /** MUTE ALL: ramps every output to 0 V and holds it there until it is released. [any] */
    void muteAll() { wantsMute = true; }

    /** Lets the outputs come back by a ramp. [any] */
    void release() { wantsMute = false; }

    /** Whether everything is muted: by muteAll(), or by a number that was not finite. [any] */
    bool isMuted() const { return wantsMute; }

    /** Whether the ramp to 0 V of a mute has ended. [any] */
    bool isSilent() const { return silent; }

    /** Plays the identify tone on one ceramic, and nothing else on any; `none`: back to the foci. Only while armed.
        [any] */
    void identify (int ceramic) { wantedTone = ceramic; }
    int identified() const { return wantedTone; }

    /** Whether outputs are a measurement's, and nothing else's; 0 V without one. Only while armed. [any] */
    void measure (bool isWanted) { wantsMeasurement = isWanted; }

    /** Whether a measurement may begin or go on. [any] */
    bool mayMeasure (bool isArmed) const { return wantsMeasurement && isArmed && ! wantsMute; }

    /** Whether what a measurement gives now goes out, at least on the ramp of its end. [audio thread] */
    bool playsMeasurement() const
    {
        return source == measurement && (isOnLeave || sourceLeft == 0) && ! (isMuting && ! muteRamp.isMoving());
    }

    /** It counts how often a measurement was left: what was measured in one stay does not go out in another. [audio
        thread] */
    int stay() const { return stays; }
    static constexpr int noStay = -1;

    /** Whether outputs are on the ramp to 0 V of what they leave. [audio thread] */
    bool isLeaving() const { return isOnLeave; }

    /** How long a marker lasts; 0: there is none. [audio thread] */
    std::int64_t markerSamples() const;

    /** [audio thread] allocates nothing, locks nothing */
    void process (const RouterBlock&);

    OutputMeters& meters() { return outputMeters; }

private:
    static constexpr int foci = OutputRouting::none, measurement = OutputRouting::maximumCeramics; ///< Of `source`.

    struct Table;
    struct Part;

    void takeCommands (bool isArmed);
    void changeSource();
    bool hasTable() const;
    void takeTable();
    void latchMute();
    void processPart (const RouterBlock&, const Part&);
    void fillCeramic (const RouterBlock&, const Part&, int output, float* to);
    void fillTone (const RouterBlock&, const Part&, int output, float* to) const;

    std::atomic<Table*> next { nullptr }, retired { nullptr };
    std::atomic<bool> wantsMute { false }, wantsMeasurement { false }, silent { false };
    std::atomic<int> wantedTone { OutputRouting::none };
    OutputMeters outputMeters;

    std::unique_ptr<Table> table; ///< Of the audio thread, as all that follows.
    double rate = 48000;
    int stays = 0;
    std::int64_t rampSamples = 1, sourceLeft = 0, toneSample = 0;
    int source = foci, blockSource = foci; ///< Or the ceramic of the identify tone.
    bool isMuting = false, isOnLeave = false, hasNewTable = false;
    SafetyRamp muteRamp { 1 }, sourceRamp { 1 };
};
} // namespace antinode
