#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace antinode
{
/** What is asked of a thread that answers one question after the other: a newer one replaces one that waits, and makes
    the one that is being answered outdated. */
template <typename Question>
class NewestQuestion
{
public:
    /** Returns at once. [any but the audio thread], as all but take() */
    void ask (Question question)
    {
        const std::lock_guard lock (mutex);
        next = std::move (question);
        isReplaced = true;
        changed.notify_all();
    }

    /** Nobody wants an answer any more, of whatever was asked so far. */
    void giveUp()
    {
        const std::lock_guard lock (mutex);
        next.reset();
        isReplaced = true;
    }

    /** Nobody asks any more; take() ends. */
    void leave()
    {
        const std::lock_guard lock (mutex);
        left = true;
        changed.notify_all();
    }

    /** Waits for a question; the one before is answered. @return  none: nobody asks any more [worker] */
    std::optional<Question> take()
    {
        std::unique_lock lock (mutex);
        isWorking = false;
        changed.wait (lock, [this] { return next || left; });

        if (left)
            return std::nullopt;

        isReplaced = false;
        isWorking = true;
        return std::exchange (next, std::nullopt);
    }

    /** Whether nobody waits for the answer that is being made. */
    bool isOutdated() const { return isReplaced || left; }

    bool hasLeft() const { return left; }

    /** Whether nothing is asked or answered. */
    bool isDone() const
    {
        const std::lock_guard lock (mutex);
        return ! next && ! isWorking;
    }

    /** Whether no question comes for so long: waits for that. [worker] */
    bool isQuietFor (std::chrono::milliseconds time)
    {
        std::unique_lock lock (mutex);
        return ! changed.wait_for (lock, time, [this] { return next || left; });
    }

private:
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::optional<Question> next; ///< Under the mutex, as the next line.
    bool isWorking = false;
    std::atomic<bool> isReplaced { false }, left { false };
};
} // namespace antinode
