#include "TouchInput.h"

#include <antinode_documents/FingerFile.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace antinode
{
namespace
{
bool overlap (const Finger& a, const Finger& b)
{
    return std::hypot (a.x - b.x, a.y - b.y) < a.radius + b.radius;
}

/** In the extents of the surface, as touches come. */
double distance (const Finger& a, const Finger& b, const Surface& surface)
{
    const auto along = (a.x - b.x) / (surface.xMaximum - surface.xMinimum);
    return surface.kind == SurfaceKind::line ? std::abs (along)
                                             : std::hypot (along, (a.y - b.y) / (surface.yMaximum - surface.yMinimum));
}

/** One of them was read from a document: numbers in other units may differ in their last digits. */
bool isSame (const Finger& a, const Finger& b)
{
    constexpr double nearly = 1e-9; // m
    return a.name == b.name && std::hypot (a.x - b.x, a.y - b.y) < nearly;
}
} // namespace

void RestingTouches::setKind (const std::string& kindToUse)
{
    const std::lock_guard lock (mutex);
    kind = kindToUse;
    resting.clear();
}

RestResult RestingTouches::rest (std::int64_t finger, double x, double y, const Surface& surface)
{
    const std::lock_guard lock (mutex);

    if (kind.empty())
        return RestResult::noKind;

    if (! liesOn (surface, x, y))
        return RestResult::outsideSurface;

    auto wanted = builtInFinger (kind, x, surface.kind == SurfaceKind::line ? 0 : y);
    wanted.isKnown = false;
    const auto known =
        std::find_if (resting.begin(), resting.end(), [finger] (const auto& touch) { return touch.first == finger; });

    if (known == resting.end())
        resting.emplace_back (finger, std::move (wanted));
    else if (distance (known->second, wanted, surface) > step)
        known->second = std::move (wanted);

    return RestResult::taken;
}

void RestingTouches::lift (std::int64_t finger)
{
    const std::lock_guard lock (mutex);
    std::erase_if (resting, [finger] (const auto& touch) { return touch.first == finger; });
}

std::size_t RestingTouches::count() const
{
    const std::lock_guard lock (mutex);
    return resting.size();
}

std::vector<Finger> RestingTouches::fitting (std::vector<Finger> own, const Surface& surface) const
{
    const auto first = std::ssize (own);
    const std::lock_guard lock (mutex);

    for (const auto& [finger, touch] : resting)
    {
        const auto isFree = std::none_of (own.begin(), own.end(),
                                          [&touched = touch] (const auto& other) { return overlap (other, touched); });

        if (isFree && own.size() < maximumFingers && liesOn (surface, touch.x, touch.y))
            own.push_back (touch);
    }

    own.erase (own.begin(), own.begin() + first);
    return own;
}

std::optional<std::vector<Finger>> RestingTouches::due (const std::vector<Finger>& own,
                                                        const std::vector<Finger>& present, const Surface& surface,
                                                        Time now)
{
    if (now < last + pause)
        return {};

    auto wanted = fitting (own, surface);

    if (std::is_permutation (wanted.begin(), wanted.end(), present.begin(), present.end(), isSame))
        return {};

    last = now;
    return wanted;
}

std::pair<double, double> touchPlace (const Touch& touch, const Surface& surface)
{
    if (touch.inMillimetres)
        return { touch.x / 1000, touch.y / 1000 };

    // Weights, not a step from one end: so 0 and 1 are the very edges, which rounding must not leave.
    return { surface.xMinimum * (1 - touch.x) + surface.xMaximum * touch.x,
             surface.yMinimum * (1 - touch.y) + surface.yMaximum * touch.y };
}

void TouchInput::place (const Touch& touch)
{
    const auto model = session.snapshot()->model;

    if (model == nullptr)
    {
        ++notAccepted;
        return;
    }

    const auto [x, y] = touchPlace (touch, model->surface);

    if (touch.kind == TouchKind::rest)
    {
        const auto result = fingers.rest (touch.finger, x, y, model->surface);
        outsideSurface += result == RestResult::outsideSurface ? 1 : 0;
        withoutKind += result == RestResult::noKind ? 1 : 0;
        return;
    }

    const auto result = session.fireAt (x, y, touch.amplitude);
    outsideSurface += result == Session::FireResult::outsideSurface ? 1 : 0;
    notAccepted += result == Session::FireResult::notAccepted ? 1 : 0;
}

void TouchInput::play (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        return session.stopAll();

    if (touch.kind == TouchKind::lift)
        return fingers.lift (touch.finger);

    place (touch);
}

void TouchInput::open (const TouchPorts& ports)
{
    receiver.reset();
    outsideSurface = 0;
    notAccepted = 0;
    withoutKind = 0;
    fingers.setKind (ports.finger);

    if (ports.oscPort == 0 && ports.tuioPort == 0)
        return;

    TouchOptions options;
    options.cursorsRest = ! ports.finger.empty();
    receiver = std::make_unique<TouchReceiver> (
        ports, options, [this] (const Touch& touch) { play (touch); }, control);
}
} // namespace antinode
