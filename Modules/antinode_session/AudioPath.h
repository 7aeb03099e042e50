#pragma once

#include "DesignWorker.h"
#include "LevelMeters.h"
#include "PlaySettings.h"
#include "ProbeTrace.h"
#include "SensorTap.h"

#include <antinode_graph/StandardGraph.h>

#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** The channels of a block: full scale is 1.0. */
template <typename Sample>
struct OutputBlock
{
    std::span<Sample* const> ceramics; ///< Channel k is ceramic k; those beyond the device's ceramics become silent.
    std::span<Sample* const> monitor;  ///< Probe velocities; may be empty.
    int count = 0;                     ///< Samples.
    const Sample* sensor = nullptr; ///< What listens to the surface; none: not plugged in. May lie where ceramics do.
};

/** Whether the nodes of a path are fused or stand apart, and what stands between them. */
struct GraphChoice
{
    bool isOpen = false;
    InsertNodes insert; ///< Of the open graph; none: nothing.
};

/** What plays one device at one sample rate: its graph, and the worker that designs its foci. Made by the session,
   played by the audio thread, freed by the session. */
class AudioPath
{
public:
    static constexpr int probes = 2;

    /** @param probeShapes  2 x N_m, kg^-1/2
        @throws InputError  when the device or the format cannot be played
        [worker] */
    AudioPath (std::shared_ptr<const ModalModel>, double sampleRate, const Eigen::MatrixXd& probeShapes,
               const GraphChoice& = {}, Listening = {});

    DesignWorker& worker() { return *designs; }
    PlateNode& plate() { return standard.plateNode(); }
    const ModalModel& model() const { return *modes; }
    double sampleRate() const { return rate; }

    /** LimiterNode::setFocusLimits, of all outputs. [any] */
    void setFocusLimits (const Eigen::VectorXd& volts);

    /** By how much all that is designed happens later, because lags of ceramics are undone, samples. [worker] */
    std::int64_t lateSamples();

    /** Back to rest. [audio thread] */
    void reset() { standard.graph.reset(); }

    /** Plays a block. Blocks of any length: long ones are played in parts.
        @param events  in the order of their offsets
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const OutputBlock<Sample>&, std::span<const FocusEvent> events, const PlayControls&, LevelMeters&,
                  ProbeTrace&);

    /** Whether a ramp to silence that started the given number of samples ago has ended. [audio thread] */
    bool isSilentAfter (std::int64_t samples) const;

private:
    using Outputs =
        const double* const*; ///< Of the graph: the ceramics, the probes, then what is asked for where anything lags.

    Outputs askedFor (Outputs) const;
    template <typename Sample>
    void write (const OutputBlock<Sample>&, int offset, int count, Outputs) const;
    void note (int count, Outputs, LevelMeters&, ProbeTrace&);

    std::shared_ptr<const ModalModel> modes;
    double rate;
    StandardGraph standard;
    std::unique_ptr<DesignWorker> designs;
    Listening listening;
    LimiterNode* outputLimiter = nullptr; ///< Of the graph, behind the filters of lags; none: nothing lags.
    double toFullScale, monitorGain = 1;
    std::int64_t countedTriggers = 0; ///< Of its voices, by the meters.
};
} // namespace antinode
