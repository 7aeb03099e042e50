#include "HostReference.h"
#include "JuceHost.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <random>
#include <stdexcept>
#include <thread>

// What pluginval asks of both formats, beside what they play.

using namespace antinode::test;

namespace
{
constexpr double stateRate = 48000;
constexpr double loudest = 1 + 1e-6; // of a ceramic: full scale is the device's limit

juce::AudioProcessorParameter& findParameter (juce::AudioPluginInstance& instance, const juce::String& name)
{
    for (auto* const parameter : instance.getParameters())
        if (parameter->getName (64) == name)
            return *parameter;

    throw std::runtime_error ("there is no such parameter");
}

void automate (juce::AudioPluginInstance& instance, std::mt19937& random)
{
    for (auto* const parameter : instance.getParameters())
        parameter->setValue (static_cast<float> (random() % 1001) / 1000);
}
} // namespace

TEST_CASE ("A state comes back to the bit in another instance of any number of channels", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPlugins()));
    CAPTURE (pluginName (plugin));
    const auto first = hostedOffline (plugin), second = hostedOffline (plugin);
    std::mt19937 random (3);

    for (int i = 0; i < 5; ++i)
    {
        automate (*first, random);
        automate (*second, random);
        play (*first, plugin, 512, 512, -1); // Values reach the plug-in with a block.
        play (*second, plugin, 512, 512, -1);
        const auto kept = savedState (*first);

        // JUCE's host for LV2 keeps what it has set, and is told of nothing.
        if (plugin.kind == PluginKind::vst3)
            waitForSteps (*second, plugin);

        setState (*second, kept);
        REQUIRE ((innerState (plugin.kind, savedState (*second)) == innerState (plugin.kind, kept)));
        play (*second, plugin, 512, 512, -1);
        REQUIRE ((innerState (plugin.kind, savedState (*second)) == innerState (plugin.kind, kept)));
    }
}

TEST_CASE ("What a state plays is what it was kept from", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    const auto first = hostedOffline (plugin), second = hostedOffline (plugin);
    findParameter (*first, "Focus x").setValue (0.27F);
    play (*first, plugin, 512, 512, -1);
    first->prepareToPlay (stateRate, 512);
    setState (*second, savedState (*first));
    second->prepareToPlay (stateRate, 512);
    const auto one = play (*first, plugin, 4096, 512, 0), other = play (*second, plugin, 4096, 512, 0);
    CHECK (one.topRows (8).cwiseAbs().maxCoeff() > 0.01);
    CHECK ((one - other).isZero (0));
}

TEST_CASE ("States are kept and set on another thread while blocks are played", "[hosted]")
{
    const auto plugin = GENERATE (BuiltPlugin { PluginKind::vst3, 8 }, BuiltPlugin { PluginKind::vst3, 64 },
                                  BuiltPlugin (builtPair().back()));
    CAPTURE (pluginName (plugin));
    const auto instance = hosted (plugin), other = hostedOffline (plugin);
    findParameter (*other, "Focus x").setValue (0.27F);
    play (*other, plugin, 512, 512, -1);
    const auto first = savedState (*instance), second = savedState (*other);
    REQUIRE ((innerState (plugin.kind, first) != innerState (plugin.kind, second)));
    instance->prepareToPlay (stateRate, 512);
    std::atomic<bool> isDone { false }, areFinite { true };
    std::thread audio (
        [&]
        {
            while (! isDone)
                if (! play (*instance, plugin, 512, 512, 5).allFinite())
                    areFinite = false;
        });
    runInBackground (
        [&]
        {
            for (int i = 0; i < 20; ++i)
            {
                setState (*instance, i % 2 == 0 ? second : first);
                savedState (*instance);
            }

            setState (*instance, second);
        });
    isDone = true;
    audio.join();
    CHECK (areFinite);
    CHECK ((innerState (plugin.kind, savedState (*instance)) == innerState (plugin.kind, second)));
}

