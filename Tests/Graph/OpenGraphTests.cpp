#include <Support/SineBeam.h>

#include <antinode_engine/ForcePlayer.h>
#include <antinode_engine/PlateModel.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_graph/InstrumentGraph.h>

#include <catch2/catch.hpp>

#include <random>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 6, places = 8, length = 12000;
constexpr Playback playback { Reconstruction::bandLimited, rate };

/** A beam with a bank of foci at different places, every other one of samples: each has an allocation of its own, and
    brakes. */
struct Example
{
    std::shared_ptr<const ModalModel> model = std::make_shared<const ModalModel> (test::sineBeam (10, ceramics));
    Eigen::MatrixXd probe = shapesAt (*model, 0.01, 0);
    std::array<std::shared_ptr<const PlayableFocus>, places> foci;

    Example()
    {
        for (int i = 0; i < places; ++i)
        {
            FocusDescription focus;
            focus.targets = { Target {} };
            focus.targets[0].x = 0.01 * (i - places / 2);
            focus.targets[0].width = 0.03;
            focus.targets[0].peakVelocity = 0.02;
            focus.focusTime = 0.008 + 0.001 * i;
            focus.modes.count = 3 + i % 3;
            focus.transients.brake = 4;

            if (i % 2 == 1)
                focus.allocation.method = AllocationMethod::leastVoltage;

            foci[static_cast<std::size_t> (i)] =
                std::make_shared<const PlayableFocus> (designFocus (*model, focus, playback).program, playback);
        }
    }

    void giveTo (FocusVoices& voices) const
    {
        auto bank = std::make_unique<FocusBank>();
        std::copy (foci.begin(), foci.end(), bank->foci.begin());
        voices.handOver().give (std::move (bank));
    }
};

const Example& example()
{
    static const Example made;
    return made;
}

/** Triggers, note-offs and now and then a stop, at random; dense enough that voices are stolen. */
std::vector<FocusEvent> randomEvents (int count)
{
    std::mt19937 random (11);
    std::vector<FocusEvent> events;

    for (int i = 0; i < count; ++i)
    {
        const auto kind = random() % 40;
        events.push_back ({ static_cast<int> (random() % length),
                            kind == 0   ? FocusEventKind::stopAll
                            : kind < 14 ? FocusEventKind::release
                                        : FocusEventKind::trigger,
                            static_cast<int> (random() % places), 0.2 + 0.1 * static_cast<double> (random() % 8) });
    }

    std::stable_sort (events.begin(), events.end(),
                      [] (const FocusEvent& a, const FocusEvent& b) { return a.offset < b.offset; });
    return events;
}

/** All outputs of a graph: voltages and the probe x samples. Halfway it gets another bank. */
Eigen::MatrixXd played (InstrumentGraph graph, const std::vector<FocusEvent>& events, int block, int longestBlock = 64)
{
    graph.graph.prepare ({ rate, longestBlock });
    example().giveTo (graph.voiceNode().voices());
    Eigen::MatrixXd result (graph.graph.outputs(), length);
    auto next = events.begin();

    for (int start = 0; start < length; start += block)
    {
        const auto count = std::min (block, length - start);
        std::vector<FocusEvent> now;

        for (; next != events.end() && next->offset < start + count; ++next)
        {
            now.push_back (*next);
            now.back().offset -= start;
        }

        if (start <= length / 2 && length / 2 < start + block)
            example().giveTo (graph.voiceNode().voices());

        graph.graph.processParts (count, now,
                                  [&] (int offset, int samples, const double* const* outputs)
                                  {
                                      for (int i = 0; i < result.rows(); ++i)
                                          for (int n = 0; n < samples; ++n)
                                              result (i, start + offset + n) = outputs[i][n];
                                  });
    }

    return result;
}

double difference (const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    REQUIRE (a.allFinite());
    REQUIRE (a.cwiseAbs().maxCoeff() > 0);
    return (a - b).rowwise().lpNorm<Eigen::Infinity>().cwiseQuotient (a.rowwise().lpNorm<Eigen::Infinity>()).maxCoeff();
}

InstrumentGraph fused (const PlayerSettings& settings)
{
    InstrumentNodes nodes;
    nodes.settings = settings;
    nodes.probeShapes = example().probe;
    return instrumentGraph (example().model, std::move (nodes));
}

InstrumentGraph open (const PlayerSettings& settings, const InsertNodes& insert = {})
{
    InstrumentNodes nodes;
    nodes.settings = settings;
    nodes.choice = { true, insert };
    nodes.probeShapes = example().probe;
    return instrumentGraph (example().model, std::move (nodes));
}

/** A gain a channel, 1, 2, 3 ..., as an equaliser would stand there. */
class GainNode : public Node
{
public:
    explicit GainNode (int channelsToUse) : channels (channelsToUse) {}

    std::string name() const override { return "Gain"; }
    int inputs() const override { return channels; }
    int outputs() const override { return channels; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock& block) override
    {
        for (int i = 0; i < channels; ++i)
            for (int n = 0; n < block.count; ++n)
                block.outputs[i][n] = (i + 1) * block.inputs[i][n];
    }
    void reset() override {}

private:
    int channels;
};

/** Counts what passes, and gives nothing on. */
class PeakNode : public Node
{
public:
    PeakNode (int channelsToUse, double& peakToKeep) : channels (channelsToUse), peak (peakToKeep) {}

