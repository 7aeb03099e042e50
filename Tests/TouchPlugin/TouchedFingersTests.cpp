#include "PlayedTouch.h"

#include <Touch/TouchedFingers.h>

#include <catch2/catch.hpp>

#include <bit>
#include <chrono>
#include <limits>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr std::array<bool, mostFingers> allFree { true, true, true, true, true, true, true, true };
constexpr std::int64_t cursor = 70000; // A number as those of TUIO's cursors, beyond all fingers.

Touch resting (std::int64_t finger, double x = 0.5, double y = 0.5)
{
    return { TouchKind::rest, false, x, y, 1, finger };
}

Touch lifting (std::int64_t finger)
{
    return { TouchKind::lift, false, 0, 0, 1, finger };
}

using Kind = FingerMove::Kind;
using Moves = std::vector<FingerMove>;

FingerPresence presence (TouchProcessor& processor, std::size_t finger)
{
    return processor.parameters().settings().fingers[finger].presence;
}
} // namespace

TEST_CASE ("A touch takes the next free finger, moves it and lets it go", "[touch]")
{
    TouchedFingers fingers;
    auto isFree = allFree;
    isFree[0] = false;
    fingers.take (resting (cursor, 0.1, 0.2));
    fingers.take (resting (cursor + 1, 0.3, 0.4));
    CHECK (fingers.takeMoves (isFree) == Moves { { 1, Kind::down, 0.1, 0.2 }, { 2, Kind::down, 0.3, 0.4 } });
    CHECK (fingers.takeMoves (isFree).empty());
    fingers.take (resting (cursor, 0.1, 0.2));
    CHECK (fingers.takeMoves (isFree).empty()); // It has not moved.
    fingers.take (resting (cursor, 0.15, 0.2));
    fingers.take (resting (cursor, 0.2, 0.2));
    CHECK (fingers.takeMoves (isFree) == Moves { { 1, Kind::move, 0.2, 0.2 } });
    fingers.take (lifting (cursor));
    fingers.take (lifting (cursor + 9)); // Nobody knows it.
    CHECK (fingers.takeMoves (isFree) == Moves { { 1, Kind::lift, 0, 0 } });
    fingers.take (resting (cursor + 2, 0.5, 0.5));
    CHECK (fingers.takeMoves (isFree) == Moves { { 1, Kind::down, 0.5, 0.5 } });
    fingers.take ({ TouchKind::stopAll, false, 0, 0, 0 });
    CHECK (fingers.takeMoves (isFree) == Moves { { 2, Kind::lift, 0, 0 }, { 1, Kind::lift, 0, 0 } });
}

TEST_CASE ("A touch with the number of a finger is that finger", "[touch]")
{
    TouchedFingers fingers;
    fingers.take (resting (3));
    fingers.take (resting (cursor));
    CHECK (fingers.takeMoves ({}) == Moves { { 2, Kind::down, 0.5, 0.5 } }); // Also where it rests already.
    CHECK (fingers.waiting() == 1);

    // Not while another touch has it.
    std::array<bool, mostFingers> isFree {};
    isFree[6] = true;
    CHECK (fingers.takeMoves (isFree) == Moves { { 6, Kind::down, 0.5, 0.5 } });
    fingers.take (resting (7, 0.1, 0.1));
    CHECK (fingers.takeMoves (isFree).empty());
    fingers.take (lifting (cursor));
    CHECK (fingers.takeMoves (isFree) == Moves { { 6, Kind::lift, 0, 0 }, { 6, Kind::down, 0.1, 0.1 } });
}

TEST_CASE ("More touches than fingers wait in their order, and only so many", "[touch]")
{
    TouchedFingers fingers;

    for (int i = 0; i < 100; ++i)
        fingers.take (resting (cursor + i, 0.01 * i, 0));

    CHECK (fingers.takeMoves (allFree).size() == mostFingers);
    CHECK (fingers.resting() == mostFingers);
    CHECK (fingers.waiting() == TouchedFingers::mostTouches - mostFingers);
    CHECK (fingers.dropped() == 100 - TouchedFingers::mostTouches);
    fingers.take (lifting (cursor + 3));
    const auto moves = fingers.takeMoves ({});
    CHECK (moves == Moves { { 3, Kind::lift, 0, 0 }, { 3, Kind::down, 0.08, 0 } });
    fingers.liftAll();
    CHECK (fingers.takeMoves (allFree).size() == mostFingers);
    CHECK (fingers.resting() + fingers.waiting() == 0);
}

