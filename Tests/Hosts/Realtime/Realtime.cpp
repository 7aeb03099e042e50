#include <Editor/EditorContent.h>
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
    std::int64_t automationAllocations = 0;
    long automationSystemCall = -1; ///< The first one, other than the wait below.
    bool areFinite = true, isHeard = false;
};

/** Whether a random step may set the parameter: not what would leave nothing to be heard. */
bool mayMove (AntinodeProcessor& processor, const juce::RangedAudioParameter* parameter)
{
    return parameter != &processor.parameters().bypass() && parameter != &processor.parameters().arm()
           && parameter->getParameterID() != "output_trim";
}

/** Sets a parameter as JUCE's wrappers do for their hosts, on the audio thread, and tells all who listen. JUCE holds a
   lock meanwhile, and may wait for it where the editor is just adding itself; what listens must not ask for anything.
 */
void automate (AntinodeProcessor& processor, std::mt19937& random, Findings& findings)
{
    const auto& all = processor.parameters().all();
    auto* const parameter = all[random() % all.size()];
    const auto value = static_cast<float> (random() % 1001) / 1000;

    if (! mayMove (processor, parameter))
        return;

    const auto before = mallocCalls(), caughtBefore = static_cast<std::int64_t> (SyscallTrap::firstCaught());
    {
        const SyscallTrap trap;
        parameter->setValueNotifyingHost (value);
    }
    findings.automationAllocations += mallocCalls() - before;

    if (caughtBefore < 0 && SyscallTrap::firstCaught() >= 0)
    {
        if (SyscallTrap::firstCaught() != SYS_futex && findings.automationSystemCall < 0)
            findings.automationSystemCall = SyscallTrap::firstCaught();

        SyscallTrap::clear(); // So that a system call of a block is still told apart.
    }
}

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

        if (i % 10 == 0)
            automate (processor, random, findings);

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

/** Moves one parameter, and so asks for designs and for paths, while the other thread plays. */
void moveOne (AntinodeProcessor& processor, std::mt19937& random)
{
    const auto& all = processor.parameters().all();
    auto* const parameter = all[random() % all.size()];

    if (mayMove (processor, parameter))
        parameter->setValueNotifyingHost (static_cast<float> (random() % 1001) / 1000);
}

/** The same by the spot on the editor's surface, as one gesture. */
void dragSpot (AntinodeProcessor& processor, std::mt19937& random)
{
    auto& x = *processor.parameters().find ("x");
    x.beginChangeGesture();

    for (int i = 0; i < 5; ++i)
        x.setValueNotifyingHost (static_cast<float> (random() % 1001) / 1000);

    x.endChangeGesture();
}

/** What an open editor does: frames of the animation, undo, another panel, and pictures, here of another size each. */
void show (Editor& editor, int step)
{
    auto& content = editor.content();
    content.refresh (1.0 / 60);

    if (step % 16 == 0)
        content.timeline().setPlaying (step % 32 == 0);

    if (step % 24 == 0)
        content.history().undo();

    if (step % 12 == 0)
    {
        editor.setSize (800 + 40 * (step % 20), 500 + 20 * (step % 20));
        content.showPanel (step % 24 == 0 ? "Scores" : "Probe");
        editor.createComponentSnapshot (editor.getLocalBounds(), true, 1);
    }
}

/** Everything that goes on beside the audio thread, with an editor that is opened and closed. */
void disturb (AntinodeProcessor& processor, const std::atomic<bool>& isPlaying)
{
    std::mt19937 random (9);
    std::unique_ptr<Editor> editor;

    for (int i = 0; isPlaying; ++i)
    {
        if (i % 64 == 0)
        {
            editor = nullptr;
            editor.reset (dynamic_cast<Editor*> (processor.createEditorIfNeeded()));
        }

        moveOne (processor, random);
        dragSpot (processor, random);
        show (*editor, i);

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

/** Plays the processor for some seconds, 5 where none are given, while everything about it changes and its editor is
   used. Exit code 1 where its audio thread does what it may not, or nothing is heard. */
int main (int argumentCount, char** arguments)
{
    if (! guardsSee())
    {
        std::puts ("the guards of the audio thread do not work");
        return 1;
    }

    const juce::ScopedJuceInitialiser_GUI juce;
    installEditor();
    const auto seconds = argumentCount > 1 ? std::atof (arguments[1]) : 5.0;
    AntinodeProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.setRateAndBufferSizeDetails (rate, longestBlock);
    processor.prepareToPlay (rate, longestBlock);
    processor.session().waitUntilSettled(); // Or a busy computer has no focus to play before all changes.
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
    std::printf ("automation there: %lld allocations, first system call %ld\n",
                 static_cast<long long> (findings.automationAllocations), findings.automationSystemCall);
    std::printf ("outputs: %s, %s\n", findings.areFinite ? "finite" : "NOT FINITE",
                 findings.isHeard ? "heard" : "nothing heard");
    const auto isSound = findings.areFinite && findings.isHeard && findings.allocations == 0 && findings.locks == 0
                         && SyscallTrap::firstCaught() < 0 && findings.automationAllocations == 0
                         && findings.automationSystemCall < 0;
    std::puts (isSound ? "sound" : "NOT SOUND");
    return isSound ? 0 : 1;
}
