#pragma once

#include "Documents.h"
#include "SessionOwner.h"

#include <antinode_base/Watch.h>
#include <antinode_model/ModalModel.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>

namespace antinode
{
/** What an effect on a device asks of its session's thread, and what it gets: a device to solve, a format to play in,
    waiting until all is taken up, and a snapshot. Requests and answers are under a lock; the thread works in rounds.
    @tparam Snapshot  has device, model, isSolving and error
    @tparam Settings  what parameters say
    @tparam Format    what a host plays; all zero before the first preparation */
template <typename Snapshot, typename Settings, typename Format>
class DeviceRounds
{
public:
    /** Another device; the one before plays on until it is solved. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument> device)
    {
        const std::lock_guard lock (mutex);
        nextDevice = std::move (device);
        wake.notify_all();
    }

    /** Waits until all that was asked for is taken up. [any but a real-time audio thread] */
    void waitUntilSettled()
    {
        std::unique_lock lock (mutex);
        const auto round = ++roundsRequested;
        wake.notify_all();
        settled.wait (lock, [&] { return roundsDone >= round; });
    }

    /** [any but the audio thread] */
    std::shared_ptr<const Snapshot> snapshot() const
    {
        const std::lock_guard lock (mutex);
        return published;
    }

    /** Ends the thread as soon as its work lets it; from now on nothing of the owner is called. [any but the audio
        thread] */
    void leave()
    {
        {
            const std::lock_guard lock (mutex);
            isStopping = true;
            wake.notify_all();
        }
        owner.leave();
    }

protected:
    static constexpr auto interval = std::chrono::milliseconds (4);  ///< Between looks at the parameters.
    static constexpr auto patience = std::chrono::milliseconds (40); ///< Of a host that prepares us.

    /** @param readSettings  gives what the parameters say
        @param onChange      called after the snapshot has changed. Both are called on the session's thread and must not
                             block */
    DeviceRounds (DeviceDocument device, std::function<Settings()> readSettings, std::function<void()> onChange)
        : owner (std::move (readSettings), std::move (onChange)),
          nextDevice (std::make_shared<const DeviceDocument> (std::move (device))),
          published (std::make_shared<const Snapshot>())
    {
    }

    ~DeviceRounds() = default;

    /** Asks for a format, and waits a moment for it. [worker] */
    void ask (const Format& format)
    {
        std::unique_lock lock (mutex);
        wantedFormat = format;
        const auto round = ++roundsRequested;
        wake.notify_all();
        settled.wait_for (lock, patience, [&] { return roundsDone >= round; });
    }

    // What follows is of the session's thread.

    Format askedFor() const
    {
        const std::lock_guard lock (mutex);
        return wantedFormat;
    }

    /** @return  false at the end */
    bool awaitRound (std::uint64_t& round)
    {
        std::unique_lock lock (mutex);
        wake.wait_for (lock, interval, [this] { return isStopping || nextDevice || roundsRequested > roundsDone; });
        round = roundsRequested;
        return ! isStopping;
    }

    void finish (std::uint64_t round)
    {
        const std::lock_guard lock (mutex);
        roundsDone = round;
        settled.notify_all();
    }

    /** @return  whether there is another document now */
    bool takeDocument()
    {
        const std::lock_guard lock (mutex);

        if (nextDevice == nullptr)
            return false;

        present.device = std::exchange (nextDevice, nullptr);
        return true;
    }

    bool hasOtherDocument() const
    {
        const std::lock_guard lock (mutex);
        return nextDevice != nullptr;
    }

    /** A newer device ends this one's solving; the next round takes it.
        @param solved  gives the model of a document */
    template <typename Solved>
    void solve (const Solved& solved)
    {
        present.isSolving = true;
        publish();

        try
        {
            const WatchScope scope ([this] { return ! hasOtherDocument(); });
            present.model = solved (*present.device);
            present.error.clear();
            isModelNew = true;
        }
        catch (const Cancelled&)
        {
            checkWatch();
        }
        catch (const std::exception& failure)
        {
            present.error = failure.what();
        }

        present.isSolving = false;
        publish();
    }

    void publish()
    {
        {
            const std::lock_guard lock (mutex);
            published = std::make_shared<const Snapshot> (present);
        }
        owner.tell();
    }

    SessionOwner<Settings> owner;
    std::atomic<bool> isStopping { false };
    mutable std::mutex mutex; ///< For the next lines, and what ends a wait is changed under it.
    std::condition_variable wake, settled;
    std::shared_ptr<const DeviceDocument> nextDevice;
    Format wantedFormat {};
    std::uint64_t roundsRequested = 0, roundsDone = 0;
    std::shared_ptr<const Snapshot> published;

    Snapshot present; ///< Of the session's thread, as the next lines.
    Settings settings;
    bool isModelNew = false;
};
} // namespace antinode
