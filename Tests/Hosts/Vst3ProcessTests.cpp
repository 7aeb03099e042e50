#include "Support/HostLoop.h"
#include "Vst3BareBlock.h"

#include <catch2/catch.hpp>
#include <juce_core/juce_core.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

// What Steinberg's validator asks of a VST3 while it plays, and what hosts do beyond that.

using namespace antinode::test;
using Steinberg::kResultTrue;

TEST_CASE ("A VST3 is suspended, resumed and set up again as often as a host likes", "[vst3]")
{
    RawVst3 plugin (GENERATE (2, 8, 16, 32, 64));

    for (int i = 0; i < 5; ++i)
        for (const auto block : { 1, 64, 8193 })
        {
            plugin.activate ({ i % 2 == 0 ? 44100.0 : 96000.0, block, true, i % 2 == 1 });
            plugin.component->setActive (true); // Twice the same says nothing.
            CHECK (plugin.play (2 * 1024, block, 0).topRows (2).cwiseAbs().maxCoeff() > 1e-3);
            plugin.processor->setProcessing (false);
            plugin.processor->setProcessing (true);
            CHECK (plugin.play (512, block, -1).allFinite());
            plugin.deactivate();
            plugin.deactivate();
        }
}

TEST_CASE ("Before it is active a VST3 is silent and does not crash", "[vst3]")
{
    RawVst3 plugin (8);
    BareBlock block (512, { 8, 2 });
    block.events.events.push_back (noteOn (0, 60));
    plugin.processor->process (block.data);
    CHECK (block.samples.leftCols (10).isZero (0));
}

TEST_CASE ("Buses other than those that were agreed get silence, or with JUCE 8 the channels that fit", "[vst3]")
{
    RawVst3 plugin (8), agreed (8);

    for (auto* const each : { &plugin, &agreed })
    {
        each->activate ({ 48000, 512, true, false });
        REQUIRE (each->isPlaying());
    }

    for (const auto& [ceramics, monitors] :
         { std::pair (12, 2), std::pair (4, 2), std::pair (8, 1), std::pair (8, 5), std::pair (64, 2) })
    {
        BareBlock block (512, { ceramics, monitors }), whole (512, { 8, 2 });

        for (auto* const each : { &block, &whole })
            each->events.events.push_back (noteOn (0, 60));

        plugin.processor->process (block.data);
        agreed.processor->process (whole.data);
        CAPTURE (ceramics, monitors);

        if (JUCE_MAJOR_VERSION >= 8 && ceramics <= 8 && monitors <= 2)
        {
            CHECK (block.samples.leftCols (ceramics) == whole.samples.leftCols (ceramics));
            CHECK (block.samples.middleCols (ceramics, monitors) == whole.samples.middleCols (8, monitors));
        }
        else
            CHECK (block.samples.leftCols (ceramics + monitors).isZero (0));
    }

    BareBlock mainOnly (512, { 8 });
    plugin.processor->process (mainOnly.data);
    CHECK (mainOnly.samples.allFinite());
    CHECK (plugin.isPlaying());
}

TEST_CASE ("Blocks longer than the host has announced are played in parts, the same samples", "[vst3]")
{
    const auto isDouble = GENERATE (false, true);
    RawVst3 plugin (GENERATE (2, 29, 64));
    constexpr int note = 1500, length = 8192;
    plugin.activate ({ 48000, length, true, isDouble });
    const Eigen::MatrixXd expected = plugin.play (length, length, note);
    REQUIRE (expected.topRows (2).cwiseAbs().maxCoeff() > 1e-3);
    plugin.deactivate();

    for (const auto announced : { 64, 1000, 0, -1 })
    {
        CAPTURE (announced);
        plugin.activate ({ 48000, announced, true, isDouble });
        CHECK (plugin.play (length, length, note) == expected);
        CHECK (plugin.processor->getTailSamples() > 0);
        plugin.deactivate();
    }
}

