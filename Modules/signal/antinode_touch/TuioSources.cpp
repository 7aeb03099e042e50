#include "TuioSources.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace antinode
{
void TuioCursors::play (const TuioFrame& frame, Time now, std::vector<Touch>& touches, TouchCounters& counters)
{
    if (! advanceTo (frame.sequence, now, touches))
        return counters.count (TouchFault::staleFrame);

    heard = now;

    const std::set<std::int32_t> alive (frame.alive->begin(), frame.alive->end());
    std::erase_if (lastTouches,
                   [&] (const auto& entry)
                   {
                       const auto hasLeft = ! alive.contains (entry.first);

                       if (hasLeft && options.cursorsRest)
                           touches.push_back ({ TouchKind::lift, false, 0, 0, 1, fingerOf (entry.first) });

                       return hasLeft;
                   });

    for (const auto& cursor : frame.cursors)
    {
        if (alive.contains (cursor.session))
            move (cursor, touches, counters);
        else
            counters.count (TouchFault::brokenFrame);
    }
}

void TuioCursors::liftAll (std::vector<Touch>& touches)
{
    for (const auto& [session, touch] : lastTouches)
        if (options.cursorsRest)
            touches.push_back ({ TouchKind::lift, false, 0, 0, 1, fingerOf (session) });

    lastTouches.clear();
}

std::int64_t TuioCursors::fingerOf (std::int32_t session) const
{
    return (std::int64_t { source } << 32) + session;
}

bool TuioCursors::advanceTo (std::int32_t sequence, Time now, std::vector<Touch>& touches)
{
    constexpr auto longestDelay = std::chrono::milliseconds (200); // of a packet that others overtake
    constexpr int longestGap = 100, first = 1;                     // frames

    // -1 marks a repetition of the whole state, which has no place in the order. Some senders know only 0.
    if (sequence <= 0)
        return true;

    if (const auto behind = std::int64_t { newest } - sequence; behind > 0)
    {
        if (sequence != first && behind <= longestGap && now - heard <= longestDelay)
            return false;

        liftAll (touches);
    }

    newest = sequence;
    return true;
}

void TuioCursors::move (const TuioCursor& cursor, std::vector<Touch>& touches, TouchCounters& counters)
{
    const auto kind = options.cursorsRest ? TouchKind::rest : TouchKind::focusAt;
    const Touch touch { kind, false, cursor.x, 1 - cursor.y, 1, options.cursorsRest ? fingerOf (cursor.session) : 0 };

    if (const auto fault = findFault (touch))
        return counters.count (*fault);

    const auto [last, isNew] = lastTouches.try_emplace (cursor.session, touch);
    const auto distance = std::hypot (touch.x - last->second.x, touch.y - last->second.y);
    const auto isFar = options.repeatDistance > 0 && distance > options.repeatDistance;

    if (! isNew && ! isFar && ! options.cursorsRest)
        return;

    last->second = touch;
    touches.push_back (touch);
}

namespace
{
using Arguments = std::span<const OscArgument>;

std::optional<std::vector<std::int32_t>> readIntegers (Arguments arguments)
{
    std::vector<std::int32_t> integers;

    for (const auto& argument : arguments)
    {
        if (! std::holds_alternative<std::int32_t> (argument))
            return std::nullopt;

        integers.push_back (std::get<std::int32_t> (argument));
    }

    return integers;
}

/** Session, place, velocity, acceleration. Only the place is judged later: senders whose clock stood still divide by
    zero for the others. */
std::optional<TuioCursor> readCursor (Arguments arguments)
{
    if (arguments.size() != 6 || ! std::holds_alternative<std::int32_t> (arguments.front()))
        return std::nullopt;

    if (std::any_of (arguments.begin() + 1, arguments.end(), [] (const auto& value) { return ! toNumber (value); }))
        return std::nullopt;

    return TuioCursor { std::get<std::int32_t> (arguments[0]), *toNumber (arguments[1]), *toNumber (arguments[2]) };
}
} // namespace

void TuioSources::read (const OscMessage& message, TuioCursors::Time now, std::vector<Touch>& touches,
                        TouchCounters& counters)
{
    const Arguments arguments (message.arguments);
    const auto* command = arguments.empty() ? nullptr : std::get_if<std::string> (&arguments.front());

    if (command == nullptr || ! readPart (*command, arguments.subspan (1), counters))
        counters.count (TouchFault::wrongArguments);
    else if (*command == "fseq")
        endFrame (now, touches, counters);
}

bool TuioSources::readPart (const std::string& command, Arguments arguments, TouchCounters& counters)
{
    if (command == "set")
    {
        const auto cursor = readCursor (arguments);

        if (cursor && frame.cursors.size() == maximumCursors)
        {
            counters.count (TouchFault::brokenFrame);
            frame = {};
        }

        if (cursor)
            frame.cursors.push_back (*cursor);

        return cursor.has_value();
    }

    if (command == "source")
    {
        const auto* name = arguments.size() == 1 ? std::get_if<std::string> (&arguments.front()) : nullptr;

        if (name != nullptr)
            beginFrame (*name, counters);

        return name != nullptr;
    }

    const auto integers = readIntegers (arguments);

    if (command == "alive" && integers)
    {
        beginFrame (frame.source, counters);
        frame.alive = integers;
    }
    else if (command == "fseq" && integers && integers->size() == 1)
        frame.sequence = integers->front();
    else
        return false;

    return true;
}

/** Of the one before, if no fseq has ended it, only where cursors are is kept. */
void TuioSources::beginFrame (const std::string& source, TouchCounters& counters)
{
    if (frame.alive)
        counters.count (TouchFault::brokenFrame);

    frame.alive.reset();

    if (! frame.source.empty() && frame.source != source)
        frame.cursors.clear();

    frame.source = source;
}

void TuioSources::endFrame (TuioCursors::Time now, std::vector<Touch>& touches, TouchCounters& counters)
{
    if (frame.alive)
        findCursors (frame.source, touches).play (frame, now, touches, counters);
    else
        counters.count (TouchFault::brokenFrame);

    frame = {};
}

void TuioSources::endSilent (TuioCursors::Time now, std::vector<Touch>& touches)
{
    std::erase_if (sources,
                   [&] (auto& source)
                   {
                       const auto hasEnded = source.second.hasEnded (now);

                       if (hasEnded)
                           source.second.liftAll (touches);

                       return hasEnded;
                   });
}

TuioCursors& TuioSources::findCursors (const std::string& source, std::vector<Touch>& touches)
{
    const auto known =
        std::find_if (sources.begin(), sources.end(), [&source] (const auto& entry) { return entry.first == source; });

    if (known != sources.end())
        std::rotate (known, known + 1, sources.end());
    else
    {
        if (sources.size() == maximumSources)
        {
            sources.front().second.liftAll (touches);
            sources.erase (sources.begin());
        }

        sources.emplace_back (source, TuioCursors (options, ++sourcesSeen));
    }

    return sources.back().second;
}
} // namespace antinode
