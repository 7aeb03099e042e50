#include "Support/JuceMessages.h"

#include <Hosts/JuceHost.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>

// What pluginval does with the editor, in JUCE's own hosting.

using namespace antinode::test;

namespace
{
using Clock = std::chrono::steady_clock;

double millisecondsSince (Clock::time_point start)
{
    return std::chrono::duration<double, std::milli> (Clock::now() - start).count();
}

void answerMessages (std::chrono::milliseconds time)
{
    const auto end = Clock::now() + time;

    while (Clock::now() < end)
        if (! answerNextMessage())
            std::this_thread::sleep_for (std::chrono::milliseconds (1));
}

/** A window with the editor in it, as in a host. */
std::unique_ptr<juce::DocumentWindow> makeWindow (juce::AudioPluginInstance& instance)
{
    auto window = std::make_unique<juce::DocumentWindow> ("Editor", juce::Colours::black, 0);
    window->setContentOwned (instance.createEditorIfNeeded(), true);
    window->setVisible (true);
    return window;
}

/** Plays and automates on a thread of its own while an instance lives. */
class Playing
{
public:
    Playing (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin)
        : thread ([this, &instance, plugin] { run (instance, plugin); })
    {
    }

    ~Playing()
    {
        isStopping = true;
        thread.join();
    }

    bool isFinite() const { return stayedFinite; }

private:
    void run (juce::AudioPluginInstance& instance, const BuiltPlugin& plugin)
    {
        std::mt19937 random (5);

        while (! isStopping)
        {
            for (auto* const parameter : instance.getParameters())
                parameter->setValue (static_cast<float> (random() % 1001) / 1000);

            if (! play (instance, plugin, 512, 512, 0, static_cast<int> (random() % 128)).allFinite())
                stayedFinite = false;

            std::this_thread::sleep_for (std::chrono::milliseconds (2));
        }
    }

    std::atomic<bool> isStopping { false }, stayedFinite { true };
    std::thread thread;
};
} // namespace

TEST_CASE ("Loading and opening in a JUCE host", "[hosted]")
{
    const BuiltPlugin plugin { PluginKind::vst3, 32 };

    for (int i = 0; i < 4; ++i)
    {
        const auto start = Clock::now();
        const auto instance = hosted (plugin);
        const auto loaded = millisecondsSince (start);
        std::printf ("VST3 in a JUCE host, %s: loaded in %.1f ms", i == 0 ? "first" : "later", loaded);

        for (int k = 0; k < 2; ++k)
        {
            const auto opening = Clock::now();
            const auto window = makeWindow (*instance);
            std::printf (", opened in %.1f ms", millisecondsSince (opening));
            REQUIRE (window->getContentComponent() != nullptr);
            CHECK (window->getContentComponent()->getWidth() == 1280);
            CHECK (window->getContentComponent()->getHeight() == 800);
            answerMessages (std::chrono::milliseconds (100));
        }

        std::puts ("");
    }
}

TEST_CASE ("The editor opens and closes in a JUCE host while all parameters are automated", "[hosted]")
{
    const BuiltPlugin plugin { PluginKind::vst3, 8 };
    const auto instance = hosted (plugin);
    instance->prepareToPlay (48000, 512);
    const Playing playing (*instance, plugin);

    for (int i = 0; i < 10; ++i)
    {
        const auto window = makeWindow (*instance);
        window->setSize (700 + 100 * i, 500 + 50 * i);
        answerMessages (std::chrono::milliseconds (20 * (i % 3)));
    }

    CHECK (playing.isFinite());
}

TEST_CASE ("States are set on another thread while the editor is open", "[hosted]")
{
    const BuiltPlugin plugin { PluginKind::vst3, 8 };
    const auto instance = hosted (plugin);
    instance->prepareToPlay (48000, 512);
    const auto state = savedState (*instance);
    const auto window = makeWindow (*instance);
    const Playing playing (*instance, plugin);
    runInBackground (
        [&]
        {
            for (int i = 0; i < 20; ++i)
            {
                setState (*instance, state);
                std::this_thread::sleep_for (std::chrono::milliseconds (5));
            }
        });
    CHECK (playing.isFinite());
}

TEST_CASE ("Without a display a JUCE host gets an editor that does no harm", "[hosted][no-display]")
{
    const BuiltPlugin plugin { PluginKind::vst3, 8 };
    const auto instance = hosted (plugin);
    instance->prepareToPlay (48000, 512);
    const Playing playing (*instance, plugin);

    for (int i = 0; i < 10; ++i)
    {
        const std::unique_ptr<juce::AudioProcessorEditor> editor (instance->createEditorIfNeeded());
        answerMessages (std::chrono::milliseconds (5));
    }

    CHECK (playing.isFinite());
}
