#include <antinode_session/TriggerQueue.h>

#include <catch2/catch.hpp>

#include <thread>
#include <vector>

using namespace antinode;

TEST_CASE ("Triggers of many threads arrive once each, in the order of each thread", "[session]")
{
    constexpr int threads = 4, each = 20000;
    TriggerQueue queue;
    std::vector<std::thread> pushing;

    for (int t = 0; t < threads; ++t)
        pushing.emplace_back (
            [&queue, t]
            {
                for (int i = 0; i < each;)
                    i += queue.push ({ i, FocusEventKind::trigger, t, 1 });
            });

    std::vector<int> next (threads, 0);
    std::array<FocusEvent, 50> taken;

    for (int count = 0; count < threads * each;)
    {
        const auto got = queue.pop (taken);
        count += got;

        for (int i = 0; i < got; ++i)
        {
            const auto& event = taken[static_cast<std::size_t> (i)];
            REQUIRE (event.offset == next[static_cast<std::size_t> (event.place)]++);
        }
    }

    for (auto& thread : pushing)
        thread.join();

    CHECK (queue.pop (taken) == 0);
}

TEST_CASE ("A full queue drops what comes, and says so", "[session]")
{
    TriggerQueue queue;

    for (int i = 0; i < 256; ++i)
        REQUIRE (queue.push ({}));

    CHECK_FALSE (queue.push ({}));
}
