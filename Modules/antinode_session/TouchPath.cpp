#include "TouchPath.h"

#include "NoteBank.h"
#include "TouchDesigner.h"

#include <antinode_graph/ChannelGainNode.h>
#include <antinode_graph/InputNode.h>
#include <antinode_graph/OverlaidFociNode.h>
#include <antinode_graph/SlewNode.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int longestTouchPart = 64; // samples: few enough that all ceramics' stay in the cache
} // namespace

TouchPath::TouchPath (std::shared_ptr<const ModalModel> model, int inputs, TrackBand band,
                      const FilterSettings& settings, const SkinThreshold& threshold, Listening listeningTo)
    : DevicePath (std::move (model), settings.sampleRate),
      traceRate (rate / static_cast<double> (filterTiming (band, settings).factor)), fingers (inputs),
      listening (std::move (listeningTo))
{
    const auto limits = voltageLimits (*modes);
    input = graph.add (std::make_unique<InputNode> (fingers), NodeGraph::noSource);
    filters = graph.add (
        std::make_unique<FilterNode> (static_cast<int> (modes->actuators()), fingers, band, settings, threshold),
        input);
    overlay = graph.add (std::make_unique<OverlaidFociNode> (static_cast<int> (modes->actuators()), PlayerSettings {}),
                         filters);
    auto last = overlay;

    if (const auto slews = slewLimits (*modes); slews.maxCoeff() > 0)
        last = graph.add (std::make_unique<SlewNode> (limits, slews), last);

    // What no design drives stays silent whatever a design says.
    if (listening.idle != 0)
    {
        auto muted = std::make_unique<ChannelGainNode> (static_cast<int> (modes->actuators()));
        muted->setMutes (listening.idle);
        last = graph.add (std::move (muted), last);
    }

    const auto limiter = graph.add (std::make_unique<LimiterNode> (limits), last);
    graph.setOutputs ({ limiter });
    const auto lags = addLagOutputs (graph, modes, limiter);

    if (lags)
        graph.setOutputs ({ limiter, lags.limiter });

    graph.prepare ({ rate, longestTouchPart });
    play (graph, limiter, lags);

    for (std::size_t i = 0; i < latencies.size(); ++i)
        latencies[i] = filterTiming (band, TouchDesigner::filterSettings (rate, i)).latencySamples();

    auto& voices = static_cast<OverlaidFociNode&> (graph.node (overlay)).voices();
    focusDesigns = std::make_unique<DesignWorker> (voices.handOver());
}

/** Notes as places of the bank, as loud as the gain has them; stops where notes mean nothing, too. */
std::span<const FocusEvent> TouchPath::placed (std::span<const FocusEvent> notes, const TouchControls& controls)
{
    std::size_t count = 0;

    if (controls.stops)
        placedNotes[count++] = { 0, FocusEventKind::stopAll, 0, 0 };

    for (const auto& note : notes.first (std::min (notes.size(), EventDelay::mostPerBlock)))
    {
        if (controls.notes == NoteMeaning::nothing && ! isStop (note))
            continue;

        auto& placed = placedNotes[count++] = note;
        placed.place = bankPlaceOf (note.place, controls.notes == NoteMeaning::spotOnly);
        placed.amplitude *= controls.focusGain;
    }

    return { placedNotes.data(), count };
}

template <typename Sample>
void TouchPath::process (const AudioBlock<Sample>& block, const TouchControls& controls, EventDelay& delay,
                         bool isLeaving, LevelMeters& meters, FingerMeters& fingerMeters)
{
    for (int j = 0; j < fingers; ++j)
        filterNode().setLevel (static_cast<std::size_t> (j), controls.levels[static_cast<std::size_t> (j)]);

    noteInputs (block, fingerMeters);
    fingerMeters.traceRate.store (traceRate, std::memory_order_relaxed);
    static_cast<InputNode&> (graph.node (input)).give (block.inputs, 1);
    setArmed (controls.isArmed && ! isLeaving);
    const auto due =
        delay.process (placed (block.events, controls), block.count, latencies[controls.latency], isLeaving);
    graph.processParts (block.count, due,
                        [&] (int offset, int count, Outputs outputs)
                        {
                            // Before its samples are written over.
                            if (listening.tap != nullptr)
                                listening.tap->write (outputs,
                                                      block.sensor != nullptr ? block.sensor + offset : nullptr, count);

                            const auto asked = limiters().back() != nullptr ? outputs + modes->actuators() : outputs;
                            writeVoltages (block, offset, count, asked);
                            noteVoltages (count, asked, meters);
                            noteMotions (fingerMeters);
                        });

    for (int j = 0; j < fingers; ++j)
    {
        const auto finger = static_cast<std::size_t> (j);
        fingerMeters.displacements.note (j, filterNode().motion().takeDisplacement (finger));
        fingerMeters.felt.note (j, filterNode().motion().takeFelt (finger));
    }

    meters.noteState (limiters().front()->limiter().isMuted(), 0);
}

/** Before anything is written: the outputs may lie where the inputs are. */
template <typename Sample>
void TouchPath::noteInputs (const AudioBlock<Sample>& block, FingerMeters& meters) const
{
    for (int j = 0; j < std::min (fingers, static_cast<int> (block.inputs.size())); ++j)
    {
        Sample peak = 0;

        for (int n = 0; n < block.count; ++n)
            if (const auto value = std::abs (block.inputs[static_cast<std::size_t> (j)][n]); std::isfinite (value))
                peak = std::max (peak, value);

        meters.inputs.note (j, static_cast<float> (peak));
    }
}

/** After every part: so no more displacements have come than are kept. */
void TouchPath::noteMotions (FingerMeters& meters)
{
    for (std::size_t j = 0; j < static_cast<std::size_t> (fingers); ++j)
        for (const auto displacement : filterNode().motion().takeRecent (j))
            meters.traces[j].push (displacement);
}

template void TouchPath::process (const AudioBlock<float>&, const TouchControls&, EventDelay&, bool, LevelMeters&,
                                  FingerMeters&);
template void TouchPath::process (const AudioBlock<double>&, const TouchControls&, EventDelay&, bool, LevelMeters&,
                                  FingerMeters&);
} // namespace antinode
