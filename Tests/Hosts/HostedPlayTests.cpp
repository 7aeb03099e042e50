#include "HostReference.h"
#include "JuceHost.h"
#include "Support/AllocationCount.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <thread>

// What both formats play in a host of JUCE's, which pluginval is too.

using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int length = 1600, noteAt = 100;

/** A prepared instance that plays the comb. */
std::unique_ptr<juce::AudioPluginInstance> combIn (const BuiltPlugin& plugin, const HostReference& reference, int block)
{
    auto instance = hostedOffline (plugin, rate, block);
    setState (*instance, hostState (plugin.kind, savedState (*instance), reference.state));
    instance->prepareToPlay (rate, block);
    return instance;
}
} // namespace

TEST_CASE ("Channel k of a hosted plug-in is ceramic k, the last two are the probes", "[hosted]")
{
    const auto& reference = combReference (rate, length);
    const auto plugin = GENERATE (from_range (builtPlugins()));
    CAPTURE (pluginName (plugin));
    const auto instance = combIn (plugin, reference, 256);
    REQUIRE (instance->getTotalNumOutputChannels() == plugin.ceramics + 2);
    const auto played = play (*instance, plugin, length, 256, noteAt);
    CHECK (deviation (played, plugin.ceramics, reference, noteAt) < wireTolerance);
}

TEST_CASE ("A hosted VST3 plays every layout of 1 to 64 channels with and without its monitor", "[hosted]")
{
    const auto& reference = combReference (rate, length);

    for (int ceramics = 1; ceramics <= 64; ceramics += 1 + ceramics / 8)
    {
        const BuiltPlugin plugin { PluginKind::vst3, ceramics };
        CAPTURE (ceramics);
        const auto instance = combIn (plugin, reference, 512);
        instance->releaseResources();
        const auto hasMonitor = ceramics % 2 == 0;
        CHECK (instance->getBus (false, 1)->enable (hasMonitor));
        instance->prepareToPlay (rate, 512);
        const auto played = play (*instance, plugin, length, 512, noteAt);
        REQUIRE (played.rows() == ceramics + (hasMonitor ? 2 : 0));
        REQUIRE (deviation (played, ceramics, reference, noteAt) < wireTolerance);
    }
}

TEST_CASE ("Blocks of any length give the same, in float and in double", "[hosted]")
{
    const auto& reference = combReference (rate, length);
    const auto plugin = GENERATE (from_range (builtPlugins()));
    CAPTURE (pluginName (plugin));
    const auto instance = combIn (plugin, reference, 8193);

    for (const auto block : { 1, 3, 64, 511, 512, 1024, 8193 })
    {
        CAPTURE (block);
        instance->releaseResources();
        instance->setProcessingPrecision (plugin.kind == PluginKind::vst3 && block % 2 == 1
                                              ? juce::AudioProcessor::doublePrecision
                                              : juce::AudioProcessor::singlePrecision);
        instance->prepareToPlay (rate, 8193);
        REQUIRE (deviation (play (*instance, plugin, length, block, noteAt), plugin.ceramics, reference, noteAt)
                 < wireTolerance);
    }
}

TEST_CASE ("The rate of a hosted plug-in may change on the fly", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    const auto instance = hostedOffline (plugin);
    CAPTURE (pluginName (plugin));

    for (const auto other : { 24000.0, 44100.0, 96000.0, 192000.0, 768000.0, 48000.0 })
    {
        CAPTURE (other);
        const auto samples = static_cast<int> (other * 0.03);
        instance->releaseResources();
        instance->prepareToPlay (other, 480);
        REQUIRE (deviation (play (*instance, plugin, samples, 480, 0), plugin.ceramics,
                            demonstratorReference (other, samples), 0)
                 < wireTolerance);
    }
}

TEST_CASE ("A hosted plug-in is prepared and released as often as a host likes, and plays in real time then",
           "[hosted]")
{
    const auto& reference = demonstratorReference (rate, length);
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    const auto instance = hosted (plugin);
    for (int i = 0; i < 10; ++i)
    {
        instance->prepareToPlay (i % 2 == 0 ? 44100.0 : rate, 64 << (i % 3));
        CHECK (play (*instance, plugin, 256, 64, 0).allFinite());
        instance->releaseResources();
    }

    instance->prepareToPlay (rate, 512);
    auto error = 1.0;

    // Foci are designed in the background meanwhile: 30 s are far more than that takes on any machine. A host of JUCE's
    // makes an LV2 anew whenever it prepares it.
    for (int attempt = 0; attempt < 600 && error >= wireTolerance; ++attempt)
    {
        std::this_thread::sleep_for (std::chrono::milliseconds (50));
        const Eigen::MatrixXd played = play (*instance, plugin, length, 512, noteAt).topRows (8);
        error = deviation (played, 8, reference, noteAt);
    }

    CHECK (error < wireTolerance);
}

