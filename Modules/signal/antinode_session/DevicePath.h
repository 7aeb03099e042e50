#pragma once

#include "InstrumentMeters.h"

#include <antinode_engine/FocusEvents.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_graph/OutputNodes.h>
#include <antinode_model/ModalModel.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** Samples of a block between a host and what plays. Outputs may be the same memory as inputs and the sensor; those
   that nothing plays become silent. */
template <typename Sample>
struct AudioBlock
{
    std::span<const Sample* const> inputs; ///< Channel k is finger k or, of Antinode Plate, ceramic k; missing ones are
                                           ///< silent.
    std::span<Sample* const> outputs; ///< Channel k is ceramic k, 1.0 its device's full scale, or probe k, 1.0 = 1 m/s.
    std::span<Sample* const> monitor; ///< Velocities at probes; may be empty.
    int count = 0;                    ///< Samples.
    std::span<const FocusEvent> events; ///< In the order of their offsets; a note's place is its number.
    const Sample* sensor = nullptr;     ///< What listens to the surface; none: not plugged in.

    /** [audio thread] */
    void silence() const
    {
        for (const auto& channels : { outputs, monitor })
            for (auto* const channel : channels)
                std::fill_n (channel, count, Sample (0));
    }
};

/** What all paths have: one device at one sample rate, nodes, and limiters behind which no voltage is changed. Made by
   a session, played by the audio thread, freed by the session. */
class DevicePath
{
public:
    DevicePath (const DevicePath&) = delete;
    DevicePath& operator= (const DevicePath&) = delete;

    const ModalModel& model() const { return *modes; }
    double sampleRate() const { return rate; }

    /** LimiterNode::setFocusLimits, of all outputs: all that plays adds up below them. [any] */
    void setFocusLimits (const Eigen::VectorXd& volts);

    /** By how much all that is designed happens later, because lags of ceramics are undone, samples. [worker] */
    std::int64_t lateSamples() const { return late; }

    /** How long the slowest mode takes to decay by 60 dB, s. [worker] */
    double ringingSeconds() const;

    /** Whether a ramp to silence that began so many samples ago has ended. [audio thread] */
    bool isSilentAfter (std::int64_t samples) const;

    /** As if nothing had come in. [audio thread] */
    void reset() { nodes->reset(); }

protected:
    /** Channels that a graph gives. */
    using Outputs = const double* const*;

    DevicePath (std::shared_ptr<const ModalModel>, double sampleRate);
    ~DevicePath() = default;

    /** Once the graph is prepared, which outlives this. @param limiter  index of the node @param lags  behind it */
    void play (NodeGraph&, int limiter, const LagOutputs& lags = {});

    void setArmed (bool isArmed);
    void setVoltageLimit (double volts);

    /** @param voltages  of all ceramics, as outputs are asked for */
    template <typename Sample>
    void writeVoltages (const AudioBlock<Sample>&, int offset, int count, Outputs voltages) const;
    void noteVoltages (int count, Outputs voltages, LevelMeters&);

    const std::shared_ptr<const ModalModel> modes;
    const double rate; ///< Hz

private:
    NodeGraph* nodes = nullptr;
    std::vector<LimiterNode*> limiters; ///< The second one behind the filters of lags, where there are any.
    std::int64_t late = 0;              ///< Samples.
};

/** The largest absolute value of a block. [audio thread] */
double absolutePeak (const double* samples, int count);

/** Paths on their way from the session to the audio thread and back: one atomic exchange each way. A path that
    plays ramps to rest before the next one takes its place.
    @tparam Path  has sampleRate(), reset() and isSilentAfter (samples): whether the ramp that began so long ago has
        ended */
template <typename Path>
class PathExchange
{
public:
    PathExchange() = default;

    /** Frees everything; nothing may be playing. [worker] */
    ~PathExchange() { clear(); }

    PathExchange (const PathExchange&) = delete;
    PathExchange& operator= (const PathExchange&) = delete;

    /** Hands a path over and frees what came back. One that was not taken yet is replaced. [worker] */
    void give (std::unique_ptr<Path> path)
    {
        collect();
        delete next.exchange (path.release(), std::memory_order_acq_rel);
    }

    /** Frees what came back. [worker] */
    void collect() { delete retired.exchange (nullptr, std::memory_order_acq_rel); }

    /** Frees everything; nothing may be playing. [worker] */
    void clear()
    {
        delete next.exchange (nullptr);
        delete retired.exchange (nullptr);
        delete std::exchange (playing, nullptr);
    }

    /** The path for a block of so many samples, or none where there is none for this rate. [audio thread] */
    Path* current (double sampleRate, int count)
    {
        const auto isUsable = [&] { return playing != nullptr && playing->sampleRate() == sampleRate; };

        if (next.load (std::memory_order_acquire) != nullptr && retired.load (std::memory_order_acquire) == nullptr)
        {
            const auto mayGo = ! isUsable() || isResting || (isLeaving() && playing->isSilentAfter (leavingSamples));

            if (mayGo)
            {
                retired.store (playing, std::memory_order_release);
                playing = next.exchange (nullptr, std::memory_order_acq_rel);
            }

            leavingSamples = mayGo ? -1 : (isLeaving() ? leavingSamples + count : 0);
        }

        isResting = false;
        return isUsable() ? playing : nullptr;
    }

    /** Whether the current path has to ramp to rest, since another one waits. [audio thread] */
    bool isLeaving() const { return leavingSamples >= 0; }

    /** The path that plays comes to rest at once; one that waits takes its place with the next block, without a ramp.
        [audio thread, or while nothing plays] */
    void reset()
    {
        if (playing != nullptr)
            playing->reset();

        isResting = true;
    }

private:
    std::atomic<Path*> next { nullptr }, retired { nullptr };
    Path* playing = nullptr; ///< Of the audio thread, as the next line.
    std::int64_t leavingSamples = -1;
    bool isResting = false; ///< Whether nothing has played since the reset.
};
} // namespace antinode
