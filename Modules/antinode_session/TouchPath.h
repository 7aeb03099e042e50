#pragma once

#include "DesignWorker.h"
#include "LevelMeters.h"
#include "SensorTap.h"
#include "TouchSettings.h"

#include <antinode_engine/EventDelay.h>
#include <antinode_graph/FilterNode.h>
#include <antinode_graph/InputNode.h>
#include <antinode_graph/LagOutputs.h>
#include <antinode_graph/LimiterNode.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_model/ModalModel.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** Samples of a block on their way from fingers' inputs to ceramics. */
template <typename Sample>
struct TouchBlock
{
    std::span<const Sample* const> inputs; ///< Channel k is finger k; missing ones are silent.
    std::span<Sample* const> ceramics;     ///< Channel k is ceramic k, 1.0 its device's full scale; may be the same
                                           ///< memory as the inputs. Those beyond the device's ceramics become silent.
    int count = 0;                         ///< Samples.
    std::span<const FocusEvent> events = {}; ///< In the order of their offsets; a note's place is its number.
    const Sample* sensor = nullptr; ///< What listens to the surface; none: not plugged in. May lie where ceramics do.
};

/** One device at one sample rate under the inputs of fingers and notes: filters, foci, limiter, meters. Notes wait as
    long as the filters take, so that a focus and a track of the same time stay together. Made by the session, played by
    the audio thread, freed by the session. */
class TouchPath
{
public:
    /** @param inputs  1 to mostFingers
        @param settings  of the filters that it will be given
        @throws InputError  when the device or the rate cannot be played
        [worker] */
    TouchPath (std::shared_ptr<const ModalModel>, int inputs, TrackBand, const FilterSettings& settings,
               const SkinThreshold&, Listening = {});

    double sampleRate() const { return rate; }
    int inputs() const { return fingers; }

    /** V of a sample of 1.0. [any] */
    double fullScaleVolts() const { return modes->fullScaleVoltage; }

    /** Where its filters come from. [session's thread] */
    HandOver<FilterBank>& banks() { return filterNode().banks(); }

    /** Where its foci come from. [session's thread] */
    DesignWorker& foci() { return *focusDesigns; }

    /** Plays a block of any length.
        @param delay      of notes: lasts longer than the path
        @param isLeaving  from now on the voltages ramp to 0, and notes wait for the next path
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const TouchBlock<Sample>&, const TouchControls&, EventDelay& delay, bool isLeaving, LevelMeters&,
                  FingerMeters&);

    /** The device. [any] */
    const ModalModel& model() const { return *modes; }

    /** LimiterNode::setFocusLimits, of all outputs: tracks and foci add up below them. [any] */
    void setFocusLimits (const Eigen::VectorXd& volts);

    /** By how much all comes later than its latency, because lags of ceramics are undone, samples. [worker] */
    std::int64_t lateSamples() const { return late; }

    /** Whether a ramp to silence that began so many samples ago has ended. [audio thread] */
    bool isSilentAfter (std::int64_t samples) const;

    /** As if no input had come. [audio thread] */
    void reset() { graph.reset(); }

private:
    using Outputs = const double* const*; ///< Of the graph: the voltages behind the limiter, then what is asked for.

    Outputs askedFor (Outputs) const;

    FilterNode& filterNode() { return static_cast<FilterNode&> (graph.node (filters)); }
    LimiterNode& limiterNode() { return static_cast<LimiterNode&> (graph.node (limiter)); }
    std::span<const FocusEvent> placed (std::span<const FocusEvent> notes, const TouchControls&);
    template <typename Sample>
    void noteInputs (const TouchBlock<Sample>&, FingerMeters&) const;
    template <typename Sample>
    void write (const TouchBlock<Sample>&, int offset, int count, Outputs) const;
    void note (int count, Outputs, LevelMeters&);
    void noteMotions (FingerMeters&);

    std::shared_ptr<const ModalModel> modes;
    double rate, traceRate; ///< Hz, of the host and of the filters.
    int fingers;
    Listening listening;
    NodeGraph graph;
    int input = 0, filters = 0, overlay = 0, limiter = 0; ///< Indices of its nodes.
    std::int64_t late = 0;                                ///< Samples, because lags are undone.
    LimiterNode* outputLimiter = nullptr; ///< Of the graph, behind the filters of lags; none: nothing lags.
    std::array<std::int64_t, touchLatencies.size()> latencies {}; ///< Samples.
    std::array<FocusEvent, 1 + EventDelay::mostPerBlock> placedNotes {};
    std::unique_ptr<DesignWorker> focusDesigns; ///< Ends before the graph whose voices it gives banks to.
};
} // namespace antinode
