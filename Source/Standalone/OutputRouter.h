#pragma once

#include "OutputMeters.h"
#include "OutputRouting.h"

#include <antinode_engine/SafetyRamp.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace antinode
{
/** The channels of a block of the router. */
struct RouterBlock
{
    std::span<const float* const> ceramics; ///< Channel k is ceramic k; 1.0 = fullScaleVolts.
    std::span<const float* const> monitor;  ///< 1.0 = 1 m/s
    std::span<float* const>
        outputs;               ///< Of the device; null where a channel is not open. Others than these do not exist.
    int count = 0;             ///< Samples.
    double fullScaleVolts = 0; ///< 0: nothing is played yet.
    bool isArmed = false;      ///< Else there is no identify tone either.
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

    /** [audio thread] allocates nothing, locks nothing */
    void process (const RouterBlock&);

    OutputMeters& meters() { return outputMeters; }

private:
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
    std::atomic<bool> wantsMute { false }, silent { false };
    std::atomic<int> wantedTone { OutputRouting::none };
    OutputMeters outputMeters;

    std::unique_ptr<Table> table; ///< Of the audio thread, as all that follows.
    double rate = 48000;
    std::int64_t rampSamples = 1, sourceLeft = 0, toneSample = 0;
    int tone = OutputRouting::none, blockTone = OutputRouting::none;
    bool isMuting = false, isLeaving = false, hasNewTable = false;
    SafetyRamp muteRamp { 1 }, sourceRamp { 1 };
};
} // namespace antinode
