#include <Plugin/AntinodeProcessor.h>
#include <Support/AudioThreadGuards.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double rate = 48000;
constexpr int longestBlock = 512, ceramics = 64;

struct Findings
{
    std::int64_t blocks = 0, allocations = 0, locks = 0;
    bool areFinite = true, isHeard = false;
};

/** Plays blocks of random lengths with random notes, as fast as it goes. */
template <typename Sample>
void playSome (AntinodeProcessor& processor, int blocks, std::mt19937& random, Findings& findings)
{
    juce::AudioBuffer<Sample> buffer (processor.getTotalNumOutputChannels(), longestBlock);
    juce::MidiBuffer midi;

    for (int i = 0; i < blocks; ++i, ++findings.blocks)
    {
        const auto count = static_cast<int> (1 + random() % longestBlock);
        buffer.setSize (buffer.getNumChannels(), count, false, false, true);
        midi.clear();

        for (int k = 0; k < 4; ++k)
            midi.addEvent (juce::MidiMessage::noteOn (1, static_cast<int> (random() % 128), juce::uint8 (100)),
                           static_cast<int> (random()) % count);

        const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
        {
            const SyscallTrap trap;
            const RealtimeScope realtime;
            processor.processBlock (buffer, midi);
        }
        findings.allocations += mallocCalls() - memoryBefore;
        findings.locks += lockCalls() - locksBefore;
        const auto level = buffer.getMagnitude (0, count);
        findings.areFinite = findings.areFinite && std::isfinite (level);
        findings.isHeard = findings.isHeard || level > Sample (1e-3);
    }
}

void playAll (AntinodeProcessor& processor, double seconds, Findings& findings)
{
    std::mt19937 random (7);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double> (seconds);

    while (std::chrono::steady_clock::now() < end)
    {
        playSome<float> (processor, 50, random, findings);
        playSome<double> (processor, 50, random, findings);
    }
}

/** Moves parameters, and so asks for designs and for paths, while the other thread plays. */
void disturb (AntinodeProcessor& processor, const std::atomic<bool>& isPlaying)
{
    std::mt19937 random (9);

    for (int i = 0; isPlaying; ++i)
    {
        const auto& all = processor.parameters().all();
        auto* const parameter = all[random() % all.size()];

        // Not those that would leave nothing to be heard.
        if (parameter != &processor.parameters().bypass() && parameter != &processor.parameters().arm()
            && parameter->getParameterID() != "output_trim")
            parameter->setValueNotifyingHost (static_cast<float> (random() % 1001) / 1000);

        if (i % 50 == 49)
        {
            const auto start = demonstrator();
            processor.load (i % 100 == 49 ? start.device : nullptr, start.focus);
        }

        processor.session().fire (0.5);
        std::this_thread::sleep_for (std::chrono::milliseconds (5));
    }
}
} // namespace

/** Plays the processor for some seconds, 5 where none are given, while everything about it changes. Exit code 1 where its audio thread
    does what it may not, or nothing is heard. */
int main (int argumentCount, char** arguments)
{
    if (! guardsSee())
    {
        std::puts ("the guards of the audio thread do not work");
        return 1;
    }

    const juce::ScopedJuceInitialiser_GUI juce;
    const auto seconds = argumentCount > 1 ? std::atof (arguments[1]) : 5.0;
    AntinodeProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.setRateAndBufferSizeDetails (rate, longestBlock);
    processor.prepareToPlay (rate, longestBlock);
    Findings findings;
    std::atomic<bool> isPlaying { true };
    std::thread audio (
        [&]
        {
            playAll (processor, seconds, findings);
            isPlaying = false;
        });
    disturb (processor, isPlaying);
    audio.join();
    std::printf ("%lld blocks; on the audio thread: %lld allocations%s, %lld locks, first system call %ld%s\n",
                 static_cast<long long> (findings.blocks), static_cast<long long> (findings.allocations),
                 mallocIsCounted() ? "" : " (not counted)", static_cast<long long> (findings.locks),
                 SyscallTrap::firstCaught(), SyscallTrap::isAvailable() ? "" : " (not caught by this kernel)");
    const auto isSound = findings.areFinite && findings.isHeard && findings.allocations == 0 && findings.locks == 0
                         && SyscallTrap::firstCaught() < 0;
    std::puts (isSound ? "sound" : "NOT SOUND");
    return isSound ? 0 : 1;
}
