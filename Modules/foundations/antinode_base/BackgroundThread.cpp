#include "BackgroundThread.h"

#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <utility>
#include <vector>

namespace antinode
{
/** The end of a thread's work, for those who wait for it. */
struct BackgroundThread::Ending
{
    void signal()
    {
        const std::lock_guard lock (mutex);
        hasEnded = true;
        changed.notify_all();
    }

    bool isSignalledWithin (std::chrono::milliseconds time)
    {
        std::unique_lock lock (mutex);
        return changed.wait_for (lock, time, [this] { return hasEnded; });
    }

    std::mutex mutex;
    std::condition_variable changed;
    bool hasEnded = false;
};

namespace
{
std::atomic<int> threadsInLibrary { 0 };

/** While a thread has one, the C library does not unmap the library whose code its destructor is: a host may unload us
   while a thread without an owner runs. */
struct LibraryInUse
{
    LibraryInUse() { ++threadsInLibrary; }
    ~LibraryInUse() { --threadsInLibrary; }
};

/** The threads without an owner. */
class LeftThreads
{
public:
    /** Frees those that have ended, too. @param hasEnded  whether its join will not wait */
    void add (std::thread thread, std::function<bool()> hasEnded)
    {
        const std::lock_guard lock (mutex);
        removeEnded();
        threads.push_back ({ std::move (thread), std::move (hasEnded) });
    }

    int count()
    {
        const std::lock_guard lock (mutex);
        removeEnded();
        return static_cast<int> (threads.size());
    }

    void join()
    {
        std::vector<Left> all;
        {
            const std::lock_guard lock (mutex);
            all.swap (threads);
        }

        for (auto& left : all)
            left.thread.join();
    }

private:
    struct Left
    {
        std::thread thread;
        std::function<bool()> hasEnded;
    };

    void removeEnded()
    {
        std::erase_if (threads,
                       [] (Left& left)
                       {
                           const auto isOver = left.hasEnded();

                           if (isOver)
                               left.thread.join();

                           return isOver;
                       });
    }

    std::mutex mutex;
    std::vector<Left> threads;
};

/** Never destroyed: threads are added and joined while statics are destroyed. */
LeftThreads& leftThreads()
{
    static auto* const threads = new LeftThreads();
    return *threads;
}
} // namespace

BackgroundThread::BackgroundThread (std::function<void()> work)
    : ending (std::make_shared<Ending>()), thread (
                                               [end = ending, toDo = std::move (work)]() mutable
                                               {
                                                   thread_local const LibraryInUse use;
                                                   static_cast<void> (&use);
                                                   toDo();
                                                   toDo = nullptr;
                                                   end->signal();
                                               })
{
}

BackgroundThread::~BackgroundThread()
{
    if (ending->isSignalledWithin (patience))
    {
        thread.join();
        return;
    }

    leftThreads().add (std::move (thread), [end = ending] { return end->isSignalledWithin ({}); });
    // What is registered last runs first: before all that the thread has used so far is destroyed.
    std::atexit (joinLeft);
}

void BackgroundThread::joinLeft()
{
    leftThreads().join();
}

int BackgroundThread::left()
{
    return leftThreads().count();
}
} // namespace antinode