TEST_CASE ("Of a block that is played in parts no parameter and no event outside is lost", "[vst3]")
{
    RawVst3 plugin (8);
    const auto trim = plugin.parameter (u"Output trim");
    plugin.activate ({ 48000, 64, true, false });
    const auto playLate = [&] (int offset)
    {
        return plugin.play (2048, 2048,
                            [&] (Vst3Block& block)
                            {
                                block.events.events.push_back (noteOn (offset, 60));
                                block.changes.add (trim, 2000, 1);
                            });
    };
    const Eigen::MatrixXd first = playLate (-5);
    plugin.deactivate();
    plugin.activate ({ 48000, 64, true, false });
    CHECK (playLate (0) == first);
    CHECK (first.topRows (2).cwiseAbs().maxCoeff() > 1e-3);
    CHECK (plugin.state().find ("\"output_trim\":0.0") != std::string::npos);
    CHECK (playLate (9999).col (2047).allFinite());
    CHECK (plugin.play (1024, 1024, -1).topRows (2).cwiseAbs().maxCoeff() > 1e-3);

    BareBlock many (512, { 400, 400 });
    CHECK (plugin.processor->process (many.data) != kResultTrue);
    CHECK (plugin.isPlaying());
}

TEST_CASE ("All sound off and all notes off reach the parameter that stops all foci, at their sample", "[vst3]")
{
    const auto announced = GENERATE (64, 4096);
    RawVst3 plugin (8);
    void* found = nullptr;
    REQUIRE (plugin.controller->queryInterface (Vst::IMidiMapping::iid, &found) == Steinberg::kResultOk);
    auto* const mapping = static_cast<Vst::IMidiMapping*> (found);
    const auto stop = plugin.parameter (u"Stop");

    for (Steinberg::int16 channel = 0; channel < 16; ++channel)
        for (const auto controller : std::initializer_list<Vst::CtrlNumber> { 120, 123 })
        {
            Vst::ParamID assigned = 0;
            CHECK (mapping->getMidiControllerAssignment (0, channel, controller, assigned) == kResultTrue);
            CHECK (assigned == stop);
        }

    Vst::ParamID none = 0;
    CHECK (mapping->getMidiControllerAssignment (0, 0, 7, none) != kResultTrue);
    CHECK (mapping->getMidiControllerAssignment (1, 0, 123, none) != kResultTrue);
    mapping->release();

    plugin.activate ({ 48000, announced, true, false });
    constexpr int stopAt = 700, fade = 96;
    const auto playStopped = [&] (double value)
    {
        return plugin.play (4096, 4096,
                            [&] (Vst3Block& block)
                            {
                                block.events.events.push_back (noteOn (0, 60));
                                block.changes.add (stop, stopAt, value);
                            });
    };
    const Eigen::MatrixXd whole = plugin.play (4096, 4096, 0).topRows (8);

    for (const auto value : { 0.0, 1.0, 1.0, 0.0 })
    {
        const Eigen::MatrixXd stopped = playStopped (value).topRows (8);
        CHECK (stopped.leftCols (stopAt) == whole.leftCols (stopAt));
        CHECK (stopped.middleCols (stopAt, 32).cwiseAbs().maxCoeff() > 0);
        CHECK (stopped.rightCols (4096 - stopAt - fade - 1).isZero (0));
    }
}

TEST_CASE ("A controller that is set to what is no number keeps its value", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, true, false });
    const auto state = plugin.state();

    for (const auto& info : plugin.parameters())
    {
        const auto before = plugin.controller->getParamNormalized (info.id);

        for (const auto value : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity() })
        {
            plugin.controller->setParamNormalized (info.id, value);
            CHECK (plugin.controller->getParamNormalized (info.id) == before);
            BareBlock block (64, { 8, 2 });
            block.changes.add (info.id, 0, value);
            CHECK (plugin.processor->process (block.data) == kResultTrue);
            CHECK (block.samples.leftCols (10).allFinite());
        }
    }

    CHECK (plugin.state() == state);
}

TEST_CASE ("A VST3's tail is that of its parameters as soon as they are set", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, true, false });
    plugin.play (512, 512, -1);
    const auto before = plugin.processor->getTailSamples();
    CHECK (before > 1200); // The focus of the file, 25 ms, and what rings.
    const auto focusTime = plugin.parameter (u"Focus time");
    plugin.play (512, 512, [&] (Vst3Block& block) { block.changes.add (focusTime, 0, 1); });
    CHECK (plugin.processor->getTailSamples() >= before + 48 * 475); // 500 ms
}

