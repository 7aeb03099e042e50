#include "FmaPeak.h"

#include <Support/SineBeam.h>

#include <antinode_engine/AlignedBuffers.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_graph/InstrumentGraph.h>
#include <antinode_graph/SurfaceNode.h>

#include <benchmark/benchmark.h>

#include <numbers>
#include <utility>

// The graph that is played, fused and open, with so many foci at once: 512 samples at 48 kHz. And the surface as
// Antinode Plate has it.

namespace antinode
{
namespace
{
constexpr double rate = 48000;
constexpr int samples = 512, ceramics = 8;
constexpr Playback playback { Reconstruction::bandLimited, rate };

/** A beam of 30 modes, of which a focus controls 14 for half a second: it does not end while it is measured. */
struct Played
{
    std::shared_ptr<const ModalModel> model = std::make_shared<const ModalModel> (test::sineBeam (30, ceramics));
    InstrumentGraph graph;
    std::vector<FocusEvent> events;

    Played (bool isOpen, int voices)
    {
        const auto probe = shapesAt (*model, 0.01, 0);
        InstrumentNodes nodes;
        nodes.choice = { isOpen };
        nodes.probeShapes = probe;
        graph = instrumentGraph (model, std::move (nodes));
        graph.graph.prepare ({ rate, isOpen ? 64 : 512 });
        FocusDescription focus;
        focus.targets = { Target {} };
        focus.targets[0].width = 0.03;
        focus.targets[0].peakVelocity = 0.02;
        focus.focusTime = 0.5;
        focus.modes.count = 14;
        focus.modes.order = ModeOrder::frequency; // The strongest ones are beyond half the rate.
        auto bank = std::make_unique<FocusBank>();
        bank->foci[0] = std::make_shared<const PlayableFocus> (designFocus (*model, focus, playback).program, playback);
        graph.voiceNode().voices().handOver().give (std::move (bank));
        events.assign (static_cast<std::size_t> (voices), { 0, FocusEventKind::trigger, 0, 0.1 });
    }

    void play (std::span<const FocusEvent> now)
    {
        graph.graph.processParts (
            samples, now, [] (int, int, const double* const* outputs) { benchmark::DoNotOptimize (outputs[0][0]); });
    }
};

/** Arguments: whether it is open, how many foci play. */
void graphPlays (benchmark::State& state)
{
    Played played (state.range (0) != 0, static_cast<int> (state.range (1)));
    auto left = 0;

    for (auto run : state)
    {
        if (left == 0) // The foci end after some 46 blocks.
        {
            state.PauseTiming();
            played.graph.graph.reset();
            played.play (played.events);
            left = 40;
            state.ResumeTiming();
        }

        played.play ({});
        --left;
    }

    state.SetItemsProcessed (state.iterations() * samples);
}
BENCHMARK (graphPlays)->ArgsProduct ({ { 0, 1 }, { 0, 1, 4, 16, 24 } })->ArgNames ({ "open", "foci" });

/** Arguments: modes, whether it is quick. */
void surfaceMoves (benchmark::State& state)
{
    const auto modes = static_cast<int> (state.range (0));
    auto beam = test::sineBeam (modes, ceramics);
    beam.angularFrequencies *= 2 * std::numbers::pi * 1e5 / beam.angularFrequencies.maxCoeff(); // As of a plate.
    const auto model = std::make_shared<const ModalModel> (std::move (beam));
    const Eigen::MatrixXd probes = shapesAt (*model, 0.01, 0).replicate (8, 1);
    std::unique_ptr<SurfaceNode> node = std::make_unique<PlateModelNode> (model, probes);

    if (state.range (1) != 0)
        node = std::make_unique<PlateNode> (model, probes);

    node->prepare ({ rate, samples });
    const PlanarBuffer<double> in (ceramics, samples), out (8, samples);

    for (std::size_t i = 0; i < ceramics; ++i)
        for (int n = 0; n < samples; ++n)
            in.channel (i)[n] = std::sin (0.02 * n * static_cast<double> (i + 1));

    for (auto run : state)
        node->process (NodeBlock { in.channels(), out.channels(), samples, {} });

    state.SetItemsProcessed (state.iterations() * samples);
}
BENCHMARK (surfaceMoves)->ArgsProduct ({ { 14, 100, 500 }, { 0, 1 } })->ArgNames ({ "modes", "quick" });
} // namespace
} // namespace antinode
