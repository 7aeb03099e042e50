#include "PlayedTouch.h"

#include "Support/AllocationCount.h"
#include <Support/AudioThreadGuards.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr int ceramics = 12, longestBlock = 512;

/** Seconds of audio; ANTINODE_TOUCH_SOAK says more, played by hand for ten minutes. */
int secondsOfAudio()
{
    const auto* const wanted = std::getenv ("ANTINODE_TOUCH_SOAK");
    return wanted != nullptr ? std::atoi (wanted) : 15;
}

struct TouchFindings
{
    long allocations = 0, locks = 0;
    bool areWithin = true, isHeard = false;
};

/** Plays blocks of many lengths, as fast as it goes. */
TouchFindings playGuarded (TouchProcessor& processor)
{
    TouchFindings findings;
    juce::AudioBuffer<float> buffer (ceramics, longestBlock);
    const auto samples = 48000LL * secondsOfAudio();

    for (long long done = 0, i = 0; done < samples; ++i)
    {
        const auto count = static_cast<int> (1 + i * 37 % longestBlock);
        done += count;
        buffer.setSize (ceramics, count, false, false, true);

        for (int k = 0; k < ceramics; ++k)
            for (int n = 0; n < count; ++n)
                buffer.setSample (k, n, 0.1F * static_cast<float> ((n / 20 * (k + 3) + i) % 17 - 8));

        auto midi = notesWithin ({ { 0, static_cast<int> (i % 128), 100 } }, i % 5 == 0 ? 0 : 1, count);
        const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
        {
            const SyscallTrap trap;
            processor.processBlock (buffer, midi);
        }
        findings.allocations += mallocCalls() - memoryBefore;
        findings.locks += lockCalls() - locksBefore;
        const auto level = buffer.getMagnitude (0, count);
        findings.areWithin = findings.areWithin && level <= 1;
        findings.isHeard = findings.isHeard || level > 1e-5F;
    }

    return findings;
}
} // namespace

TEST_CASE ("The touch plug-in asks for no memory and waits for nothing while fingers move, come and go, and notes play",
           "[touch-plugin][soak]")
{
    REQUIRE (guardsSee());
    TouchProcessor processor (ceramics, juce::AudioProcessor::wrapperType_Undefined);
    processor.parameters().setValues (threeFingers());
    processor.prepareToPlay (48000, longestBlock);
    const auto focus = std::make_shared<const FocusDocument> (
        readFocusDocument (loadDocument (LibraryKind::focus, "aluminium-centre"), "focus"));
    processor.loadFocus (focus);
    processor.session().following().setSettings ({ FollowingSensor::velocity, 20, 20 });
    processor.session().waitUntilSettled();
    TouchFindings findings;
    std::atomic<bool> isPlaying { true };
    std::thread audio (
        [&]
        {
            findings = playGuarded (processor);
            isPlaying = false;
        });

    for (int i = 0; isPlaying; ++i)
    {
        auto& parameters = processor.parameters();
        parameters.finger (static_cast<std::size_t> (i % 3))
            .x->setValueNotifyingHost (static_cast<float> (i * 7 % 100) / 100);
        parameters.gain().setValueNotifyingHost (static_cast<float> (i % 10) / 10);

        if (i % 20 == 10)
            parameters.finger (1).presence->setValueNotifyingHost (static_cast<float> (i / 20 % 3) / 2);

        if (i % 70 == 35)
            parameters.latency().setValueNotifyingHost (static_cast<float> (i / 70 % 3) / 2);

        if (i % 300 == 299)
            processor.loadFocus (i % 600 == 299 ? nullptr : focus);

        if (i % 1000 == 999)
            processor.load (touchDevice (i % 2000 == 999 ? "beam" : "aluminium-200x120"));

        processor.session().fingerMeters().felt.take (0);
        std::this_thread::sleep_for (std::chrono::milliseconds (2));
    }

    audio.join();
    CHECK (findings.allocations == 0);
    CHECK (findings.locks == 0);
    CHECK (SyscallTrap::firstCaught() < 0);
    CHECK (findings.areWithin);
    CHECK (findings.isHeard);
    SyscallTrap::clear();
}
