#include <antinode_numerics/ParallelFor.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace antinode;

TEST_CASE ("Every index is worked on once, by as many threads as are allowed", "[numerics][threads]")
{
    for (const std::size_t threads : { 1, 2, 7 })
        for (const std::size_t count : { 1, 2, 5, 1000 })
        {
            std::vector<std::atomic<int>> visits (count);
            parallelFor (
                count, [&] (std::size_t index) { ++visits[index]; }, threads);

            for (const auto& visit : visits)
                REQUIRE (visit == 1);
        }
}

TEST_CASE ("Nothing is done for no index", "[numerics][threads]")
{
    auto isCalled = false;
    parallelFor (0, [&] (std::size_t) { isCalled = true; });
    CHECK_FALSE (isCalled);
}

TEST_CASE ("One thread is the calling one and goes in order", "[numerics][threads]")
{
    std::vector<std::size_t> order;
    std::set<std::thread::id> ids;
    parallelFor (
        5,
        [&] (std::size_t index)
        {
            order.push_back (index);
            ids.insert (std::this_thread::get_id());
        },
        1);
    CHECK (order == std::vector<std::size_t> { 0, 1, 2, 3, 4 });
    CHECK (ids == std::set { std::this_thread::get_id() });
}

TEST_CASE ("Two threads work at once", "[numerics][threads]")
{
    // Each waits for the other: one thread alone would never end.
    std::atomic<int> arrived { 0 };
    parallelFor (
        2,
        [&] (std::size_t)
        {
            ++arrived;

            while (arrived < 2)
                std::this_thread::yield();
        },
        2);
    CHECK (arrived == 2);
}

TEST_CASE ("Work within work has no more threads than the whole", "[numerics][threads]")
{
    for (const std::size_t threads : { 1, 2, 6 })
        for (const std::size_t count : { 1, 2, 4 })
        {
            std::mutex mutex;
            std::set<std::thread::id> ids;
            std::atomic<int> visits { 0 };
            parallelFor (
                count,
                [&] (std::size_t)
                {
                    parallelFor (
                        50,
                        [&] (std::size_t)
                        {
                            ++visits;
                            const std::lock_guard lock (mutex);
                            ids.insert (std::this_thread::get_id());
                        },
                        100);
                },
                threads);
            CHECK (visits == static_cast<int> (50 * count));
            CHECK (ids.size() <= threads);
        }

    // Afterwards this thread has what it had before.
    std::atomic<int> arrived { 0 };
    parallelFor (
        2,
        [&] (std::size_t)
        {
            ++arrived;

            while (arrived < 2)
                std::this_thread::yield();
        },
        2);
    CHECK (arrived == 2);
}

TEST_CASE ("What a worker throws reaches the caller, and ends the work", "[numerics][threads]")
{
    const auto thrownText = [] (std::size_t threads, const std::function<void (std::size_t)>& work)
    {
        try
        {
            parallelFor (100000, work, threads);
        }
        catch (const std::runtime_error& error)
        {
            return std::string (error.what());
        }

        return std::string ("nothing thrown");
    };

    for (const std::size_t threads : { 1, 2, 7 })
    {
        // Of several the one of the lowest index, whichever thread meets it.
        for (int repeat = 0; repeat < 20; ++repeat)
            CHECK (thrownText (threads,
                               [] (std::size_t index)
                               {
                                   if (index >= 3)
                                       throw std::runtime_error (std::to_string (index));
                               })
                   == "3");

        std::atomic<std::size_t> worked { 0 };
        CHECK (thrownText (threads,
                           [&] (std::size_t index)
                           {
                               ++worked;

                               if (index == 10)
                                   throw std::runtime_error ("ten");
                           })
               == "ten");
        CHECK (worked >= 11);
    }

    // Not the calling thread alone: here it waits until another one has thrown.
    const auto caller = std::this_thread::get_id();
    std::atomic<bool> hasThrown { false };
    CHECK (thrownText (2,
                       [&] (std::size_t)
                       {
                           if (std::this_thread::get_id() != caller)
                           {
                               hasThrown = true;
                               throw std::runtime_error ("other");
                           }

                           while (! hasThrown)
                               std::this_thread::yield();
                       })
           == "other");
}
