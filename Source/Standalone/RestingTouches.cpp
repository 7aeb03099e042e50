#include "RestingTouches.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
bool overlap (const Finger& a, const Finger& b)
{
    return std::hypot (a.x - b.x, a.y - b.y) < a.radius + b.radius;
}

bool isOn (const Surface& surface, double x, double y)
{
    return x >= surface.xMinimum && x <= surface.xMaximum
           && (surface.kind == SurfaceKind::line || (y >= surface.yMinimum && y <= surface.yMaximum));
}

/** One that a file gave back: numbers in other units may differ in their last digits. */
bool isSame (const Finger& a, const Finger& b)
{
    constexpr double nearly = 1e-9; // m
    return a.name == b.name && ! a.isKnown && ! b.isKnown && std::hypot (a.x - b.x, a.y - b.y) < nearly;
}
} // namespace

void RestingTouches::setKind (const std::string& kindToUse)
{
    const std::lock_guard lock (mutex);
    kind = kindToUse;
    resting.clear();
}

bool RestingTouches::rest (std::int64_t finger, double x, double y, const Surface& surface)
{
    const std::lock_guard lock (mutex);

    if (kind.empty() || ! isOn (surface, x, y))
        return false;

    auto wanted = builtInFinger (kind, x, surface.kind == SurfaceKind::line ? 0 : y);
    wanted.isKnown = false;
    const auto isFree =
        std::none_of (resting.begin(), resting.end(),
                      [&] (const auto& other) { return other.first != finger && overlap (other.second, wanted); });

    if (! isFree || (resting.size() >= mostFingers && ! resting.contains (finger)))
        return false;

    resting.insert_or_assign (finger, wanted);
    return true;
}

void RestingTouches::lift (std::int64_t finger)
{
    const std::lock_guard lock (mutex);
    resting.erase (finger);
}

std::size_t RestingTouches::count() const
{
    const std::lock_guard lock (mutex);
    return resting.size();
}

std::vector<Finger> RestingTouches::withoutTouches (const std::vector<Finger>& present) const
{
    std::vector<Finger> others;

    for (const auto& finger : present)
        if (std::none_of (putDown.begin(), putDown.end(), [&] (const auto& touch) { return isSame (touch, finger); }))
            others.push_back (finger);

    return others;
}

std::optional<std::vector<Finger>> RestingTouches::due (const std::vector<Finger>& present, Time now)
{
    auto wanted = withoutTouches (present);
    std::vector<Finger> touches;
    {
        const std::lock_guard lock (mutex);

        for (const auto& touch : resting)
            if (std::none_of (wanted.begin(), wanted.end(),
                              [&] (const auto& other) { return overlap (other, touch.second); }))
                touches.push_back (touch.second);
    }

    if (now < last + pause || touches == putDown)
        return {};

    wanted.insert (wanted.end(), touches.begin(), touches.end());
    putDown = touches;
    last = now;
    return wanted;
}

std::optional<std::vector<Finger>> RestingTouches::allLifted (const std::vector<Finger>& present)
{
    {
        const std::lock_guard lock (mutex);
        resting.clear();
    }

    if (putDown.empty())
        return {};

    auto others = withoutTouches (present);
    putDown.clear();
    return others;
}
} // namespace antinode