    std::string name() const override { return "Peak"; }
    int inputs() const override { return channels; }
    int outputs() const override { return 0; }
    void prepare (const NodeFormat&) override {}
    void process (const NodeBlock& block) override
    {
        for (int i = 0; i < channels; ++i)
            for (int n = 0; n < block.count; ++n)
                peak = std::max (peak, std::abs (block.inputs[i][n]));
    }
    void reset() override {}

private:
    int channels;
    double& peak;
};
} // namespace

TEST_CASE ("The open graph plays what the fused one plays, voices stolen, faded, braked and restarted", "[graph][open]")
{
    const auto events = randomEvents (400);
    const auto noteOff = GENERATE (NoteOffBehaviour::ignore, NoteOffBehaviour::fade, NoteOffBehaviour::brake);
    const auto onNote = GENERATE (false, true);
    PlayerSettings settings;
    settings.noteOff = noteOff;
    settings.focusOnNote = onNote;
    settings.retrigger = onNote ? RetriggerBehaviour::restart : RetriggerBehaviour::overlap;
    CHECK (difference (played (fused (settings), events, 200), played (open (settings), events, 200)) < 1e-12);
}

TEST_CASE ("The open graph does not depend, to the bit, on how time is cut", "[graph][open]")
{
    const auto events = randomEvents (400);
    PlayerSettings settings;
    settings.noteOff = NoteOffBehaviour::brake;
    const auto whole = played (open (settings), events, length, length);
    CHECK (played (open (settings), events, 1) == whole);
    CHECK (played (open (settings), events, 777) == whole);
    CHECK (played (open (settings), events, 64, 7) == whole);
}

TEST_CASE ("Voices of the open graph are stolen as those of the fused one", "[graph][open]")
{
    auto one = fused ({}), other = open ({});

    for (auto* const graph : { &one, &other })
    {
        graph->graph.prepare ({ rate, 64 });
        example().giveTo (graph->voiceNode().voices());
        const std::vector<FocusEvent> many (50, { 0, FocusEventKind::trigger, 1, 0.1 });
        graph->graph.processParts (640, many, [] (int, int, const double* const*) {});
    }

    const auto &a = one.voiceNode().voices().counters(), &b = other.voiceNode().voices().counters();
    CHECK (a.triggered == 50);
    CHECK (a.stolen == 26);
    CHECK (b.triggered == a.triggered);
    CHECK (b.stolen == a.stolen);
    CHECK (b.cut == a.cut);
    CHECK (other.voiceNode().voices().activeVoices() == one.voiceNode().voices().activeVoices());
}

TEST_CASE ("Where channels run out voices are cut for newer ones, and a focus beyond them all is empty",
           "[graph][open]")
{
    const auto wanted = example().foci[0]->forceCount();
    REQUIRE (wanted > 1);
    const auto counted = [&] (int channels)
    {
        ForcePlayer player (ceramics, rate, {}, channels);
        example().giveTo (player);
        std::vector<std::vector<double>> buffers (static_cast<std::size_t> (channels), std::vector<double> (64));
        std::vector<double*> pointers;

        for (auto& buffer : buffers)
            pointers.push_back (buffer.data());

        const std::vector<FocusEvent> four (4, { 0, FocusEventKind::trigger, 0, 1 });
        player.process (pointers.data(), 64, four);
        return std::pair (player.counters(), player.activeVoices());
    };
    CHECK (counted (4 * wanted).first.cut == 0);
    CHECK (counted (4 * wanted).second == 4);
    CHECK (counted (3 * wanted + 1).first.cut == 1);
    CHECK (counted (3 * wanted + 1).second == 3);
    CHECK (counted (wanted - 1).first.empty == 4);
    CHECK (counted (wanted - 1).second == 0);
}

TEST_CASE ("A node of one's own stands between any nodes of the open graph, and the limiter has the last word",
           "[graph][open]")
{
    const auto events = randomEvents (20);
    const auto plain = played (open ({}), events, 200);
    double peak = 0;
    const auto insert = [&] (NodeGraph& graph, GraphPlace place, int last)
    {
        if (place == GraphPlace::afterAllocation)
            return graph.add (std::make_unique<GainNode> (ceramics), last);

        if (place == GraphPlace::afterLimiter)
            graph.add (std::make_unique<PeakNode> (ceramics, peak), last);

        return last;
    };
    const auto changed = played (open ({}, insert), events, 200);
    const auto limit = example().model->ceramics[0].voltageLimit;

    for (int i = 0; i < ceramics; ++i)
    {
        const Eigen::RowVectorXd expected = ((i + 1) * plain.row (i)).cwiseMax (-limit).cwiseMin (limit);
        CHECK ((changed.row (i) - expected).cwiseAbs().maxCoeff() <= 1e-15 * limit);
    }

    CHECK (peak == changed.topRows (ceramics).cwiseAbs().maxCoeff());
    CHECK_THROWS (open ({}, [] (NodeGraph& graph, GraphPlace, int last)
                        { return graph.add (std::make_unique<GainNode> (3), last); }));
}

TEST_CASE ("Forces can be changed on their way to the allocation", "[graph][open]")
{
    const auto events = randomEvents (20);
    const auto plain = played (open ({}), events, 200);
    auto isInserted = false;
    const auto changed =
        played (open ({},
                      [&] (NodeGraph& graph, GraphPlace place, int last)
                      {
                          if (place != GraphPlace::afterForces)
                              return last;

                          isInserted = true;
                          return graph.add (std::make_unique<ChannelGainNode> (graph.node (last).outputs()), last);
                      }),
                events, 200);
    CHECK (isInserted);
    CHECK (changed == plain);
}
