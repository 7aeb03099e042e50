#include <antinode_base/System.h>

#include <catch2/catch.hpp>

#include <memory>

#include <sys/resource.h>

using namespace antinode;

namespace
{
/** How many pages the system hands out for a block that is written once. */
long pagesOfBlock (std::size_t bytes)
{
    rusage before {}, after {};
    getrusage (RUSAGE_SELF, &before);
    {
        const auto block = std::make_unique<unsigned char[]> (bytes);
        REQUIRE (block[bytes / 2] == 0);
    }
    getrusage (RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}
} // namespace

// Sanitizers have an allocator of their own.
#if ! defined(__SANITIZE_ADDRESS__) && ! defined(__SANITIZE_THREAD__)
TEST_CASE ("A program gets the pages of a large block once", "[base]")
{
    constexpr std::size_t bytes = 200'000'000;
    keepFreedMemory();
    pagesOfBlock (bytes);
    CHECK (pagesOfBlock (bytes) < 10); // Fewer than huge pages would be.
}
#endif
