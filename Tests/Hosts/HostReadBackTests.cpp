#include "JuceHost.h"

#include <catch2/catch.hpp>

#include <random>

// What a host reads of a built plug-in's parameters is what it gets back.

using namespace antinode::test;

namespace
{
void scramble (juce::AudioPluginInstance& instance, std::mt19937& random)
{
    for (auto* const parameter : instance.getParameters())
        parameter->setValue (std::uniform_real_distribution<float> (0, 1) (random));
}
} // namespace

TEST_CASE ("What a host reads is what it gets back, to the bit", "[hosted]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    CAPTURE (pluginName (plugin));
    const auto first = hosted (plugin);
    first->prepareToPlay (48000, 64);
    std::unique_ptr<juce::AudioPluginInstance> second;
    std::mt19937 random (11);

    for (int i = 0; i < 1000; ++i)
    {
        scramble (*first, random);
        play (*first, plugin, 64, 64, -1); // Values reach the plug-in with a block.

        // JUCE's host for LV2 keeps what it has set: there, states are compared.
        if (i % 50 == 0 && plugin.kind == PluginKind::vst3)
            waitForSteps (*first, plugin);

        if (i % 50 == 0)
            second = hosted (plugin);

        const auto kept = savedState (*first);
        setState (*second, kept);
        REQUIRE ((innerState (plugin.kind, savedState (*second)) == innerState (plugin.kind, kept)));

        if (plugin.kind == PluginKind::vst3 && i % 50 == 0)
            for (int k = 0; k < first->getParameters().size(); ++k)
            {
                const auto& one = *first->getParameters()[k];
                INFO (one.getName (100));
                REQUIRE (one.getValue() == second->getParameters()[k]->getValue());
            }
    }
}
