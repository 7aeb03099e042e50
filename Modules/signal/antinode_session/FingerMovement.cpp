#include "FingerMovement.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
using std::chrono::milliseconds;
using Seconds = std::chrono::duration<double>;

constexpr auto longestPause = milliseconds (100); // between two places of one way: slow hosts send one every 50 ms
constexpr auto wayKept = milliseconds (40);       // of a way, over which its velocity is a mean
constexpr auto shortestWay = milliseconds (5);    // that tells a velocity: x and y come one after the other
constexpr auto furthest = milliseconds (60);      // that a place is foretold from the last one seen
constexpr double leap = 400;                      // % of the surface in a second: quicker than hands go
constexpr float still = 0.5F;                     // % of the surface: a finger that rests trembles

bool isStill (const FingerSettings& one, const FingerSettings& other)
{
    return one.presence == other.presence && one.load == other.load && std::abs (one.xPercent - other.xPercent) <= still
           && std::abs (one.yPercent - other.yPercent) <= still;
}

float foretold (double from, double to, double times)
{
    return static_cast<float> (std::clamp (to + (to - from) * times, 0.0, 100.0));
}
} // namespace

void FingerMovement::note (const TouchSettings& settings, Clock::time_point time)
{
    newest = settings;

    if (! std::equal (settings.fingers.begin(), settings.fingers.end(), resting.fingers.begin(), isStill))
    {
        resting = settings;
        restsSince = time;
    }

    for (std::size_t k = 0; k < ways.size(); ++k)
        noteFinger (ways[k], settings.fingers[k], time);
}

void FingerMovement::noteFinger (Way& way, const FingerSettings& finger, Clock::time_point time)
{
    const Seen seen { time, static_cast<double> (finger.xPercent), static_cast<double> (finger.yPercent) };

    if (finger.presence == FingerPresence::absent)
        return way.clear();

    if (! way.empty())
    {
        const auto& last = way.back();
        const auto distance = std::hypot (seen.x - last.x, seen.y - last.y);

        if (distance == 0)
            return;

        if (time - last.time > longestPause || distance > leap * Seconds (time - last.time).count())
            way.clear();
    }

    way.push_back (seen);

    while (way.size() > 2 && time - way[1].time >= wayKept)
        way.erase (way.begin());
}

bool FingerMovement::isMoving (const Way& way, Clock::time_point now)
{
    if (way.size() < 2 || way.back().time - way.front().time < shortestWay)
        return false;

    const auto between = (way.back().time - way.front().time) / static_cast<Clock::rep> (way.size() - 1);
    return now - way.back().time <= 2 * between + shortestWay;
}

bool FingerMovement::isAnyMoving (Clock::time_point now) const
{
    return std::any_of (ways.begin(), ways.end(), [now] (const auto& way) { return isMoving (way, now); });
}

TouchSettings FingerMovement::expected (Clock::time_point now, Clock::duration ahead) const
{
    auto settings = newest;

    for (std::size_t k = 0; k < ways.size(); ++k)
        if (const auto& way = ways[k]; isMoving (way, now))
        {
            const auto &first = way.front(), &last = way.back();
            const auto passed = std::min<Clock::duration> (now + ahead - last.time, furthest);
            const auto times = Seconds (passed) / Seconds (last.time - first.time);
            settings.fingers[k].xPercent = foretold (first.x, last.x, times);
            settings.fingers[k].yPercent = foretold (first.y, last.y, times);
        }

    return settings;
}
} // namespace antinode
