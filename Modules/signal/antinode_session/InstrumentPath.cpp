#include "InstrumentPath.h"

#include <antinode_graph/InputNodes.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int longestPart = 512;    // samples that are processed at once: few enough to stay in the cache
constexpr int longestWidePart = 64; // the same where every oscillation has a channel, or all ceramics' filters are read

template <typename Sample>
float finitePeak (const Sample* samples, int count)
{
    Sample peak = 0;

    for (int n = 0; n < count; ++n)
        if (const auto value = std::abs (samples[n]); std::isfinite (value))
            peak = std::max (peak, value);

    return static_cast<float> (peak);
}
} // namespace

InstrumentPath::InstrumentPath (std::shared_ptr<const ModalModel> model, double sampleRateToUse, InstrumentNodes nodes,
                                Listening whoListens, const NoteDelays& noteDelays)
    : DevicePath (std::move (model), sampleRateToUse), delays (noteDelays), listening (std::move (whoListens)),
      fingers (nodes.filters != nullptr ? nodes.filters->inputs() : 0),
      probes (static_cast<int> (nodes.probeShapes.rows()))
{
    const auto isWide = nodes.choice.isOpen || fingers > 0;
    instrument = instrumentGraph (modes, std::move (nodes));

    // What no design drives stays silent whatever a design says, from the first sample on.
    instrument.gainNode().setMutes (listening.idle);
    instrument.graph.prepare ({ rate, isWide ? longestWidePart : longestPart });
    play (instrument.graph, instrument.limiter, instrument.lags);
    designs = std::make_unique<DesignWorker> (voices().handOver());
}

void InstrumentPath::setControls (const PlayControls& controls)
{
    voices().setSettings (controls.notes);
    instrument.gainNode().setGain (controls.outputTrim);
    instrument.gainNode().setMutes (controls.mutes | listening.idle);
    setArmed (controls.isArmed);
    setVoltageLimit (controls.voltageLimit);
    monitorGain = controls.monitorGain;
}

template <typename Sample>
void InstrumentPath::process (const AudioBlock<Sample>& block, std::span<const FocusEvent> events,
                              const PlayControls& controls, InstrumentMeters& meters)
{
    setControls (controls);

    if (fingers > 0)
        takeInputs (block, controls, meters.fingers);

    instrument.graph.processParts (block.count, events,
                                   [&] (int offset, int count, Outputs outputs)
                                   { writePart (block, offset, count, outputs, meters); });
    const auto triggered = voices().counters().triggered;
    meters.levels.addTriggered (triggered - std::exchange (countedTriggers, triggered));
    meters.levels.noteState (instrument.limiterNode().limiter().isMuted(), voices().activeVoices());
}

/** Before anything is written: the outputs may lie where the inputs are. */
template <typename Sample>
void InstrumentPath::takeInputs (const AudioBlock<Sample>& block, const PlayControls& controls, FingerMeters& meters)
{
    auto& filters = instrument.filterNode();
    static_cast<InputNode&> (instrument.graph.node (instrument.input)).give (block.inputs, 1);
    meters.traceRate.store (rate / static_cast<double> (filters.factor()), std::memory_order_relaxed);

    for (int j = 0; j < fingers; ++j)
    {
        const auto finger = static_cast<std::size_t> (j);
        filters.setLevel (finger, controls.levels[finger]);

        if (finger < block.inputs.size())
            meters.inputs.note (j, finitePeak (block.inputs[finger], block.count));
    }
}

/** In this order: the sensor's samples may be written over, and no more displacements come in a part than are kept. */
template <typename Sample>
void InstrumentPath::writePart (const AudioBlock<Sample>& block, int offset, int count, Outputs outputs,
                                InstrumentMeters& meters)
{
    if (listening.tap != nullptr)
        listening.tap->write (outputs, block.sensor != nullptr ? block.sensor + offset : nullptr, count);

    const auto velocities = outputs + modes->actuators();
    const auto asked = instrument.lags ? velocities + probes : outputs;
    writeVoltages (block, offset, count, asked);
    writeMonitor (block, offset, count, velocities);
    noteVoltages (count, asked, meters.levels);
    noteFingers (meters.fingers);

    for (int i = 0; i < probes; ++i)
        meters.levels.noteProbe (i, static_cast<float> (absolutePeak (velocities[i], count)));

    if (probes > 0)
        meters.trace.write (velocities[0], count);
}

template <typename Sample>
void InstrumentPath::writeMonitor (const AudioBlock<Sample>& block, int offset, int count, Outputs velocities) const
{
    for (std::size_t i = 0; i < block.monitor.size(); ++i)
        if (static_cast<int> (i) < probes)
            std::transform (velocities[i], velocities[i] + count, block.monitor[i] + offset,
                            [this] (double velocity) { return static_cast<Sample> (velocity * monitorGain); });
        else
            std::fill_n (block.monitor[i] + offset, count, Sample (0));
}

void InstrumentPath::noteFingers (FingerMeters& meters)
{
    for (int j = 0; j < fingers; ++j)
    {
        auto& motion = instrument.filterNode().motion();
        const auto finger = static_cast<std::size_t> (j);
        meters.displacements.note (j, motion.takeDisplacement (finger));
        meters.felt.note (j, motion.takeFelt (finger));

        for (const auto displacement : motion.takeRecent (finger))
            meters.traces[finger].push (displacement);
    }
}

template void InstrumentPath::process (const AudioBlock<float>&, std::span<const FocusEvent>, const PlayControls&,
                                       InstrumentMeters&);
template void InstrumentPath::process (const AudioBlock<double>&, std::span<const FocusEvent>, const PlayControls&,
                                       InstrumentMeters&);
} // namespace antinode
