#pragma once

#include "DesignWorker.h"
#include "DevicePath.h"
#include "InstrumentMeters.h"
#include "PlayControls.h"
#include "SensorTap.h"

#include <antinode_graph/InstrumentGraph.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace antinode
{
/** How long notes wait at each of touchLatencies, samples: as long as filters take, so that a focus and a track of the
    same time stay together. */
using NoteDelays = std::array<std::int64_t, touchLatencies.size()>;

/** One device that is played by notes, by tracks for fingers, or by both: its graph, and the worker that designs its
    foci. */
class InstrumentPath : public DevicePath
{
public:
    /** @throws InputError  when the device or the format cannot be played
        [worker] */
    InstrumentPath (std::shared_ptr<const ModalModel>, double sampleRate, InstrumentNodes, Listening = {},
                    const NoteDelays& = {});

    /** Where its foci come from. [session's thread] */
    DesignWorker& foci() { return *designs; }

    /** Where its filters come from, if it has any. [session's thread] */
    HandOver<FilterBank>& banks() { return instrument.filterNode().banks(); }

    /** The monitor, if it has one. */
    PlateNode& plate() { return instrument.plateNode(); }

    /** By how many samples notes are to wait. [audio thread] */
    std::int64_t noteDelay (const PlayControls& controls) const { return delays[controls.latency]; }

    /** What plays its foci. [audio thread] */
    FocusVoices& voices() { return instrument.voiceNode().voices(); }

    /** Plays a block. Blocks of any length: long ones are played in parts.
        @param events  in place of the block's, whose notes are places of the bank here
        [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>&, std::span<const FocusEvent> events, const PlayControls&,
                  InstrumentMeters&);

private:
    void setControls (const PlayControls&);
    template <typename Sample>
    void takeInputs (const AudioBlock<Sample>&, const PlayControls&, FingerMeters&);
    template <typename Sample>
    void writePart (const AudioBlock<Sample>&, int offset, int count, Outputs outputs, InstrumentMeters&);
    template <typename Sample>
    void writeMonitor (const AudioBlock<Sample>&, int offset, int count, Outputs velocities) const;
    void noteFingers (FingerMeters&);

    InstrumentGraph instrument;
    const NoteDelays delays;
    Listening listening;
    int fingers, probes;
    double monitorGain = 1;
    std::int64_t countedTriggers = 0;      ///< Of its voices, by the meters.
    std::unique_ptr<DesignWorker> designs; ///< Ends before the graph whose voices it gives banks to.
};
} // namespace antinode
