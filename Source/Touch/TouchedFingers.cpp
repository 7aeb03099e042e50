#include "TouchedFingers.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace antinode
{
void TouchedFingers::take (const Touch& touch)
{
    if (touch.kind == TouchKind::stopAll)
        return liftAll();

    if (touch.kind == TouchKind::focusAt)
        return;

    const std::lock_guard lock (mutex);
    const auto known = std::find_if (touches.begin(), touches.end(),
                                     [&touch] (const auto& each) { return each.touch == touch.finger; });

    if (touch.kind == TouchKind::lift)
    {
        if (known != touches.end())
        {
            if (known->finger)
                lifted.push_back (*known->finger);

            touches.erase (known);
        }
    }
    else if (known != touches.end())
    {
        known->hasMoved = known->hasMoved || known->x != touch.x || known->y != touch.y;
        std::tie (known->x, known->y) = std::pair (touch.x, touch.y);
    }
    else if (touches.size() < mostTouches)
        touches.push_back ({ touch.finger, touch.x, touch.y, {}, false });
    else
        ++droppedTouches;
}

void TouchedFingers::liftAll()
{
    const std::lock_guard lock (mutex);

    for (const auto& each : touches)
        if (each.finger)
            lifted.push_back (*each.finger);

    touches.clear();
}

bool TouchedFingers::isHeld (std::size_t finger) const
{
    return std::any_of (touches.begin(), touches.end(), [finger] (const auto& each) { return each.finger == finger; });
}

std::optional<std::size_t> TouchedFingers::fingerFor (const Resting& touch,
                                                      const std::array<bool, mostFingers>& isFree) const
{
    if (touch.touch >= 1 && touch.touch <= mostFingers)
    {
        const auto bound = static_cast<std::size_t> (touch.touch - 1);
        return isHeld (bound) ? std::nullopt : std::optional (bound);
    }

    for (std::size_t k = 0; k < isFree.size(); ++k)
        if (isFree[k] && ! isHeld (k))
            return k;

    return {};
}

std::vector<FingerMove> TouchedFingers::takeMoves (const std::array<bool, mostFingers>& isFree)
{
    const std::lock_guard lock (mutex);
    std::vector<FingerMove> moves;
    auto free = isFree;

    for (const auto finger : std::exchange (lifted, {}))
    {
        moves.push_back ({ finger, FingerMove::Kind::lift, 0, 0 });
        free[finger] = true;
    }

    for (auto& each : touches)
    {
        if (each.finger && std::exchange (each.hasMoved, false))
            moves.push_back ({ *each.finger, FingerMove::Kind::move, each.x, each.y });
        else if (! each.finger)
            if (const auto finger = fingerFor (each, free))
            {
                each.finger = finger;
                each.hasMoved = false;
                moves.push_back ({ *finger, FingerMove::Kind::down, each.x, each.y });
            }
    }

    return moves;
}

std::array<bool, mostFingers> TouchedFingers::touched() const
{
    const std::lock_guard lock (mutex);
    std::array<bool, mostFingers> fingers {};

    for (const auto finger : lifted)
        fingers[finger] = true;

    for (const auto& each : touches)
        if (each.finger)
            fingers[*each.finger] = true;

    return fingers;
}

std::size_t TouchedFingers::resting() const
{
    const std::lock_guard lock (mutex);
    return static_cast<std::size_t> (
        std::count_if (touches.begin(), touches.end(), [] (const auto& each) { return each.finger.has_value(); }));
}

std::size_t TouchedFingers::waiting() const
{
    const std::lock_guard lock (mutex);
    return static_cast<std::size_t> (
        std::count_if (touches.begin(), touches.end(), [] (const auto& each) { return ! each.finger; }));
}

std::int64_t TouchedFingers::dropped() const
{
    const std::lock_guard lock (mutex);
    return droppedTouches;
}
} // namespace antinode
