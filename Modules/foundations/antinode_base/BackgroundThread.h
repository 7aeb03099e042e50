#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace antinode
{
/** A thread that does not keep its owner waiting. Where its work does not end soon after the owner goes, it ends by
   itself later: so the work owns all that it uses, by shared pointers. The program waits for such threads before it
   exits, and a library that is unloaded meanwhile stays in memory until they have ended.
   Docs/Design/session.md */
class BackgroundThread
{
public:
    /** How long the owner waits at most. */
    static constexpr auto patience = std::chrono::milliseconds (25);

    /** @param work  is freed on the thread [any but the audio thread] */
    explicit BackgroundThread (std::function<void()> work);

    /** Waits for the end, but not longer than the patience. Tell the work to end before. [any but the audio thread] */
    ~BackgroundThread();

    BackgroundThread (const BackgroundThread&) = delete;
    BackgroundThread& operator= (const BackgroundThread&) = delete;

    /** Waits for the threads that have lost their owners. [any but the audio thread] */
    static void joinLeft();

    /** How many threads run without an owner. [any but the audio thread] */
    static int left();

private:
    struct Ending;

    std::shared_ptr<Ending> ending;
    std::thread thread;
};
} // namespace antinode
