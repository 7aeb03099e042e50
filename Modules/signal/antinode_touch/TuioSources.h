#pragma once

#include "OscPacket.h"
#include "Touch.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** A cursor of TUIO 1.1 where it is now. */
struct TuioCursor
{
    std::int32_t session = 0;
    double x = 0, y = 0; ///< Fractions of the surface; y points down.
};

/** The content of the messages of the profile 2Dcur up to an fseq. */
struct TuioFrame
{
    std::string source; ///< application@address; empty if the sender does not say.
    std::optional<std::vector<std::int32_t>> alive;
    std::vector<TuioCursor> cursors; ///< Those that are new or have moved.
    std::int32_t sequence = -1;
};

/** The cursors of one TUIO source, and the touches that they give. */
class TuioCursors
{
public:
    using Time = std::chrono::steady_clock::time_point;

    /** Without a frame for so long a source has ended: TUIO repeats what is alive about once a second. */
    static constexpr auto longestSilence = std::chrono::seconds (3);

    /** @param source  a number that no other source has */
    TuioCursors (const TouchOptions& optionsToUse, std::int32_t sourceToUse)
        : options (optionsToUse), source (sourceToUse)
    {
    }

    /** A cursor gives a touch where it is first seen on the surface, of amplitude 1. Where cursors rest as fingers,
        each place that its source sends gives one, and so does its leaving. One that is not alive any more is
        forgotten. Frames older than the newest are dropped; one with the newest's number is the rest of it, or a
        repetition. An older one is that of a source that was restarted where it is the first, more than 100 behind, or
        comes later than any network keeps packets.
        @param frame  has its alive
        @param now    times do not go back
        [any] */
    void play (const TuioFrame& frame, Time now, std::vector<Touch>&, TouchCounters&);

    /** Whether no frame has come for longestSilence. [any] */
    bool hasEnded (Time now) const { return now - heard > longestSilence; }

    /** Forgets all cursors; fingers are lifted. [any] */
    void liftAll (std::vector<Touch>&);

private:
    bool advanceTo (std::int32_t sequence, Time now, std::vector<Touch>&);
    void move (const TuioCursor&, std::vector<Touch>&, TouchCounters&);
    std::int64_t fingerOf (std::int32_t session) const;

    TouchOptions options;
    std::int32_t source;
    std::int32_t newest = 0;
    Time heard {};                             ///< When the last frame came.
    std::map<std::int32_t, Touch> lastTouches; ///< By session.
};

/** Puts the messages of TUIO 1.1's profile 2Dcur together to frames, and hands each to the cursors of its source. */
class TuioSources
{
public:
    static constexpr const char* address = "/tuio/2Dcur";
    static constexpr std::size_t maximumSources = 16;   ///< The one that was silent longest makes way for another.
    static constexpr std::size_t maximumCursors = 2048; ///< Of a frame: more than a packet has.

    explicit TuioSources (const TouchOptions& optionsToUse) : options (optionsToUse) {}

    /** @param message  of `address`; fseq ends a frame, whose parts may come in packets of their own, and gives its
            touches. As in TUIO's reference client, what no fseq has ended goes on with the next frame of its source.
        @param now      times do not go back [any] */
    void read (const OscMessage& message, TuioCursors::Time now, std::vector<Touch>&, TouchCounters&);

    /** Lifts what sources hold that have ended, and forgets these. [any] */
    void endSilent (TuioCursors::Time now, std::vector<Touch>&);

private:
    bool readPart (const std::string& command, std::span<const OscArgument>, TouchCounters&);
    void beginFrame (const std::string& source, TouchCounters&);
    void endFrame (TuioCursors::Time now, std::vector<Touch>&, TouchCounters&);
    TuioCursors& findCursors (const std::string& source, std::vector<Touch>&);

    TouchOptions options;
    std::int32_t sourcesSeen = 0;
    TuioFrame frame;
    std::vector<std::pair<std::string, TuioCursors>> sources; ///< The one heard last is the last.
};
} // namespace antinode
