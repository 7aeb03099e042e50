#include "PlayedPlate.h"

#include "Support/AllocationCount.h"
#include <Support/AudioThreadGuards.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr int ceramics = 8, longestBlock = 512, blocks = 3000;

struct Findings
{
    long allocations = 0, locks = 0;
    bool areFinite = true, isHeard = false;
};

/** Plays blocks of many lengths, as fast as it goes. */
Findings playGuarded (PlateProcessor& processor)
{
    Findings findings;
    juce::AudioBuffer<float> buffer (ceramics, longestBlock);
    juce::MidiBuffer midi;

    for (int i = 0; i < blocks; ++i)
    {
        const auto count = 1 + i * 37 % longestBlock;
        buffer.setSize (ceramics, count, false, false, true);

        for (int k = 0; k < ceramics; ++k)
            for (int n = 0; n < count; ++n)
                buffer.setSample (k, n, 0.1F * static_cast<float> ((n * (k + 3) + i) % 17 - 8));

        const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
        {
            const SyscallTrap trap;
            processor.processBlock (buffer, midi);
        }
        findings.allocations += mallocCalls() - memoryBefore;
        findings.locks += lockCalls() - locksBefore;
        const auto level = buffer.getMagnitude (0, count);
        findings.areFinite = findings.areFinite && std::isfinite (level);
        findings.isHeard = findings.isHeard || level > 1e-5F;
    }

    return findings;
}
} // namespace

TEST_CASE ("A plate asks for no memory and waits for nothing while it plays and all about it changes", "[plate]")
{
    REQUIRE (guardsSee());
    PlateProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.prepareToPlay (48000, longestBlock);
    processor.session().waitUntilSettled();
    Findings findings;
    std::atomic<bool> isPlaying { true };
    std::thread audio (
        [&]
        {
            findings = playGuarded (processor);
            isPlaying = false;
        });

    for (int i = 0; isPlaying; ++i)
    {
        processor.parameters().probeX (i % 8).setValueNotifyingHost (static_cast<float> (i % 100) / 100);

        if (i % 20 == 10)
            processor.parameters().setValues ({ { "quick", i % 40 == 10 ? 1 : 0 } });

        if (i % 50 == 49)
            processor.load (plateDevice (i % 100 == 49 ? "beam" : "staple"));

        Eigen::MatrixXd window;

        if (const auto motion = processor.session().snapshot()->motion)
            motion->take (window);

        std::this_thread::sleep_for (std::chrono::milliseconds (2));
    }

    audio.join();
    CHECK (findings.allocations == 0);
    CHECK (findings.locks == 0);
    CHECK (SyscallTrap::firstCaught() < 0);
    CHECK (findings.areFinite);
    CHECK (findings.isHeard);
    SyscallTrap::clear();
}
