#include <antinode_base/BackgroundThread.h>

#include <catch2/catch.hpp>

#include <atomic>

using namespace antinode;
using Clock = std::chrono::steady_clock;

TEST_CASE ("A thread that ends soon is waited for, one that does not is left to end by itself", "[base]")
{
    struct Shared
    {
        std::atomic<bool> mayEnd { false }, hasEnded { false };
    };

    const auto isQuick = GENERATE (true, false);
    const auto shared = std::make_shared<Shared>();
    std::weak_ptr<int> ofWork;
    shared->mayEnd = isQuick;
    const auto start = Clock::now();
    {
        const auto kept = std::make_shared<int> (0);
        ofWork = kept;
        const BackgroundThread thread (
            [shared, kept]
            {
                while (! shared->mayEnd)
                    std::this_thread::sleep_for (std::chrono::milliseconds (1));

                shared->hasEnded = true;
            });
    }
    CHECK (shared->hasEnded == isQuick);
    CHECK (ofWork.expired() == isQuick);
    CHECK (BackgroundThread::left() == (isQuick ? 0 : 1));

    if (! isQuick)
        CHECK (Clock::now() - start >= BackgroundThread::patience);

    shared->mayEnd = true;
    BackgroundThread::joinLeft();
    CHECK (shared->hasEnded);
    CHECK (ofWork.expired());
    CHECK (BackgroundThread::left() == 0);
}
