#pragma once

#include "AudioEntry.h"
#include "DeviceRounds.h"
#include "DriftFollower.h"
#include "NoteBank.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace antinode
{
/** What sessions share that notes play and whose device is followed: the entry of the audio thread, waiting for what
    notes play, and the drift of the device. Template parameters are those of DeviceRounds. */
template <typename Snapshot, typename Settings, typename Format>
class InstrumentSession : public DeviceRounds<Snapshot, Settings, Format>, protected AudioEntry
{
    using Rounds = DeviceRounds<Snapshot, Settings, Format>;

public:
    using AudioEntry::fullScaleVolts, AudioEntry::process, AudioEntry::stops;
    using Rounds::Rounds;

    /** Waits until all that was loaded is taken up, with what the parameters say, and the focus at its own place is
        designed, and those that these notes trigger: for offline rendering. One caller at a time. [any but a real-time
        audio thread] */
    void waitUntilSettled (std::span<const FocusEvent> notes = {})
    {
        std::vector numbers { spotNote };

        for (const auto& event : notes)
            if (event.kind == FocusEventKind::trigger)
                numbers.push_back (event.place);

        await (std::move (numbers));
        Rounds::waitUntilSettled();
        await ({});
    }

    /** Fades all foci out with the next block, and voids what was fired before and waits: foci, their designs,
        triggers, notes. Inputs play on. [any] */
    void stopAll() { stops().stop(); }

    /** What follows the drift of the device, and what is known: all is designed for the device as it is. Another sensor
        makes another path; one that cannot be had becomes a status. Docs/Design/session.md
        [any but the audio thread] */
    FollowingRequests& following() const { return *followingRequests; }

    /** Makes a design for a place of its own, for the device as it is and again for each that comes; it plays by
       playPrepared() as soon as its design is ready. Another one takes the place of the one before.
        @param slot   0 to FocusBank::mostPrepared - 1
        @param ready  called on a worker's thread each time, with what it needs or why there is none; must not block
        [any but the audio thread] */
    void prepareFocus (int slot, PrepareDesign design, std::function<void (const PreparedFocus&)> ready)
    {
        const std::lock_guard lock (this->mutex);
        prepared[slot] = { std::move (design), std::move (ready) };
        newlyPrepared.insert (slot);
        this->wake.notify_all();
    }

    /** Plays what was prepared. @param amplitude, request, due  as AudioEntry::fire; void after a stop
        @return  false where too many wait [any but the audio thread] */
    bool playPrepared (int slot, double amplitude, std::uint32_t request, std::int64_t due = 0)
    {
        return AudioEntry::fire (FocusBank::firstPreparedPlace + slot, amplitude, stops().now(), request, due);
    }

    using AudioEntry::clock, AudioEntry::reports, AudioEntry::writeMarker;

    LevelMeters& meters() { return played.levels; }

protected:
    void clear() override
    {
        deviceFollowing.stop();
        AudioEntry::clear();
    }

    /** Notes whose foci somebody waits for. */
    std::optional<std::vector<int>> awaited() const
    {
        const std::lock_guard lock (this->mutex);
        return awaitedNotes;
    }

    /** Waits for their foci. @return  false where there is nothing to wait for */
    bool waitForNotes()
    {
        auto places = awaited();

        if (! places || path == nullptr || notes() == NoteMeaning::nothing)
            return false;

        for (auto& place : *places)
            place = bankPlaceOf (place, notes());

        path->foci().waitFor (*places);
        return true;
    }

    /** From now on this plays. */
    void playOn (std::unique_ptr<InstrumentPath> made)
    {
        path = made.get();
        isPathServed = false;
        give (std::move (made));
    }

    /** Asks the path for what was prepared since the last call, of a new path for all. */
    void servePrepared()
    {
        const std::lock_guard lock (this->mutex);

        if (path == nullptr)
            return;

        const auto isNew = ! std::exchange (isPathServed, true);

        for (const auto& [slot, each] : prepared)
            if (isNew || newlyPrepared.contains (slot))
                path->foci().prepare (FocusBank::firstPreparedPlace + slot, each.first, each.second);

        newlyPrepared.clear();
    }

    /** Tells the owner where foci end later or earlier than it knows, for the tail. */
    void tellOfEnd (double seconds)
    {
        if (std::exchange (toldEnd, seconds) != seconds)
            this->owner.tell();
    }

    std::atomic<double> ringing { 1 }; ///< s: 60 dB of decay of the slowest mode.
    std::shared_ptr<FollowingRequests> followingRequests = std::make_shared<FollowingRequests>();
    DeviceFollowing deviceFollowing { followingRequests }; ///< Of the session's thread, as the next lines.
    InstrumentPath* path = nullptr; ///< The newest one, which the entry owns; none where it could not be built.

private:
    void await (std::optional<std::vector<int>> notes)
    {
        const std::lock_guard lock (this->mutex);
        awaitedNotes = std::move (notes);
    }

    using Ready = std::function<void (const PreparedFocus&)>;

    std::optional<std::vector<int>> awaitedNotes;            ///< Under the lock, as the next lines.
    std::map<int, std::pair<PrepareDesign, Ready>> prepared; ///< By slot.
    std::set<int> newlyPrepared;
    bool isPathServed = false; ///< Of the session's thread, as the next line.
    double toldEnd = 0;        ///< s
};
} // namespace antinode
