#include <antinode_session/AudioEntry.h>

#include <catch2/catch.hpp>

#include <span>
#include <thread>
#include <vector>

using namespace antinode;

TEST_CASE ("Triggers of many threads arrive once each, in the order of each thread", "[session]")
{
    constexpr int threads = 4, each = 20000;
    StopCount stops;
    TriggerQueue queue { stops };
    std::vector<std::thread> pushing;

    for (int t = 0; t < threads; ++t)
        pushing.emplace_back (
            [&queue, t]
            {
                for (int i = 0; i < each;)
                    i += queue.push ({ { i, FocusEventKind::trigger, t, 1 } });
            });

    std::vector<int> next (threads, 0);
    std::array<TriggerQueue::Fired, 50> taken;

    for (int count = 0; count < threads * each;)
    {
        const auto got = static_cast<int> (queue.pop (taken).first);
        count += got;

        for (int i = 0; i < got; ++i)
        {
            const auto& event = taken[static_cast<std::size_t> (i)].event;
            REQUIRE (event.offset == next[static_cast<std::size_t> (event.place)]++);
        }
    }

    for (auto& thread : pushing)
        thread.join();

    CHECK (queue.pop (taken).first == 0);
}

TEST_CASE ("A full queue drops what comes, and says so", "[session]")
{
    StopCount stops;
    TriggerQueue queue { stops };

    for (int i = 0; i < 256; ++i)
        REQUIRE (queue.push ({}));

    CHECK_FALSE (queue.push ({}));
}

TEST_CASE ("What was asked for before a stop is void, be it pushed later, and what was asked for after it is not",
           "[session]")
{
    StopCount stops;
    TriggerQueue queue { stops };
    const auto before = stops.now();
    queue.push ({ { 0, FocusEventKind::trigger, 1, 1 }, before });
    stops.stop();
    queue.push ({ { 0, FocusEventKind::trigger, 2, 1 }, stops.now() });
    queue.push ({ { 0, FocusEventKind::trigger, 3, 1 }, before });
    std::array<TriggerQueue::Fired, TriggerQueue::capacity> taken;
    const auto [count, stop] = queue.pop (taken);
    CHECK (stop == stops.now());
    REQUIRE (count == 3);

    for (const auto& each : std::span (taken).first (count))
        CHECK ((each.askedAt == stop) == (each.event.place == 2));
}