TEST_CASE ("Touches are fingers that play, absent ones are silent at once", "[touch]")
{
    const auto processor = offlineTouch (8, 48000, 256, {});
    auto& network = processor->network();
    const auto inputs = fingerTones (8, 9600, 48000);
    network.take (resting (cursor, 0.7, 0.6));
    network.apply();
    REQUIRE (presence (*processor, 1) == FingerPresence::plays);
    CHECK (processor->parameters().settings().fingers[1].xPercent == Approx (70));
    const Eigen::MatrixXd only = Eigen::VectorXd::Unit (8, 1) * inputs.row (1);
    CHECK (voltagesOf (*processor, only, 256).cwiseAbs().maxCoeff() > 1e-3);
    network.take (lifting (cursor));
    network.apply();
    CHECK (presence (*processor, 1) == FingerPresence::absent);
    voltagesOf (*processor, only.leftCols (8192), 256); // What was played rings out.
    CHECK (voltagesOf (*processor, only, 256).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE ("A kind of finger that touches are is what the surface then bears", "[touch]")
{
    const auto processor = offlineTouch (8, 48000, 256, {});
    processor->network().open ({ TouchPorts::anyFree, 0, "127.0.0.1", "medium" });
    processor->network().take (resting (2));
    processor->network().apply();
    CHECK (processor->parameters().settings().fingers[1].load == FingerLoad::medium);
    CHECK (processor->parameters().settings().fingers[0].load == FingerLoad::none);
}

TEST_CASE ("Packets of OSC put fingers down, and what is no place is counted and changes nothing", "[touch]")
{
    const auto processor = offlineTouch (8, 48000, 256, {});
    auto& network = processor->network();
    network.open ({ TouchPorts::anyFree, 0, "127.0.0.1" });
    juce::DatagramSocket sender;
    const auto send = [&] (int number, float x, float y)
    {
        std::string packet ("/antinode/finger\0\0\0\0,iff\0\0\0\0", 28);

        for (const auto word : { static_cast<std::uint32_t> (number), std::bit_cast<std::uint32_t> (x),
                                 std::bit_cast<std::uint32_t> (y) })
            for (int shift = 24; shift >= 0; shift -= 8)
                packet += static_cast<char> (word >> shift & 255);

        sender.write ("127.0.0.1", network.ports().oscPort, packet.data(), static_cast<int> (packet.size()));
    };
    const auto nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    send (2, 0.25F, 0.75F);
    send (3, nan, 0.5F);
    send (3, 0.5F, infinite);
    send (3, 1.01F, 0.5F);
    send (3, 0.5F, -0.01F);
    send (-1, 0.5F, 0.5F);

    for (int i = 0; i < 6000 && network.counters().packets < 6; ++i)
        std::this_thread::sleep_for (std::chrono::milliseconds (10));

    REQUIRE (network.counters().packets == 6);
    CHECK (network.counters().touches == 1);
    network.apply();
    CHECK (presence (*processor, 1) == FingerPresence::plays);
    CHECK (presence (*processor, 2) == FingerPresence::absent);
    CHECK (processor->parameters().settings().fingers[1].yPercent == Approx (75));
    network.open ({ 0, 0, "127.0.0.1" });
    network.apply();
    CHECK (presence (*processor, 1) == FingerPresence::absent); // Who cannot be heard any more does not rest.
}

TEST_CASE ("Touches that leap a thousand times a second leave voltages within their limits", "[touch]")
{
    constexpr int length = 24000, block = 48; // 1 ms
    auto processor = std::make_unique<TouchProcessor> (8, juce::AudioProcessor::wrapperType_Undefined);
    processor->parameters().setValues ({ { "gain", 20 } });
    processor->prepareToPlay (48000, block);
    processor->session().waitUntilSettled();
    const auto limit = voltageLimits (*processor->session().snapshot()->model).maxCoeff()
                       / processor->session().snapshot()->model->fullScaleVoltage;
    const auto inputs = fingerTones (8, length, 48000, 5);
    juce::Random random (3);
    auto largest = 0.0;
    auto isFinite = true;

    for (int begin = 0; begin < length; begin += block)
    {
        for (int touch = 0; touch < 12; ++touch)
            processor->network().take (random.nextInt (10) == 0
                                           ? lifting (cursor + touch)
                                           : resting (cursor + touch, random.nextDouble(), random.nextDouble()));

        processor->network().apply();
        const auto played = voltagesOf (*processor, inputs.middleCols (begin, block), block);
        isFinite = isFinite && played.allFinite();
        largest = std::max (largest, played.cwiseAbs().maxCoeff());
        std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }

    CHECK (isFinite);
    CHECK (largest <= limit * (1 + 1e-9));
    processor->network().take ({ TouchKind::stopAll, false, 0, 0, 0 });
    processor->network().apply();
    processor->session().waitUntilSettled();
    CHECK (processor->warning().isEmpty());
}

TEST_CASE ("States are kept without touches, and lift none where they come back", "[touch]")
{
    const auto processor = offlineTouch (8, 48000, 256, {}), other = offlineTouch (8, 48000, 256, {});
    processor->network().take (resting (cursor, 0.7, 0.6));
    processor->network().take (resting (1, 0.2, 0.2)); // It plays without touches, too.
    processor->network().apply();
    REQUIRE (presence (*processor, 1) == FingerPresence::plays);
    const auto state = processor->state();
    CHECK (state.parameters.at ("finger2_state") == 0);
    CHECK (state.parameters.at ("finger1_state") == 0); // A touch that leaves lifts its finger.
    other->setState (state, true);
    CHECK (presence (*other, 0) == FingerPresence::absent);
    CHECK (presence (*other, 1) == FingerPresence::absent);
    processor->setState (state, true);
    CHECK (presence (*processor, 1) == FingerPresence::plays);
    CHECK (processor->parameters().settings().fingers[1].xPercent == Approx (70));
    processor->network().take (lifting (cursor));
    CHECK (processor->state().parameters.at ("finger2_state") == 0);
    processor->network().apply();
    CHECK (presence (*processor, 1) == FingerPresence::absent);
    CHECK (presence (*processor, 0) == FingerPresence::plays);
}

TEST_CASE ("States keep the ports of touches, and say why one cannot be opened", "[touch]")
{
    TouchProcessor first (8, juce::AudioProcessor::wrapperType_Undefined);
    CHECK (first.state().parameters.count ("osc_port") == 0);
    juce::DatagramSocket probe;
    probe.setEnablePortReuse (false);
    REQUIRE (probe.bindToPort (0, "127.0.0.1"));
    const auto port = probe.getBoundPort();
    probe.shutdown();
    first.network().open ({ port, 0, "127.0.0.1" });
    CHECK (first.state().parameters.at ("osc_port") == port);
    CHECK (first.warning().isEmpty());
    TouchProcessor second (8, juce::AudioProcessor::wrapperType_Undefined);
    second.setState (first.state(), true);
    CHECK (second.warning()
           == "OSC port " + juce::String (port) + ": is in use by another program; allowed: a free port, or 0 for off");
    CHECK (second.network().ports().oscPort == 0);
    first.network().open ({ 0, 0, "127.0.0.1" });
    auto state = second.state();
    second.setState (state, true); // The same ports, which are free now.
    CHECK (second.warning().isEmpty());
    CHECK (second.network().ports().oscPort == port);
    state.parameters["osc_port"] = 1e9;
    second.setState (state, true);
    CHECK (second.warning().contains ("a port is 65536; allowed: 1 to 65535"));
    state.parameters.erase ("osc_port");
    second.setState (state, true);
    CHECK (second.warning().isEmpty());
}
