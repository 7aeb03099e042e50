#include <antinode_session/DesignWorker.h>
#include <antinode_session/DeviceRounds.h>
#include <antinode_session/Session.h>

#include <Support/SineBeam.h>

#include <catch2/catch.hpp>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <numeric>
#include <thread>

// Waits without a time limit, thousands of them, while the other side is as quick as it can be: where a signal can be
// lost, one hangs.

using namespace antinode;

namespace
{
/** Ends the program where the work does not end: a thread that hangs cannot be joined. */
template <typename Work>
void requireEnd (const Work& work)
{
    std::atomic<bool> hasEnded { false };
    std::thread watch (
        [&]
        {
            const auto end = std::chrono::steady_clock::now() + std::chrono::seconds (120);

            while (! hasEnded)
            {
                if (std::chrono::steady_clock::now() > end)
                {
                    std::fprintf (stderr, "A signal was lost: a wait did not end within 120 s.\n");
                    std::_Exit (EXIT_FAILURE);
                }

                std::this_thread::sleep_for (std::chrono::milliseconds (20));
            }
        });
    work();
    hasEnded = true;
    watch.join();
}

/** A session that does nothing. */
struct Rounds : DeviceRounds<SessionSnapshot, PlaySettings, double>
{
    Rounds()
        : DeviceRounds (
            {}, [] { return PlaySettings(); }, [] {})
    {
    }

    using DeviceRounds::ask;

    void work() override { takeDocument(); }
    void clear() override {}
};

DesignRequest smallRequest()
{
    DesignRequest request;
    request.model = std::make_shared<const ModalModel> (test::sineBeam (4, 2));
    request.focus.targets = { Target {} };
    request.focus.targets[0].width = 0.03;
    request.focus.targets[0].peakVelocity = 0.001;
    request.focus.focusTime = 0.02;
    request.focus.modes.count = 2;
    request.playback = { Reconstruction::bandLimited, 48000 };
    return request;
}
} // namespace

TEST_CASE ("Whoever waits for rounds of a session is woken", "[stress]")
{
    constexpr int waits = 5000;
    Rounds rounds;
    requireEnd (
        [&]
        {
            std::atomic<int> prepared { 0 };
            std::thread session ([&] { rounds.run(); });
            std::thread host (
                [&]
                {
                    for (; prepared < waits; ++prepared)
                        rounds.ask (48000 + prepared % 2, std::chrono::hours (1));
                });

            for (int i = 0; i < waits; ++i)
                rounds.waitUntilSettled();

            host.join();
            rounds.leave();
            session.join();
            CHECK (prepared == waits);
        });
}

TEST_CASE ("Whoever waits for designs is woken", "[stress]")
{
    const auto request = smallRequest();
    BankHandOver handOver;
    DesignWorker worker (handOver);
    std::array<int, FocusBank::places> all {};
    std::iota (all.begin(), all.end(), 0);
    int touched = 0;
    requireEnd (
        [&]
        {
            for (int i = 0; i < 300; ++i)
            {
                std::promise<int> place;
                worker.request (request);
                const auto isTouched = i % 3 == 0;

                if (isTouched)
                    REQUIRE (worker.touch (0.01, 0, [&] (int designed) { place.set_value (designed); }));

                worker.waitFor (all);

                if (isTouched && place.get_future().get() >= 0)
                    ++touched;
            }
        });
    CHECK (worker.progress().isDone());
    CHECK (touched == 100);
}
