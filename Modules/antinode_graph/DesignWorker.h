#pragma once

#include "DesignRequest.h"

#include <antinode_engine/BankHandOver.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace antinode
{
/** Designs banks on a thread of its own and hands them over: the wanted place first, then the others outward from it, in ever larger parts. A newer
    request replaces one that has not been finished: rapid changes of a parameter coalesce. Until a place is designed anew it
    keeps the focus that it had. */
class DesignWorker
{
public:
    /** @param handOver  outlives this. [worker] starts the thread */
    explicit DesignWorker (BankHandOver& handOver);

    /** Abandons what is not finished and joins the thread. [worker] */
    ~DesignWorker();
    DesignWorker (const DesignWorker&) = delete;
    DesignWorker& operator= (const DesignWorker&) = delete;

    /** Asks for a bank. Returns at once. [any but the audio thread] */
    void request (DesignRequest);

    /** Waits until the newest request is designed and handed over: for offline rendering. [any but a real-time audio thread] */
    void waitUntilDone();

    /** [any but the audio thread] */
    DesignProgress progress() const;

private:
    using Clock = std::chrono::steady_clock;

    void run();
    void designBank (const DesignRequest&, Clock::time_point asked);
    void designPlace (const DesignRequest&, int place);
    bool isOutdated() const;
    void handOverBank();

    BankHandOver& handOver;
    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    std::optional<DesignRequest> next; ///< Under the mutex, as all that follows.
    Clock::time_point nextAsked;
    DesignProgress state;
    bool isStopping = false, isWorking = false;
    FocusBank bank; ///< Of the thread only: what was designed so far.
    std::thread thread;
};
} // namespace antinode
