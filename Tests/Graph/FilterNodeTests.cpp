#include <antinode_graph/InputNodes.h>
#include <antinode_graph/NodeGraph.h>
#include <antinode_graph/OutputNodes.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double rate = 48000;
constexpr int ceramics = 3, inputs = 2, samples = 9600;

const SkinThreshold flatThreshold { "flat", Eigen::Vector2d (40, 1000), Eigen::Vector2d (1e-7, 1e-7) };

std::unique_ptr<const FilterBank> randomBank (std::uint64_t seed)
{
    RandomNumbers random (seed);
    const auto timing = filterTiming ({}, {});
    FingerFilters filters { rate, timing.factor, timing.delay, {}, 0, 0 };

    for (int j = 0; j < inputs; ++j)
        filters.taps.push_back (
            1e6 * Eigen::MatrixXd::NullaryExpr (timing.taps, ceramics, [&] { return random.uniform() - 0.5; }));

    return std::make_unique<const FilterBank> (filterBank (filters));
}

Eigen::MatrixXd someInputs()
{
    return Eigen::MatrixXd::NullaryExpr (
        inputs, samples, [] (auto j, auto n) { return std::sin (0.02 * static_cast<double> (n * (j + 1))); });
}

/** A graph of inputs, given in some precision, and one node, played in blocks; something may happen before each of
    them. */
template <typename Sample>
Eigen::MatrixXd playedBy (NodeGraph& graph, const Eigen::MatrixXd& from, int block,
                          const std::function<void (int)>& before)
{
    const auto wide = graph.outputs();
    const Eigen::Matrix<Sample, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> given = from.cast<Sample>();
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> played (wide, from.cols());

    for (int start = 0; start < from.cols(); start += block)
    {
        before (start);
        const auto count = std::min (block, static_cast<int> (from.cols()) - start);
        std::vector<const Sample*> in;
        std::vector<double*> out;

        for (Eigen::Index j = 0; j < given.rows(); ++j)
            in.push_back (given.row (j).data() + start);

        for (Eigen::Index i = 0; i < wide; ++i)
            out.push_back (played.row (i).data() + start);

        static_cast<InputNode&> (graph.node (0)).give (in, 1);
        graph.process (out.data(), count, {});
    }

    return played;
}

struct FilterGraph
{
    NodeGraph graph;

    FilterGraph()
    {
        graph.add (std::make_unique<InputNode> (inputs), NodeGraph::noSource);
        graph.add (std::make_unique<FilterNode> (ceramics, inputs, TrackBand {}, FilterSettings {}, flatThreshold), 0);
        graph.setOutputs ({ 1 });
        graph.prepare ({ rate, 64 });

        for (std::size_t j = 0; j < inputs; ++j)
            node().setLevel (j, 1e-5);
    }

    FilterNode& node() { return static_cast<FilterNode&> (graph.node (1)); }
};
} // namespace

TEST_CASE ("Before its first bank a filter node gives 0 V, then what a player gives after its fade", "[live][graph]")
{
    FilterGraph filters;
    const auto given = randomBank (1);
    filters.node().banks().give (std::make_unique<const FilterBank> (*given));
    const auto from = someInputs();
    const auto played = playedBy<double> (filters.graph, from, 100, [] (int) {});
    FilterPlayer player (*given, 1);
    Eigen::VectorXf voltages (ceramics);
    Eigen::Vector2d offset (0, 0);
    CHECK (played.leftCols (12).isZero (0));

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        // What the inputs had on the average of the last 0.3 s is taken off.
        const Eigen::Vector2d rest = from.col (n) - offset;
        offset += (1 - std::exp (-2 * std::numbers::pi * 0.5 / rate)) * rest;
        player.process ((1e-5 * rest).cast<float>(), voltages);

        // Levels have reached theirs in 5 ms, which the filters remember for 0.1 s: 0.13 s at most.
        if (n > 6240)
            REQUIRE ((played.col (n).cast<float>() - voltages).norm() < 1e-5F * (1 + voltages.norm()));
    }
}

TEST_CASE ("Banks, levels and blocks of a filter node: the same samples for any blocks", "[live][graph]")
{
    const auto from = someInputs();
    const auto play = [&] (int block)
    {
        FilterGraph filters;
        return playedBy<double> (filters.graph, from, block,
                                 [&] (int start)
                                 {
                                     if (start % 2400 == 0)
                                         filters.node().banks().give (
                                             randomBank (static_cast<std::uint64_t> (start + 1)));

                                     if (start == 4800)
                                         filters.node().setLevel (0, 3e-5);
                                 });
    };
    const auto once = play (2400);
    CHECK (once.cwiseAbs().maxCoeff() > 0.1);

    for (const auto block : { 1, 48, 400, 800 })
        CHECK ((play (block) - once).isZero (0));
}

TEST_CASE ("A newer bank waits until the one before has faded in, and all come back", "[live][graph]")
{
    FilterGraph filters;
    const auto from = someInputs();
    auto given = 0;
    const auto played = playedBy<float> (
        filters.graph, from, 48,
        [&] (int) { filters.node().banks().give (randomBank (static_cast<std::uint64_t> (++given))); });
    CHECK (played.allFinite());
    CHECK (given == samples / 48);
    // No step: the largest from sample to sample is that of the tones.
    CHECK ((played.rightCols (samples - 1) - played.leftCols (samples - 1)).cwiseAbs().maxCoeff()
           < 0.2 * played.cwiseAbs().maxCoeff());
}

TEST_CASE ("An offset of the inputs is taken off within seconds", "[live][graph]")
{
    FilterGraph filters;
    filters.node().banks().give (randomBank (1));
    const Eigen::MatrixXd constant = Eigen::MatrixXd::Ones (inputs, 20 * samples);
    const auto played = playedBy<float> (filters.graph, constant, 480, [] (int) {});
    CHECK (played.leftCols (samples).cwiseAbs().maxCoeff() > 1);
    CHECK (played.rightCols (samples).cwiseAbs().maxCoeff() < 1e-3 * played.cwiseAbs().maxCoeff());
}

TEST_CASE ("Voltages that jump follow with the slew rate, those without one at once", "[graph]")
{
    NodeGraph graph;
    graph.add (std::make_unique<InputNode> (2), NodeGraph::noSource);
    graph.add (std::make_unique<SlewNode> (Eigen::Vector2d (10, 10), Eigen::Vector2d (4800, 0)), 0);
    graph.setOutputs ({ 1 });
    graph.prepare ({ rate, 64 });
    Eigen::MatrixXd jumps (2, 400);
    jumps.leftCols (200).setConstant (8);
    jumps.rightCols (200).setConstant (-1e6);
    const auto played = playedBy<double> (graph, jumps, 64, [] (int) {});

    for (Eigen::Index n = 0; n < 200; ++n)
    {
        CHECK (played (0, n) == Approx (std::min (8.0, 0.1 * static_cast<double> (n + 1))).margin (1e-9));
        CHECK (played (0, 200 + n) == Approx (std::max (-10.01, 8 - 0.1 * static_cast<double> (n + 1))).margin (1e-9));
    }

    CHECK (played (1, 0) == 8);
    CHECK (played (1, 200) == Approx (-10.01));
}
