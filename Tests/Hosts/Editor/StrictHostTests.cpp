#include "Support/JuceMessages.h"

#include <Hosts/JuceHost.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <random>
#include <thread>
#include <vector>

// What a strict plug-in tester does, in JUCE's own hosting, in a random order and again.

using namespace antinode::test;

namespace
{
using Clock = std::chrono::steady_clock;

constexpr int largestBlock = 512;

/** A plug-in under test. Its own thread is the message thread. */
class StrictHost
{
public:
    StrictHost (const BuiltPlugin& pluginToTest, unsigned seed)
        : plugin (pluginToTest), random (seed), instance (hosted (plugin, 48000, largestBlock))
    {
        instance->prepareToPlay (48000, largestBlock);
        initial = savedState (*instance);
    }

    void automateEditor (int times)
    {
        const Playing playing (*this, largestBlock);

        for (int i = 0; i < times; ++i)
        {
            const auto window = open();
            answerMessages (i % 10 == 0 ? 30 : 0);
            answerAll();
        }
    }

    void restoreInBackground()
    {
        const Playing playing (*this, largestBlock);
        runInBackground (
            [&]
            {
                for (int i = 0; i < 20; ++i)
                {
                    scramble (random);
                    setState (*instance, initial);
                    savedState (*instance);
                }
            });
    }

    void setFromEightThreads()
    {
        const Playing playing (*this, largestBlock);
        std::atomic<int> running { 8 };
        std::vector<std::thread> threads;

        for (unsigned seed = 0; seed < 8; ++seed)
            threads.emplace_back (
                [this, seed, &running]
                {
                    std::mt19937 own (seed);

                    for (int i = 0; i < 100; ++i)
                        scramble (own);

                    --running;
                });

        while (running > 0)
            answerMessages (1);

        for (auto& thread : threads)
            thread.join();
    }

    /** Blocks longer than those that were prepared are handed to the processor itself in the tests of the processor:
       the buffers of JUCE's wrappers, on both sides, do not take them. JUCE's host for LV2 lays its own where it makes
       an instance, and copies inputs into them whatever is prepared later. */
    void changeBlockSizes()
    {
        const auto longest = plugin.kind == PluginKind::lv2 ? largestBlock : 4 * largestBlock;

        for (const auto block : { longest, 1, 64, largestBlock })
        {
            instance->releaseResources();
            instance->prepareToPlay (48000, block);
            const Playing playing (*this, block);
            answerMessages (20);
        }
    }

    void changeBuses()
    {
        const auto layout = instance->getBusesLayout();

        for (int i = 0; i < 4; ++i)
        {
            instance->releaseResources();
            auto other = layout;

            if (other.outputBuses.size() > 1 && i % 2 == 0)
                other.outputBuses.getReference (1) = juce::AudioChannelSet::disabled();

            instance->setBusesLayout (other);
            instance->prepareToPlay (i % 2 == 0 ? 44100 : 96000, largestBlock);
            const Playing playing (*this, largestBlock);
            answerMessages (10);
        }

        instance->releaseResources();
        instance->setBusesLayout (layout);
        instance->prepareToPlay (48000, largestBlock);
    }

    void replace()
    {
        instance = hosted (plugin, 48000, largestBlock);
        instance->prepareToPlay (48000, largestBlock);
    }

    bool isFinite() const { return stayedFinite; }

    /** How many editors were opened. */
    int editors() const { return opened; }

private:
    /** Plays and automates on a thread of its own while it lives. */
    class Playing
    {
    public:
        Playing (StrictHost& hostToUse, int block) : host (hostToUse), thread ([this, block] { run (block); }) {}

        ~Playing()
        {
            isStopping = true;
            thread.join();
        }

    private:
        void run (int block)
        {
            std::mt19937 own (5);

            do
            {
                host.scramble (own);
                const auto note = static_cast<int> (own() % 128);

                if (! play (*host.instance, host.plugin, block, block, 0, note).allFinite())
                    host.stayedFinite = false;

                std::this_thread::sleep_for (std::chrono::milliseconds (2));
            } while (! isStopping);
        }

        StrictHost& host;
        std::atomic<bool> isStopping { false };
        std::thread thread;
    };

    std::unique_ptr<juce::DocumentWindow> open()
    {
        auto window = std::make_unique<juce::DocumentWindow> ("Editor", juce::Colours::black, 0);
        window->setContentOwned (instance->createEditorIfNeeded(), true);
        window->setVisible (true);
        ++opened;
        return window;
    }

    void scramble (std::mt19937& numbers)
    {
        for (auto* const parameter : instance->getParameters())
            parameter->setValue (std::uniform_real_distribution<float> (0, 1) (numbers));
    }

    /** JUCE's host for LV2 answers a window that its plug-in resized by a message of its own, which still comes when
       the window is gone (XEmbedComponent of JUCE 7.0.5, ConfigureNotify). */
    static void answerAll()
    {
        while (answerNextMessage())
        {
        }
    }

    static void answerMessages (int milliseconds)
    {
        const auto end = Clock::now() + std::chrono::milliseconds (milliseconds);

        do
        {
            if (! answerNextMessage())
                std::this_thread::sleep_for (std::chrono::milliseconds (1));
        } while (Clock::now() < end);
    }

    BuiltPlugin plugin;
    std::mt19937 random;
    std::unique_ptr<juce::AudioPluginInstance> instance;
    juce::MemoryBlock initial;
    std::atomic<bool> stayedFinite { true };
    int opened = 0;
};
} // namespace

TEST_CASE ("Plug-ins stand what a strict tester does, in any order and again", "[hosted][strict]")
{
    const auto plugin = GENERATE (from_range (builtPair()));
    const auto start = Clock::now();
    StrictHost host (plugin, 17);
    std::vector<std::function<void()>> steps { [&] { host.automateEditor (50); },   [&] { host.restoreInBackground(); },
                                               [&] { host.setFromEightThreads(); }, [&] { host.changeBlockSizes(); },
                                               [&] { host.changeBuses(); },         [&] { host.replace(); } };
    std::mt19937 order (23);

    for (int round = 0; round < 2; ++round)
    {
        std::shuffle (steps.begin(), steps.end(), order);

        for (const auto& step : steps)
            step();
    }

    CHECK (host.isFinite());
    CHECK (host.editors() == 100);
    std::printf ("%s: two rounds in %.1f s\n", pluginName (plugin).c_str(),
                 std::chrono::duration<double> (Clock::now() - start).count());
}
