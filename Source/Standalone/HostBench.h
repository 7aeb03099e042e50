#pragma once

#include "AudioHost.h"

#include <antinode_bench/TakeBench.h>
#include <antinode_identification/Wiring.h>

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace antinode
{
/** The audio device of a window, for a thread that may go on when the window has gone: from then on it is silent. */
class BenchDevice
{
public:
    /** @param hostToUse  outlives this, or close() */
    explicit BenchDevice (AudioHost& hostToUse) : host (&hostToUse) { allow(); }

    /** [message thread] */
    void close();

    /** As AudioCallback; all 0 when it is closed. [any] */
    std::int64_t samplesPlayed() const;
    double sampleRate() const;
    int lostBlocks() const;

    /** From now on takes may be played, until something stops all. [message thread] */
    void allow();

    /** Why nothing may be measured now, or empty. [any] */
    std::string obstacle() const;

    /** As AudioCallback. [any] */
    void play (std::shared_ptr<Take>, int ceramics, double fullScaleVolts, const std::array<int, 2>& inputs);
    void stop();
    void release();

private:
    mutable std::mutex mutex;
    AudioHost* host;         ///< Under the mutex, as the next line; none: closed.
    std::uint64_t stops = 0; ///< AudioHost::stopCommands() when it was allowed.
};

/** The bench of the standalone program: the ceramics by their routing, the sync channel on the output of the marker. It
   plays only while the program is armed; MUTE ALL, Escape, every other stop, disarming, another routing and another
   device end a run at 0 V. */
class HostBench final : public TakeBench
{
public:
    /** @param hasSync  a marker has an output
        @throws InputError  where no device plays, or the sensor's sensitivity is missing [any] */
    HostBench (std::shared_ptr<BenchDevice>, const BenchSensor&, bool hasSync, const ModalModel&);
    ~HostBench() override { device->release(); }

private:
    double sampleRate() const override { return device->sampleRate(); }
    std::int64_t calls() const override { return device->samplesPlayed(); }
    int lostBlocks() const override { return device->lostBlocks(); }
    void begin (std::shared_ptr<Take>) override;
    void stop() override { device->stop(); }
    bool isVoid() const override { return ! device->obstacle().empty(); }
    void leave() override {} // A take lives as long as the callback may come back to it.
    std::string whyEnded() const override;

    std::shared_ptr<BenchDevice> device;
    BenchSensor sensor;
};

/** The same with the wires of some outputs corrected: exchanged ones get each other's ceramics, reversed ones the other
    polarity. [any] */
OutputRouting withRightWires (OutputRouting, const std::vector<WireFinding>&);
} // namespace antinode
