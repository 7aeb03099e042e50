#include "TouchSession.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace antinode
{
namespace
{
using MovementClock = FingerMovement::Clock;

constexpr auto touchRest = std::chrono::milliseconds (20); // for which fingers have stayed where they are
constexpr auto quickLook = std::chrono::milliseconds (1);  // between looks at fingers while quick filters are designed
constexpr auto longestQuick = std::chrono::milliseconds (40); // that quick filters may take to be foretold for
} // namespace

/** Whether what was asked for before this round is there, or cannot be. */
bool TouchSession::isSettled() const
{
    return path == nullptr || designedFor == settings;
}

/** Filters for what the parameters say, unless there are some, and plays them. Those of these places that play for the
   device before it drifted are better than quick ones. */
void TouchSession::design()
{
    designer->setFingers (settings);
    designedFor = settings;
    present.designError.clear();

    try
    {
        if (designer->design (settings.latency) == nullptr)
        {
            const auto arePlayed = isRetuned && present.playedFingers == settings;

            if ((! arePlayed && playQuickly()) || ! areFingersResting())
                throw Cancelled();

            makeDesign();
        }

        play (std::make_unique<const FilterBank> (designer->design (settings.latency)->bank), settings);
        isRetuned = false;
    }
    catch (const Cancelled&)
    {
        checkWatch();
        designedFor.reset();
    }
    catch (const std::exception& failure)
    {
        present.designError = failure.what();
    }

    present.isDesigning = false;

    for (std::size_t i = 0; i < touchLatencies.size(); ++i)
        present.designs[i] = designer->design (i);

    publish();
}

/** Filters for places that may move on before better ones are there: for where fingers will be in the middle of the
    time for which these filters play, until the next ones do.
    @return  whether some play that are for other places than the present ones */
bool TouchSession::playQuickly()
{
    const auto begin = MovementClock::now();
    const auto fade =
        std::chrono::duration_cast<MovementClock::duration> (std::chrono::duration<double> (FilterNode::fadeTime));
    const auto expected = isAwaited() ? settings : movement.expected (begin, quickTime + (quickTime + fade) / 2);
    auto looked = begin;
    const WatchScope scope (
        [this, &looked]
        {
            if (const auto now = MovementClock::now(); now - looked >= quickLook)
            {
                looked = now;
                look();
            }

            return ! hasOtherPath();
        });
    auto bank = designer->quickBank (settings.latency, expected);

    if (bank == nullptr)
        return false;

    play (std::move (bank), expected);
    quickTime = std::min<MovementClock::duration> (MovementClock::now() - begin, longestQuick);
    return expected != settings;
}

/** Whether fingers stay where they are for a moment, or somebody waits for their filters. While they move, quick
   filters have the processor for themselves. */
bool TouchSession::areFingersResting()
{
    for (const auto end = MovementClock::now() + touchRest; ! isAwaited();)
    {
        if (look() != settings)
            return false;

        if (const auto now = MovementClock::now(); now >= end && ! movement.isAnyMoving (now))
            return true;

        std::unique_lock lock (mutex);
        wake.wait_for (lock, interval, [this] { return isStopping || isAnythingNew(); });
    }

    return true;
}

/** Whether somebody waits for what is asked for now, or for the end. */
bool TouchSession::isAwaited() const
{
    const std::lock_guard lock (mutex);
    return isStopping || isAnythingNew();
}

/** Another device or format ends it, and other places, since quick filters for them sound better than none. */
void TouchSession::makeDesign()
{
    present.isDesigning = true;
    present.progress = 0;
    publish();
    const WatchScope scope ([this] { return ! hasOtherPath() && owner.settings (settings) == settings; });
    designer->makeDesign (settings.latency,
                          [this] (const std::string&, double share)
                          {
                              present.progress = share;
                              publish();
                          });
}

void TouchSession::play (std::unique_ptr<const FilterBank> bank, const TouchSettings& places)
{
    path->banks().give (std::move (bank));
    present.playedFingers = places;
    publish();
}

bool TouchSession::hasOtherPath()
{
    const std::lock_guard lock (mutex);
    return nextDevice != nullptr || wantedFormat != format;
}

/** One more latency, so that their volts can be compared; whatever else there is to do ends it. */
void TouchSession::compare()
{
    if (! isComparing || designer == nullptr || ! present.designError.empty() || hasNews())
        return;

    try
    {
        const WatchScope scope ([this] { return ! hasNews(); });

        for (std::size_t i = 0; i < touchLatencies.size(); ++i)
            if (designer->design (i) == nullptr)
            {
                designer->makeDesign (i, {});
                present.designs[i] = designer->design (i);
                publish();
            }
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
    catch (const std::exception&)
    {
        isComparing = false; // The one that was chosen plays all the same.
    }
}

bool TouchSession::hasNews()
{
    {
        const std::lock_guard lock (mutex);

        if (roundsRequested > roundsDone)
            return true;
    }

    return hasOtherPath() || owner.settings (settings) != settings || designedFor != settings;
}
} // namespace antinode
