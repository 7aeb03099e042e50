#include "JuceHost.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

// What a host reads of a built plug-in's parameters is what it gets back.

using namespace antinode::test;

namespace juce
{
bool dispatchNextMessageOnSystemQueue (bool returnIfNoPendingMessages); // No header has it.
}

namespace
{
/** Whether the host reads a step of each parameter that has steps. */
bool readsSteps (const juce::AudioPluginInstance& instance)
{
    return std::all_of (instance.getParameters().begin(), instance.getParameters().end(),
                        [] (const auto* parameter)
                        {
                            const auto steps =
                                parameter->getValue() * static_cast<float> (parameter->getNumSteps() - 1);
                            return ! parameter->isDiscrete() || std::abs (steps - std::round (steps)) < 1e-3F;
                        });
}

/** Plays until the host has been told of all steps that its values became. */
void waitForSteps (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin)
{
    using Clock = std::chrono::steady_clock;

    for (const auto end = Clock::now() + std::chrono::seconds (10); ! readsSteps (instance);)
    {
        REQUIRE (Clock::now() < end);
        play (instance, plugin, 64, 64, -1);

        if (! juce::dispatchNextMessageOnSystemQueue (true))
            std::this_thread::sleep_for (std::chrono::milliseconds (1));
    }
}

void scramble (juce::AudioPluginInstance& instance, std::mt19937& random)
{
    for (auto* const parameter : instance.getParameters())
        parameter->setValue (std::uniform_real_distribution<float> (0, 1) (random));
}
} // namespace

TEST_CASE ("What a host reads is what it gets back, to the bit", "[hosted]")
{
    const auto plugin = GENERATE (BuiltPlugin { PluginKind::vst3, 8 }, BuiltPlugin { PluginKind::lv2, 8 });
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
