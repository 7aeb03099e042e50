#include <antinode_base/InputError.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_graph/MidiTriggers.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_graph/VoiceNode.h>

#include <Support/SineBeam.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 6;
constexpr int length = 2400;

VoltageProgram exampleProgram()
{
    FocusDescription focus;
    focus.targets = { Target {} };
    focus.targets[0].width = 0.03;
    focus.targets[0].peakVelocity = 0.02;
    focus.focusTime = 0.02;
    focus.modes.count = 5;
    return designFocus (test::sineBeam (10, ceramics), focus, { Reconstruction::bandLimited, rate }).program;
}

void giveBank (VoiceNode& node, const VoltageProgram& program)
{
    auto bank = std::make_unique<FocusBank>();
    bank->foci[60] = std::make_shared<const PlayableFocus> (program, Playback { Reconstruction::bandLimited, rate });
    node.voices().handOver().give (std::move (bank));
}

/** All outputs of a graph under one note at sample 100, in blocks. */
Eigen::MatrixXd playedBy (NodeGraph& graph, int block)
{
    Eigen::MatrixXd result (length, graph.outputs());

    for (int start = 0; start < length; start += block)
    {
        const auto count = std::min (block, length - start);
        std::vector<double*> channels;

        for (int i = 0; i < graph.outputs(); ++i)
            channels.push_back (result.col (i).data() + start);

        const FocusEvent event { 100 - start, FocusEventKind::trigger, 60, 0.8 };
        const auto isHere = start <= 100 && 100 < start + count;
        graph.process (channels.data(), count, std::span (&event, isHere ? 1U : 0U));
    }

    return result;
}

NodeGraph playerGraph (const VoltageProgram& program)
{
    NodeGraph graph;
    const auto player = graph.add (std::make_unique<PlayerNode> (ceramics, PlayerSettings {}), NodeGraph::noSource);
    graph.setOutputs ({ player });
    graph.prepare ({ rate, 256 });
    giveBank (dynamic_cast<PlayerNode&> (graph.node (player)), program);
    return graph;
}

/** A node as a developer would add one: a gain a ceramic. */
class GainNode : public Node
{
public:
    std::string name() const override { return "Gain"; }
    int inputs() const override { return ceramics; }
    int outputs() const override { return ceramics; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock& block) override
    {
        for (int i = 0; i < ceramics; ++i)
            for (int n = 0; n < block.count; ++n)
                block.outputs[i][n] = (i + 1) * block.inputs[i][n];
    }
    void reset() override {}
};
} // namespace

TEST_CASE ("Forces and allocation as nodes of their own give what the player fuses", "[graph]")
{
    const auto program = exampleProgram();
    auto fused = playerGraph (program);
    NodeGraph apart;
    auto forceNode = std::make_unique<ForceNode> (ceramics, PlayerSettings {}, 100);
    auto& player = *forceNode;
    const auto forces = apart.add (std::move (forceNode), NodeGraph::noSource);
    const auto voltages = apart.add (std::make_unique<AllocationNode> (player, ceramics), forces);
    apart.setOutputs ({ voltages });
    apart.prepare ({ rate, 256 });
    giveBank (player, program);
    const auto a = playedBy (fused, 200), b = playedBy (apart, 200);
    CHECK (a.cwiseAbs().maxCoeff() > 0);
    CHECK ((a - b).cwiseAbs().maxCoeff() < 1e-12 * a.cwiseAbs().maxCoeff());
}

TEST_CASE ("A graph does not depend on blocks, also on those longer than prepared for", "[graph]")
{
    const auto program = exampleProgram();
    const auto play = [&] (int block)
    {
        auto graph = playerGraph (program);
        return playedBy (graph, block);
    };
    const auto whole = play (length);
    CHECK (play (1) == whole);
    CHECK (play (256) == whole);
    CHECK (play (777) == whole);
}

TEST_CASE ("A node of one's own takes its place with one line", "[graph]")
{
    const auto program = exampleProgram();
    auto plain = playerGraph (program), changed = playerGraph (program);
    changed.setOutputs ({ changed.add (std::make_unique<GainNode>(), 0) });
    changed.prepare ({ rate, 256 });
    const auto a = playedBy (plain, 200), b = playedBy (changed, 200);

    for (int i = 0; i < ceramics; ++i)
        CHECK ((b.col (i) - (i + 1) * a.col (i)).norm() <= 1e-15 * b.col (i).norm());

    NodeGraph wrong;
    const auto forces = wrong.add (std::make_unique<ForceNode> (ceramics, PlayerSettings {}, 3), NodeGraph::noSource);
    CHECK_THROWS_AS (wrong.add (std::make_unique<GainNode>(), forces), InputError);
}

TEST_CASE ("Notes become events to the sample", "[graph]")
{
    MidiTriggers triggers;
    juce::MidiBuffer notes;
    notes.addEvent (juce::MidiMessage::noteOn (3, 60, static_cast<juce::uint8> (64)), 17);
    notes.addEvent (juce::MidiMessage::noteOff (3, 60), 40);
    notes.addEvent (juce::MidiMessage::controllerEvent (1, 7, 100), 41);
    notes.addEvent (juce::MidiMessage::allNotesOff (1), 900);
    const juce::uint8 system[] { 1, 2, 3, 4, 5 };
    notes.addEvent (juce::MidiMessage::createSysExMessage (system, 5), 42);
    const auto events = triggers.read (notes, 64);
    REQUIRE (events.size() == 3);
    CHECK (events[0].offset == 17);
    CHECK (events[0].place == 60);
    CHECK (events[0].amplitude == Approx (64 / 127.0));
    CHECK (events[1].kind == FocusEventKind::release);
    CHECK (events[2].kind == FocusEventKind::stopAll);
    CHECK (events[2].offset == 63);
}
