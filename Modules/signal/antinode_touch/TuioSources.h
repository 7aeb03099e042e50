#pragma once

#include "OscMessage.h"
#include "TuioCursors.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
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
