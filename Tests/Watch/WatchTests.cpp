#include <antinode_base/Watch.h>
#include <antinode_numerics/ParallelFor.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

using namespace antinode;

TEST_CASE ("Work without a watch goes on, and a watch that says no cancels it", "[watch]")
{
    CHECK_NOTHROW (checkWatch());
    {
        const WatchScope none { {} };
        CHECK_NOTHROW (checkWatch());
    }
    {
        auto goesOn = true;
        const WatchScope scope ([&] { return goesOn; });
        CHECK_NOTHROW (checkWatch());
        goesOn = false;
        CHECK_THROWS_AS (checkWatch(), Cancelled);
    }
    CHECK_NOTHROW (checkWatch());
}

TEST_CASE ("Inner work is cancelled by outer watches too, outer work not by inner ones", "[watch]")
{
    auto outer = true, inner = true;
    const WatchScope outerScope ([&] { return outer; });
    {
        const WatchScope innerScope ([&] { return inner; });
        CHECK_NOTHROW (checkWatch());
        outer = false;
        CHECK_THROWS_AS (checkWatch(), Cancelled);
        outer = true;
        inner = false;
        CHECK_THROWS_AS (checkWatch(), Cancelled);
    }
    CHECK_NOTHROW (checkWatch());
}

TEST_CASE ("A watch is that of its thread, and of threads that take it on", "[watch]")
{
    const WatchScope scope ([] { return false; });
    auto alone = false, helping = false;
    const auto watch = threadWatch();
    std::thread (
        [&]
        {
            CHECK_NOTHROW (checkWatch());
            alone = true;
            const WatchScope taken (watch);

            try
            {
                checkWatch();
            }
            catch (const Cancelled&)
            {
                helping = true;
            }
        })
        .join();
    CHECK (alone);
    CHECK (helping);
}

TEST_CASE ("Work on several threads does all once, hands on the first exception, and is cancelled on all of them",
           "[watch]")
{
    std::array<std::atomic<int>, 1000> done {};
    parallelFor (done.size(), [&] (std::size_t i) { ++done[i]; });
    CHECK (std::all_of (done.begin(), done.end(), [] (const auto& n) { return n == 1; }));

    std::atomic<int> begun { 0 };
    CHECK_THROWS_WITH (parallelFor (100000,
                                    [&] (std::size_t i)
                                    {
                                        ++begun;

                                        if (i == 10)
                                            throw std::runtime_error ("ten");

                                        // Or all is done before a thread that has to wait for a processor throws.
                                        if (i > 10)
                                            std::this_thread::sleep_for (std::chrono::microseconds (100));
                                    }),
                       "ten");
    CHECK (begun < 100000);

    std::atomic<int> looks { 0 };
    const WatchScope scope ([&] { return ++looks < 100; });
    CHECK_THROWS_AS (parallelFor (100000, [] (std::size_t) {}), Cancelled);
    CHECK (looks < 200);
}
