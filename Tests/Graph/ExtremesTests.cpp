#include <Support/SineBeam.h>

#include <antinode_focus/DesignFocus.h>
#include <antinode_graph/InstrumentGraph.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
constexpr int ceramics = 6, longestBlock = 512;

/** The standard graph with one focus in its bank. */
struct Played
{
    double rate;
    std::shared_ptr<const ModalModel> model;
    InstrumentGraph standard;

    Played (double rateToUse, double qualityFactor)
        : rate (rateToUse), model (std::make_shared<const ModalModel> (test::sineBeam (10, ceramics, qualityFactor)))
    {
        const Playback playback { Reconstruction::bandLimited, rate };
        FocusDescription focus;
        focus.targets = { Target {} };
        focus.targets[0].width = 0.05;
        focus.targets[0].peakVelocity = 0.02;
        focus.focusTime = 0.02;
        focus.modes.count = 3; // up to 1039 Hz, and 8 kHz can play them
        auto bank = std::make_unique<FocusBank>();
        bank->foci[0] = std::make_shared<const PlayableFocus> (designFocus (*model, focus, playback).program, playback);
        InstrumentNodes nodes;
        nodes.probeShapes = shapesAt (*model, 0.03, 0);
        standard = instrumentGraph (model, std::move (nodes));
        standard.graph.prepare ({ rate, longestBlock });
        standard.voiceNode().voices().handOver().give (std::move (bank));
    }

    /** The next samples, ceramics then the probe: (ceramics + 1) x count. */
    Eigen::MatrixXd next (int count, bool isTriggered)
    {
        Eigen::MatrixXd block (std::max (1, count), ceramics + 1);
        std::vector<double*> channels;

        for (int i = 0; i <= ceramics; ++i)
            channels.push_back (block.col (i).data());

        const FocusEvent event { 0, FocusEventKind::trigger, 0, 1 };
        standard.graph.process (channels.data(), count, std::span (&event, isTriggered ? 1U : 0U));
        return block.topRows (count).transpose();
    }

    Eigen::MatrixXd inBlocks (const std::vector<int>& blocks, Eigen::Index length)
    {
        Eigen::MatrixXd result (ceramics + 1, length);
        Eigen::Index at = 0;

        for (std::size_t i = 0; at < length; ++i)
        {
            const auto count = static_cast<int> (std::min<Eigen::Index> (blocks[i % blocks.size()], length - at));
            result.middleCols (at, count) = next (count, i == 0);
            at += count;
        }

        return result;
    }
};

void checkBlocks (double rate)
{
    const auto length = static_cast<Eigen::Index> (0.025 * rate) + 100;
    const auto whole = Played (rate, 60).inBlocks ({ 8193 }, length);
    CAPTURE (rate);
    CHECK (whole.allFinite());
    CHECK (whole.cwiseAbs().maxCoeff() > 0);
    // The trigger comes with an empty block, and is not lost.
    CHECK (Played (rate, 60).inBlocks ({ 0, 1, 0, 0, 31, 8193, 512, 513 }, length) == whole);
    CHECK (Played (rate, 60).inBlocks ({ 33, 0, 7 }, length) == whole);
}
} // namespace

TEST_CASE ("The graph takes blocks of 0 to 8193 samples from 8 kHz to 768 kHz", "[graph]")
{
    for (const auto rate : { 8e3, 44.1e3, 48e3, 96e3, 192e3, 384e3, 768e3 })
        checkBlocks (rate);
}

TEST_CASE ("A graph that is left alone becomes exactly still, and no number on the way is denormal", "[graph]")
{
    Played played (8e3, 5);
    auto block = played.next (longestBlock, true);
    auto largest = block.cwiseAbs().maxCoeff();
    int blocks = 0, denormal = 0;

    for (; largest > 0 && blocks < 2000; ++blocks)
    {
        block = played.next (longestBlock, false);
        largest = block.cwiseAbs().maxCoeff();

        for (const auto value : block.reshaped())
            denormal += std::fpclassify (value) == FP_SUBNORMAL ? 1 : 0;
    }

    CHECK (largest == 0);
    CHECK (blocks > 5);
    CHECK (denormal == 0);
}