TEST_CASE ("Twenty hosted instances play beside each other", "[hosted]")
{
    const auto& reference = demonstratorReference (rate, length);
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    std::vector<std::unique_ptr<juce::AudioPluginInstance>> all;

    for (int i = 0; i < 20; ++i)
        all.push_back (hostedOffline (plugin, rate, 512));

    for (const auto& instance : all)
        CHECK (deviation (play (*instance, plugin, length, 512, noteAt), plugin.ceramics, reference, noteAt)
               < wireTolerance);
}

TEST_CASE ("A hosted plug-in that is bypassed gives 0 V, and plays on afterwards", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    const auto instance = hostedOffline (plugin);
    auto* const bypass = instance->getBypassParameter();
    REQUIRE (bypass != nullptr);
    CHECK (play (*instance, plugin, 4096, 512, 0).topRows (8).cwiseAbs().maxCoeff() > 0.05);
    bypass->setValue (1);
    play (*instance, plugin, 1024, 512, -1); // It ramps.
    CHECK (play (*instance, plugin, 4096, 512, 0).topRows (8).isZero (0));
    bypass->setValue (0);
    play (*instance, plugin, 1024, 512, -1);
    CHECK (play (*instance, plugin, 4096, 512, 0).topRows (8).cwiseAbs().maxCoeff() > 0.05);
}

TEST_CASE ("All sound off and all notes off fade out what plays, in every format", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    const auto controller = GENERATE (120, 123);
    CAPTURE (pluginName (plugin), controller);
    const auto instance = hostedOffline (plugin);
    const auto whole = play (*instance, plugin, 4096, 512, 0);
    CHECK (whole.topRows (8).rightCols (4096 - 1024).cwiseAbs().maxCoeff() > 0.01);
    const auto stopped = play (*instance, plugin, 4096, 512,
                               [&] (int start, juce::MidiBuffer& midi)
                               {
                                   if (start == 0)
                                       midi.addEvent (juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)), 0);

                                   if (start == 512)
                                       midi.addEvent (juce::MidiMessage::controllerEvent (1, controller, 0), 0);
                               });
    CHECK (stopped.topRows (8).leftCols (512) == whole.topRows (8).leftCols (512));
    CHECK (stopped.topRows (8).rightCols (4096 - 1024).isZero (0));
}

TEST_CASE ("Making a hosted instance takes so long", "[hosted]")
{
    for (const auto& plugin : builtPair())
        for (const auto* const which : { "first", "second" })
        {
            const auto start = std::chrono::steady_clock::now();
            const auto instance = hosted (plugin);
            const auto taken = std::chrono::steady_clock::now() - start;
            std::printf ("%s, %s instance: %.1f ms\n", pluginName (plugin).c_str(), which,
                         std::chrono::duration<double, std::milli> (taken).count());
            CHECK (instance->getTotalNumOutputChannels() == plugin.ceramics + 2);
        }
}

TEST_CASE ("An LV2 asks for no memory while it plays", "[hosted]")
{
    const auto plugin = builtPair().back();
    CAPTURE (pluginName (plugin));
    const auto instance = hosted (plugin, rate, 128);
    instance->prepareToPlay (rate, 128);
    juce::AudioBuffer<float> buffer (instance->getTotalNumOutputChannels(), 128);
    auto isHeard = false;
    long allocations = 0;

    runInBackground (
        [&]
        {
            for (int i = 0; i < 1000 || ! isHeard; ++i) // A busy machine designs late.
            {
                juce::MidiBuffer midi;
                midi.addEvent (juce::MidiMessage::noteOn (1, 60 + i % 12, juce::uint8 (127)), i % 128);
                const auto before = mallocCalls();
                instance->processBlock (buffer, midi);
                allocations += i < 500 ? 0 : mallocCalls() - before; // At first the queues to the host grow.
                isHeard = isHeard || buffer.getMagnitude (0, 128) > 1e-3F;
                std::this_thread::sleep_for (std::chrono::microseconds (300)); // Time for designs, and for the host.
            }
        });
    CHECK (isHeard);
    CHECK (allocations == 0);
}
