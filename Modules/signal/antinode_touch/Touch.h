#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace antinode
{
/** Why a packet, or a part of it, was dropped. */
enum class TouchFault
{
    truncated,      ///< A field or an element reaches beyond the packet. The packet is dropped, as for the next three.
    unaligned,      ///< The size of a packet or an element is no multiple of 4.
    malformed,      ///< Missing address or types, padding that is not zero, bytes left over.
    tooDeep,        ///< More bundles in each other than are read.
    unknownType,    ///< A message with a type that is not read. Only the message is dropped, as for those that follow.
    unknownAddress, ///< A message for another program.
    wrongArguments, ///< Too few, too many, or of the wrong type.
    notFinite,      ///< A coordinate or an amplitude that is not finite.
    outside,        ///< A fraction of the surface below 0 or above 1.
    brokenFrame,    ///< A TUIO frame without alive or fseq, or a cursor set that is not alive.
    staleFrame      ///< A TUIO frame that came after a newer one.
};

constexpr std::size_t touchFaultKinds = static_cast<std::size_t> (TouchFault::staleFrame) + 1;

enum class TouchKind
{
    focusAt, ///< Plays a focus at a place.
    stopAll, ///< Fades every voice out; place and amplitude mean nothing.
    rest,    ///< A finger rests at a place, or has moved there.
    lift     ///< A finger has left; the place means nothing.
};

/** What a finger, or a program in its place, requests. Units are those of the sender. */
struct Touch
{
    TouchKind kind = TouchKind::focusAt;
    bool inMillimetres = false; ///< Else x and y are fractions of the surface, 0 to 1, y upwards.
    double x = 0, y = 0;
    double amplitude = 1;    ///< Times the velocity that the focus was designed for, 0 to 1.
    std::int64_t finger = 0; ///< Of `rest` and `lift`: which one, the same from touch to touch.

    bool operator== (const Touch&) const = default;
};

/** The fault of a touch: numbers that are not finite, fractions outside the surface. [any] */
std::optional<TouchFault> findFault (const Touch&);

/** Counters since the start. */
struct TouchCounters
{
    std::int64_t packets = 0;   ///< Datagrams, good or bad.
    std::int64_t touches = 0;   ///< Forwarded, stops among them.
    std::int64_t limited = 0;   ///< Good touches dropped because too many came.
    std::int64_t strangers = 0; ///< Commands from other computers that are not listed: dropped.
    std::int64_t failures = 0;  ///< Exceptions, of the callback or for want of memory; each cost a touch or a packet.
    std::array<std::int64_t, touchFaultKinds> faults {}; ///< In the order of TouchFault.

    std::int64_t of (TouchFault fault) const { return faults[static_cast<std::size_t> (fault)]; }
    void count (TouchFault fault) { ++faults[static_cast<std::size_t> (fault)]; }
};

struct TouchOptions
{
    /** A TUIO cursor that has moved farther than this since its last touch gives another one: in fractions of the
        surface, 0 = never. */
    double repeatDistance = 0;
    int touchesPerSecond = 500; ///< The largest number of foci forwarded in any second; all else always is.

    /** TUIO cursors rest as fingers instead of playing foci. */
    bool cursorsRest = false;
};
} // namespace antinode
