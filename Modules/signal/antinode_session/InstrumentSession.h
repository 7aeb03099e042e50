#pragma once

#include "AudioEntry.h"
#include "DeviceRounds.h"
#include "DriftFollower.h"
#include "NoteBank.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
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

    std::optional<std::vector<int>> awaitedNotes; ///< Under the lock.
    double toldEnd = 0;                           ///< s
};
} // namespace antinode
