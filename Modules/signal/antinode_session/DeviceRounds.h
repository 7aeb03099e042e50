#pragma once

#include "Documents.h"
#include "SessionOwner.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/Library.h>
#include <antinode_engine/FocusEvents.h>
#include <antinode_model/ModalModel.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** What all sessions are asked for, and what they answer: a device to solve, a format to play in, waiting until all is
    taken up, and a snapshot. Requests and answers are under a lock; the session's thread works in rounds.
    @tparam Snapshot  has device, model, isSolving and error
    @tparam Settings  what parameters say
    @tparam PlayedFormat  what a host plays; all zero before the first preparation */
template <typename Snapshot, typename Settings, typename PlayedFormat>
class DeviceRounds
{
public:
    using Format = PlayedFormat;

    /** @param readSettings  gives what the parameters say
        @param onChange      called after the snapshot has changed. Both are called on the session's thread and must not
                             block */
    DeviceRounds (DeviceDocument device, std::function<Settings()> readSettings, std::function<void()> onChange)
        : owner (std::move (readSettings), std::move (onChange)),
          nextDevice (std::make_shared<const DeviceDocument> (std::move (device))),
          published (std::make_shared<const Snapshot>())
    {
    }

    virtual ~DeviceRounds() = default;
    DeviceRounds (const DeviceRounds&) = delete;
    DeviceRounds& operator= (const DeviceRounds&) = delete;

    /** Another device; the one before plays on until it is solved. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument> device)
    {
        const std::lock_guard lock (mutex);
        nextDevice = std::move (device);
        wake.notify_all();
    }

    /** What the outputs behind the ceramics give, if they differ from the device's full scale; a change of a limit
       ramps to 0 V and back. @param volts  of a full-scale sample, for each ceramic; 0 or missing: the device's full
       scale [any but the audio thread] */
    void setAmplifiers (std::vector<double> volts)
    {
        const std::lock_guard lock (mutex);
        wantedAmplifiers = std::move (volts);
    }

    /** Waits until all that was asked for is taken up. @param notes  that a session of instruments waits for, too [any
        but a real-time audio thread] */
    void waitUntilSettled ([[maybe_unused]] std::span<const FocusEvent> notes = {})
    {
        std::unique_lock lock (mutex);
        const auto round = ++roundsRequested;
        wake.notify_all();
        settled.wait (lock, [&] { return roundsDone >= round; });
    }

    /** Works until it is stopped; then no path is left. Nothing may be processing by then. [session's thread] */
    void run()
    {
        const WatchScope scope ([this] { return ! isStopping; });

        try
        {
            for (std::uint64_t round = 0; awaitRound (round);)
            {
                work();
                finish (round);
                rest();
            }
        }
        catch (const Cancelled&)
        {
            // It is stopping.
        }

        clear();
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

    /** Asks for a format, and waits a moment for it. [worker] */
    void ask (const Format& format, std::chrono::milliseconds longest = patience)
    {
        std::unique_lock lock (mutex);
        wantedFormat = format;
        const auto round = ++roundsRequested;
        wake.notify_all();
        settled.wait_for (lock, longest, [&] { return roundsDone >= round && isPlayable(); });
    }

    // What follows is of the session's thread.

    Format askedFor() const
    {
        const std::lock_guard lock (mutex);
        return wantedFormat;
    }

    /** One round: takes up what was asked for. */
    virtual void work() = 0;

    /** Behind a round, when nobody waits for it any more. */
    virtual void rest() {}

    /** Frees all that plays. */
    virtual void clear() = 0;

    /** @return  false at the end */
    bool awaitRound (std::uint64_t& round)
    {
        std::unique_lock lock (mutex);
        wake.wait_for (lock, interval, [this] { return isStopping || isAnythingNew(); });
        round = roundsRequested;
        return ! isStopping;
    }

    void finish (std::uint64_t round)
    {
        const std::lock_guard lock (mutex);
        roundsDone = round;
        settled.notify_all();
    }

    /** Whether something waits that ends what is being done. Under the lock. */
    bool isAnythingNew() const { return nextDevice != nullptr || isMoreAsked() || roundsRequested > roundsDone; }

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
        @param then  called before it is said to be solved */
    template <typename Then>
    void solve (const Then& then)
    {
        present.isSolving = true;
        publish();

        try
        {
            const WatchScope scope ([this] { return ! hasOtherDocument(); });
            auto made = std::make_shared<const ModalModel> (solvedModel (present.device->description));

            if (made->actuators() == 0)
                throw InputError ("device '" + present.device->description.name + "'",
                                  "has no ceramics, so nothing can move it");

            auto volts = askedAmplifiers();
            present.model = withAmplifiers (made, volts);
            solved = std::move (made);
            amplifiers = std::move (volts);
            present.error.clear();
            isModelNew = true;
            then();
        }
        catch (const Cancelled&)
        {
            checkWatch();
        }
        catch (const std::exception& failure)
        {
            present.error = failure.what();
        }

        endSolving();
        present.isSolving = hasOtherDocument(); // Which the next round solves.
        publish();
    }

    /** A path has limits of its own: another one is built where these change. */
    void takeAmplifiers()
    {
        auto wanted = askedAmplifiers();

        if (solved == nullptr || wanted == amplifiers)
            return;

        auto made = withAmplifiers (solved, wanted);
        amplifiers = std::move (wanted);

        if (voltageLimits (*made) != voltageLimits (*present.model))
        {
            present.model = std::move (made);
            isModelNew = true;
            publish();
        }
    }

    std::vector<double> askedAmplifiers() const
    {
        const std::lock_guard lock (mutex);
        return wantedAmplifiers;
    }

    void publish()
    {
        describe();

        {
            const std::lock_guard lock (mutex);
            published = std::make_shared<const Snapshot> (present);
        }
        owner.tell();
    }

    /** @throws InputError  where it cannot be played */
    virtual ModalModel solvedModel (const DeviceDescription& device) const { return solveDevice (device, {}, true); }

    /** Whether more is asked for than rounds have. Under the lock. */
    virtual bool isMoreAsked() const { return false; }

    /** Whether what was asked for plays. Under the lock. */
    virtual bool isPlayable() const { return true; }

    /** Called before it is said that solving has ended, however it did. */
    virtual void endSolving() {}

    /** Completes `present` before it is published. */
    virtual void describe() {}

    SessionOwner<Settings> owner;
    std::atomic<bool> isStopping { false };
    mutable std::mutex mutex; ///< For the next lines, and what ends a wait is changed under it.
    std::condition_variable wake, settled;
    std::shared_ptr<const DeviceDocument> nextDevice;
    Format wantedFormat {};
    std::vector<double> wantedAmplifiers; ///< V
    std::uint64_t roundsRequested = 0, roundsDone = 0;
    std::shared_ptr<const Snapshot> published;

    Snapshot present; ///< Of the session's thread, as the next lines.
    Settings settings;
    std::shared_ptr<const ModalModel> solved; ///< Without the amplifiers.
    std::vector<double> amplifiers;           ///< V
    bool isModelNew = false;
};
} // namespace antinode
