#include "Support/AllocationCount.h"
#include "Vst3BareBlock.h"

#include <Support/SyscallTrap.h>

#include <catch2/catch.hpp>

#include <random>
#include <thread>

#include <sys/syscall.h>

using namespace antinode::test;

namespace
{
constexpr int blocks = 1500, warmUp = 50, length = 128;

struct AudioFindings
{
    long maximumAllocations = 0, allocations = 0;
    bool isHeard = false;
};

/** Plays notes and moves parameters, and counts what process() asks for. Goes on, with parameters as they are, until a
    focus is heard: a busy machine designs late. */
AudioFindings playGuarded (RawVst3& plugin, int ceramics)
{
    AudioFindings findings;
    std::mt19937 random (29);
    const auto parameters = plugin.parameters();
    const auto arm = plugin.parameter (u"Arm"), trim = plugin.parameter (u"Output trim"),
               gain = plugin.parameter (u"Monitor gain");

    for (int i = 0; i < blocks || ! findings.isHeard; ++i)
    {
        BareBlock block (length, { ceramics, 2 });

        const auto& parameter = parameters[random() % parameters.size()];
        block.changes.add (gain, 0, 0.5 + 0.001 * (i % 100));

        // Now and then another focus or path, so that some are played too. Not the bypass, nor what arms and trims.
        if (i < blocks && i % 20 == 0 && parameter.id != arm && parameter.id != trim
            && (parameter.flags & Vst::ParameterInfo::kIsBypass) == 0)
            block.changes.add (parameter.id, 0, static_cast<double> (random() % 1001) / 1000);

        block.events.events.push_back (
            noteOn (static_cast<int> (random() % length), i % 2 == 0 ? 60 : static_cast<int> (random() % 128)));
        const auto before = mallocCalls();
        {
            const SyscallTrap trap;
            plugin.processor->process (block.data);
        }
        const auto calls = mallocCalls() - before;

        if (i < warmUp) // What a thread needs once: its storage in a library that was loaded late.
        {
            SyscallTrap::clear();
            continue;
        }

        findings.allocations += calls;
        findings.maximumAllocations = std::max (findings.maximumAllocations, calls);
        findings.isHeard = findings.isHeard || ! block.samples.leftCols (2).isZero (0);
        std::this_thread::sleep_for (std::chrono::microseconds (300)); // Time for designs to change.
    }

    return findings;
}
} // namespace

TEST_CASE ("The guard sees into the loaded plug-in", "[vst3]")
{
    if (! mallocIsCounted())
        return;

    RawVst3 plugin (8);
    const auto before = mallocCalls();
    Steinberg::MemoryStream stream;
    plugin.component->getState (&stream);
    CHECK (mallocCalls() - before > 50); // A state is text, made of dozens of parts.
}

TEST_CASE ("A VST3 asks for no memory and waits for nothing while it plays", "[vst3]")
{
    const auto ceramics = GENERATE (2, 8, 29, 32, 64);
    CAPTURE (ceramics);
    RawVst3 plugin (ceramics);
    plugin.activate ({ 48000, length, false, false });
    AudioFindings findings;
    SyscallTrap::clear();
    std::thread audio ([&] { findings = playGuarded (plugin, ceramics); });
    audio.join();
    CHECK (findings.isHeard);
    // JUCE's wrapper makes a buffer in each block, which holds up to 31 channels itself; for more it takes and returns
    // memory once. It also copies what it knows of each input bus (setUpInputChannels), with a vector, on or off.
    CHECK (findings.maximumAllocations <= (ceramics + 2 < 32 ? 2 : 4));
    // Its listeners' lock, which is held for moments elsewhere, is the one thing that it may ever wait for.
    CHECK ((SyscallTrap::firstCaught() < 0 || SyscallTrap::firstCaught() == SYS_futex));
    SyscallTrap::clear();
}
