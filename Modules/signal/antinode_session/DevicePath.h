#pragma once

#include "AudioBlock.h"
#include "LevelMeters.h"

#include <antinode_graph/LagOutputs.h>
#include <antinode_graph/LimiterNode.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_model/ModalModel.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace antinode
{
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
} // namespace antinode
