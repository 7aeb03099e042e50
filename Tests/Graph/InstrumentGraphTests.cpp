#include <Support/SineBeam.h>

#include <antinode_engine/LagFilters.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_graph/InstrumentGraph.h>
#include <antinode_graph/OutputNodes.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr int ceramics = 6;

struct Example
{
    std::shared_ptr<const ModalModel> model = std::make_shared<const ModalModel> (test::sineBeam (10, ceramics));
    FocusDesign design;
    Eigen::MatrixXd probe;

    explicit Example (double rate, AllocationMethod method = AllocationMethod::exact)
    {
        FocusDescription focus;
        focus.targets = { Target {} };
        focus.targets[0].width = 0.03;
        focus.targets[0].peakVelocity = 0.02;
        focus.focusTime = 0.02;
        focus.modes.count = 5;
        focus.allocation.method = method;
        design = designFocus (*model, focus, { Reconstruction::bandLimited, rate });
        probe = shapesAt (*model, 0, 0);
    }
};

/** What the standard graph gives from a note at the first sample on: outputs x samples. */
Eigen::MatrixXd played (const Example& example, double rate, int block, Eigen::Index length, double amplitude = 1)
{
    const auto outputs = needsLagFilters (*example.model) ? 2 * ceramics + 1 : ceramics + 1;
    InstrumentNodes nodes;
    nodes.probeShapes = example.probe;
    auto standard = instrumentGraph (example.model, std::move (nodes));
    standard.graph.prepare ({ rate, block });
    auto bank = std::make_unique<FocusBank>();
    bank->foci[0] =
        std::make_shared<const PlayableFocus> (example.design.program, Playback { Reconstruction::bandLimited, rate });
    standard.voiceNode().voices().handOver().give (std::move (bank));
    Eigen::MatrixXd result (outputs, length);
    std::vector<std::vector<double>> buffers (static_cast<std::size_t> (outputs),
                                              std::vector<double> (static_cast<std::size_t> (block)));
    std::vector<double*> channels;

    for (auto& buffer : buffers)
        channels.push_back (buffer.data());

    const FocusEvent event { 0, FocusEventKind::trigger, 0, amplitude };

    for (Eigen::Index start = 0; start < length; start += block)
    {
        const auto count = static_cast<int> (std::min<Eigen::Index> (block, length - start));
        standard.graph.process (channels.data(), count, std::span (&event, start == 0 ? 1U : 0U));

        for (Eigen::Index i = 0; i < outputs; ++i)
            for (int n = 0; n < count; ++n)
                result (i, start + n) = buffers[static_cast<std::size_t> (i)][static_cast<std::size_t> (n)];
    }

    return result;
}
} // namespace

TEST_CASE ("The real-time graph plays the voltages of the offline render", "[graph]")
{
    const auto method = GENERATE (AllocationMethod::exact, AllocationMethod::leastVoltage);

    for (const auto rate : { 48000.0, 192000.0 })
    {
        const Example example (rate, method);
        RenderSettings settings;
        settings.playback = { Reconstruction::bandLimited, rate };
        settings.duration = 0.03;
        settings.probeShapes = example.probe;
        const auto offline = renderOffline (*example.model, example.design.program, settings);
        const auto length = offline.voltages.cols();
        const auto peak = offline.voltages.cwiseAbs().maxCoeff();
        const auto result = played (example, rate, 256, length);
        const auto rounding = example.design.program.samples ? 1e-7 : 1e-12; // Samples are kept in single precision.
        CHECK ((result.topRows (ceramics) - offline.voltages).cwiseAbs().maxCoeff() < rounding * peak);

        // The monitor is the plate in real time: a few parts in a thousand from the plate model at these frequencies.
        const auto deviation = (result.row (ceramics) - offline.probeVelocities.row (0)).cwiseAbs().maxCoeff();
        CHECK (deviation < 0.02 * offline.probeVelocities.cwiseAbs().maxCoeff());
    }
}

TEST_CASE ("The real-time graph does not depend on blocks, from 8 kHz to 768 kHz", "[graph]")
{
    for (const auto rate : { 8000.0, 44100.0, 192000.0, 768000.0 })
    {
        const Example example (48000);
        const auto length = static_cast<Eigen::Index> (0.024 * rate);
        const auto whole = played (example, rate, 8193, length);
        CAPTURE (rate);
        CHECK (whole.allFinite());
        CHECK (played (example, rate, 1, length) == whole);
        CHECK (played (example, rate, 100, length) == whole);
    }
}

TEST_CASE ("No voltage of the graph exceeds its ceramic's limit", "[graph]")
{
    const Example example (48000, GENERATE (AllocationMethod::exact, AllocationMethod::leastVoltage));
    const auto result = played (example, 48000, 64, 1200, 1e4);
    CHECK (result.topRows (ceramics).cwiseAbs().maxCoeff() <= 150);
    CHECK (result.allFinite());
}

TEST_CASE ("Where ceramics lag, what is asked for is what files get, whatever the blocks", "[graph][lag]")
{
    Example example (48000);
    auto model = *example.model;

    for (std::size_t i = 0; i < ceramics; ++i)
        model.ceramics[i].lag = { 3e-6 * static_cast<double> (i * i), 1e-5 * static_cast<double> (i), 0.01 };

    example.model = std::make_shared<const ModalModel> (model);
    const auto result = played (example, 48000, 256, 1500);
    const auto asked = withLagsUndone (model, result.topRows (ceramics), voltageLimits (model), 48000);
    CHECK ((result.bottomRows (ceramics) - asked.voltages.leftCols (1500)).cwiseAbs().maxCoeff()
           < 1e-12 * asked.voltages.cwiseAbs().maxCoeff());
    CHECK (played (example, 48000, 7, 1500) == result);
    CHECK (played (example, 48000, 64, 1500, 1e4).cwiseAbs().maxCoeff() <= 150);
}

TEST_CASE ("Disarmed is silent: a ramp down, and none up until it is armed", "[graph]")
{
    LimiterNode node (Eigen::VectorXd::Constant (1, 10));
    node.prepare ({ 48000, 1000 });
    std::vector<double> input (1000, 5), output (1000);
    const double* inputs[] { input.data() };
    double* outputs[] { output.data() };
    const NodeBlock block { inputs, outputs, 1000, {} };
    node.process (block);
    CHECK (output[999] == 5);
    node.setArmed (false);
    node.process (block);
    CHECK (output[0] < 5);
    CHECK (output[120] == Approx (2.5).epsilon (0.02));
    CHECK (output[300] == 0);
    node.process (block);
    CHECK (output[500] == 0);
    node.setArmed (true);
    node.process (block);
    CHECK (output[999] == 5);
}
