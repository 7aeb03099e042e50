#include <antinode_base/LockFreeExchange.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <random>
#include <thread>

using namespace antinode;

namespace
{
/** What is torn has another sum than it should. */
struct Message
{
    std::uint64_t number = 0, twice = 0, thrice = 0;

    static Message of (std::uint64_t i) { return { i, 2 * i, 3 * i }; }
    bool isWhole() const { return twice == 2 * number && thrice == 3 * number; }
};
} // namespace

TEST_CASE ("A ring gives its values in their order and no more than it holds", "[base]")
{
    RingQueue<int, 4> ring;
    int pushed = 0, popped = 0;
    std::minstd_rand random (1);

    for (int step = 0; step < 1000; ++step)
    {
        const auto isPush = random() % 2 == 0;

        if (isPush)
            CHECK (ring.push (pushed) == (pushed - popped < 4));
        else
            CHECK (ring.pop() == (pushed > popped ? std::optional (popped) : std::nullopt));

        pushed += isPush && pushed - popped < 4 ? 1 : 0;
        popped += ! isPush && pushed > popped ? 1 : 0;
        REQUIRE (ring.size() == static_cast<std::size_t> (pushed - popped));
    }
}

TEST_CASE ("Between two threads nothing is lost, exchanged or torn", "[base]")
{
    constexpr std::uint64_t count = 50000;
    RingQueue<Message, 1024> ring; // Long: on a busy machine a thread waits for its turn whenever it is full or empty.
    std::uint64_t wrong = 0, overfull = 0;
    std::thread writer (
        [&]
        {
            for (std::uint64_t i = 0; i < count;)
                if (ring.push (Message::of (i)))
                    ++i;
                else
                    std::this_thread::yield();
        });

    for (std::uint64_t next = 0; next < count;)
    {
        overfull += ring.size() > ring.capacity ? 1 : 0;

        if (const auto message = ring.pop())
            wrong += message->isWhole() && message->number == next++ ? 0 : 1;
        else
            std::this_thread::yield();
    }

    writer.join();
    CHECK (wrong == 0);
    CHECK (overfull == 0);
    CHECK_FALSE (ring.pop());
}