TEST_CASE ("A block without samples or without buses takes parameters all the same", "[vst3]")
{
    RawVst3 plugin (8);
    const auto trim = plugin.parameter (u"Output trim");
    plugin.activate ({ 48000, 512, true, false });

    BareBlock bare (0, {}), unplugged (0, { 0, 0 });
    bare.changes.add (trim, 0, 0.25);
    bare.data.inputEvents = nullptr;
    CHECK (plugin.processor->process (bare.data) == kResultTrue);
    CHECK (plugin.state().find ("\"output_trim\":-45.0") != std::string::npos);

    unplugged.changes.add (trim, 0, 0.5);
    CHECK (plugin.processor->process (unplugged.data) == kResultTrue);
    CHECK (plugin.state().find ("\"output_trim\":-30.0") != std::string::npos);

    BareBlock empty (0, { 8, 2 });
    empty.events.events.push_back (noteOn (0, 60));
    CHECK (plugin.processor->process (empty.data) == kResultTrue);
    CHECK (plugin.play (1024, 512, -1).allFinite());
}

TEST_CASE ("A bus that a VST3 marks as silent is silent", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, true, false });

    for (int i = 0; i < 8; ++i)
    {
        BareBlock block (512, { 8, 2 });

        if (i == 3)
            block.events.events.push_back (noteOn (0, 60));

        REQUIRE (plugin.processor->process (block.data) == kResultTrue);
        int next = 0;

        for (const auto& bus : block.buses)
            for (int k = 0; k < bus.numChannels; ++k, ++next)
                CHECK ((((bus.silenceFlags >> k) & 1U) == 0 || block.samples.col (next).isZero (0)));
    }
}

TEST_CASE ("A state is read and set on another thread while blocks are played", "[vst3]")
{
    RawVst3 plugin (8), other (8);
    const auto first = plugin.state();
    other.controller->setParamNormalized (other.parameter (u"Focus x"), 0.3);
    const auto second = other.state();
    REQUIRE (first != second);
    plugin.activate ({ 48000, 512, false, false });
    std::atomic<bool> isDone { false };
    std::thread background (
        [&]
        {
            for (int i = 0; i < 50; ++i)
            {
                plugin.setState (i % 2 == 0 ? second : first);
                plugin.state();
                std::this_thread::sleep_for (std::chrono::milliseconds (2));
            }

            plugin.setState (second);
            isDone = true;
        });
    auto areFinite = true;

    while (! isDone)
        areFinite = areFinite && plugin.play (512, 512, 7).allFinite();

    background.join();
    CHECK (areFinite);
    CHECK ((plugin.state() == second));
}

TEST_CASE ("A change of latency reaches the host", "[vst3]")
{
    RawVst3 plugin (8);
    plugin.activate ({ 48000, 512, false, false });
    CHECK (plugin.processor->getLatencySamples() == 0);
    CHECK (plugin.processor->getTailSamples() > 1200);
    plugin.handler.restartFlags = 0;
    plugin.controller->setParamNormalized (plugin.parameter (u"Focus on the note"), 1);

    for (int i = 0; i < 6000 && (plugin.handler.restartFlags & Vst::kLatencyChanged) == 0; ++i)
        runHostLoop (std::chrono::milliseconds (10));

    CHECK ((plugin.handler.restartFlags & Vst::kLatencyChanged) != 0);
    CHECK (plugin.processor->getLatencySamples() == 1200);
}

TEST_CASE ("Views are made and freed while blocks are played", "[vst3]")
{
    RawVst3 plugin (8);
    CHECK (plugin.controller->createView ("nonsense") == nullptr);
    plugin.activate ({ 48000, 512, false, false });
    std::atomic<bool> isDone { false };
    std::thread audio (
        [&]
        {
            while (! isDone)
                plugin.play (512, 512, 7);
        });

    for (int i = 0; i < 5; ++i)
        if (auto* const view = plugin.controller->createView (Vst::ViewType::kEditor))
        {
            Steinberg::ViewRect size;
            CHECK (view->getSize (&size) == kResultTrue);
            CHECK (size.getWidth() > 0);
            CHECK (view->isPlatformTypeSupported (platformType) == kResultTrue);
            view->release();
        }

    isDone = true;
    audio.join();
}
