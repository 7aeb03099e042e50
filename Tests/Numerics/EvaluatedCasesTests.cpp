#include <antinode_base/Watch.h>
#include <antinode_numerics/ParallelFor.h>

#include <catch2/catch.hpp>

using namespace antinode;

TEST_CASE ("Cases have the same results for any number of threads, and are counted as they are done",
           "[numerics][threads]")
{
    const std::function<double (std::size_t)> square = [] (std::size_t number)
    { return static_cast<double> (number * number); };

    for (const std::size_t threads : { 1, 2, 7 })
    {
        std::vector<std::uint64_t> heard;
        const auto results = evaluateCases<double> (
            100, square, [&] (std::uint64_t done) { heard.push_back (done); }, threads);
        REQUIRE (results.size() == 100);
        CHECK (results[7] == 49);
        CHECK (results[99] == 99 * 99);
        REQUIRE (heard.size() == 100);

        for (std::uint64_t i = 0; i < heard.size(); ++i)
            CHECK (heard[i] == i + 1);
    }

    CHECK (evaluateCases<double> (0, square).empty());
}

TEST_CASE ("Cases end where a watch says so", "[numerics][threads]")
{
    std::uint64_t last = 0;
    const WatchScope scope ([&] { return last < 10; });
    const std::function<int (std::size_t)> same = [] (std::size_t number) { return static_cast<int> (number); };
    CHECK_THROWS_AS (evaluateCases<int> (
                         1000, same, [&] (std::uint64_t done) { last = done; }, 1),
                     Cancelled);
    CHECK (last == 10);
}