TEST_CASE ("Whatever a host automates in each block, voltages stay finite and within full scale", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPlugins()));
    const auto isOffline = plugin.ceramics == 8;
    CAPTURE (pluginName (plugin));
    const auto instance = hosted (plugin, stateRate, 1024);
    instance->setNonRealtime (isOffline);
    instance->prepareToPlay (stateRate, 1024);
    std::mt19937 random (23);
    const auto played = play (*instance, plugin, isOffline ? 16 * 1024 : 200 * 1024, 1024,
                              [&] (int start, juce::MidiBuffer& midi)
                              {
                                  automate (*instance, random);

                                  if (start % 4096 == 0)
                                      for (int i = 0; i < 8; ++i)
                                          midi.addEvent (juce::MidiMessage (static_cast<int> (0x80 + random() % 0x70),
                                                                            static_cast<int> (random() % 128),
                                                                            static_cast<int> (random() % 128)),
                                                         static_cast<int> (random() % 1024));
                              });
    CHECK (played.allFinite());
    CHECK (played.topRows (plugin.ceramics).cwiseAbs().maxCoeff() <= loudest);
}

TEST_CASE ("Parameters have names, texts both ways, and the numbers of values that they say", "[hosted]")
{
    const BuiltPlugin plugin { PluginKind::vst3, 8 };
    const auto instance = hosted (plugin);
    REQUIRE (instance->getParameters().size() > 15);
    // Places are in percent until the device is solved, then in millimetres.
    waitForSteps (*instance, plugin);

    for (auto* const parameter : instance->getParameters())
    {
        INFO (parameter->getName (64));
        CHECK (parameter->getName (64).isNotEmpty());
        CHECK (parameter->isAutomatable() == (parameter->getName (64) != "Arm" && parameter->getName (64) != "Stop"));
        CHECK (parameter->getDefaultValue() >= 0);
        CHECK (parameter->getDefaultValue() <= 1);

        for (const auto value : { 0.0F, 0.25F, 0.5F, 0.75F, 1.0F })
        {
            const auto text = parameter->getText (value, 64);
            CHECK (text.isNotEmpty());
            CHECK (parameter->getText (parameter->getValueForText (text), 64) == text);
        }

        parameter->setValue (0.5F);
        CHECK (parameter->getValue() == 0.5F);
    }
}

TEST_CASE ("The same parameters are there in both formats", "[hosted]")
{
    const auto vst3 = hosted (builtPair().front()), lv2 = hosted (builtPair().back());
    juce::StringArray ofLv2;

    for (auto* const parameter : lv2->getParameters())
        ofLv2.add (parameter->getName (64));

    for (auto* const parameter : vst3->getParameters())
    {
        INFO (parameter->getName (64));
        // LV2 brings controllers as they are.
        CHECK ((ofLv2.contains (parameter->getName (64)) || parameter->getName (64) == "Stop"));
    }
}

TEST_CASE ("Blocks before prepare, after release, and of no samples do no harm", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPlugins()));
    CAPTURE (pluginName (plugin));
    const auto instance = hosted (plugin);
    CHECK (play (*instance, plugin, 512, 512, 0).allFinite());
    instance->prepareToPlay (stateRate, 512);
    juce::AudioBuffer<float> empty (instance->getTotalNumOutputChannels(), 0);
    juce::MidiBuffer midi;
    instance->processBlock (empty, midi);
    CHECK (play (*instance, plugin, 512, 512, 0).allFinite());
    instance->releaseResources();
    CHECK (play (*instance, plugin, 512, 512, 0).allFinite());
    instance->prepareToPlay (stateRate, 512);
    instance->reset();
    CHECK (play (*instance, plugin, 512, 512, 0).allFinite());
}

TEST_CASE ("A plug-in in a buffer of more channels than agreed plays in those that are its own", "[hosted]")
{
    const auto reference = demonstratorReference (stateRate, 1600);
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    const auto instance = hostedOffline (plugin, stateRate, 1600);
    juce::AudioBuffer<float> buffer (80, 1600);
    buffer.clear();
    juce::MidiBuffer midi;
    midi.addEvent (juce::MidiMessage::noteOn (1, 60, juce::uint8 (127)), 0);
    instance->processBlock (buffer, midi);
    double error = 0;

    for (int i = 0; i < 8; ++i)
        for (int n = 0; n < 1600; ++n)
            error =
                std::max (error, std::abs (static_cast<double> (buffer.getSample (i, n)) - reference.ceramics (i, n)));

    CHECK (error < wireTolerance);
}
