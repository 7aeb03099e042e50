#pragma once

#include "DesignWorker.h"
#include "DevicePath.h"
#include "SensorTap.h"
#include "TouchSettings.h"

#include <antinode_engine/EventDelay.h>
#include <antinode_graph/FilterNode.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** A device under the inputs of fingers and notes: filters, foci, limiter, meters. Notes wait as long as the filters
    take, so that a focus and a track of the same time stay together. */
class TouchPath : public DevicePath
{
public:
    /** @param inputs  1 to mostFingers
        @param settings  of the filters that it will be given
        @throws InputError  when the device or the rate cannot be played
        [worker] */
    TouchPath (std::shared_ptr<const ModalModel>, int inputs, TrackBand, const FilterSettings& settings,
               const SkinThreshold&, Listening = {});

    int inputs() const { return fingers; }

    /** Where its filters come from. [session's thread] */
    HandOver<FilterBank>& banks() { return filterNode().banks(); }

    /** Where its foci come from. [session's thread] */
    DesignWorker& foci() { return *focusDesigns; }

    /** Plays a block of any length.
        @param delay      of notes: lasts longer than the path
        @param isLeaving  from now on the voltages ramp to 0, and notes wait for the next path
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, const TouchControls&, EventDelay& delay, bool isLeaving, LevelMeters&,
                  FingerMeters&);

private:
    FilterNode& filterNode() { return static_cast<FilterNode&> (graph.node (filters)); }
    std::span<const FocusEvent> placed (std::span<const FocusEvent> notes, const TouchControls&);
    template <typename Sample>
    void noteInputs (const AudioBlock<Sample>&, FingerMeters&) const;
    void noteMotions (FingerMeters&);

    double traceRate; ///< Hz, of the filters.
    int fingers;
    Listening listening;
    NodeGraph graph;
    int input = 0, filters = 0, overlay = 0;                      ///< Indices of its nodes.
    std::array<std::int64_t, touchLatencies.size()> latencies {}; ///< Samples.
    std::array<FocusEvent, 1 + EventDelay::mostPerBlock> placedNotes {};
    std::unique_ptr<DesignWorker> focusDesigns; ///< Ends before the graph whose voices it gives banks to.
};
} // namespace antinode
