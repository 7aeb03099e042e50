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
    static constexpr std::size_t maximumSources = 16; ///< The one that was silent longest makes way for another.

    explicit TuioSources (const TouchOptions& optionsToUse) : options (optionsToUse) {}

    /** @param message  of `address`; fseq ends a frame and gives its touches. [any] */
    void read (const OscMessage& message, std::vector<Touch>&, TouchCounters&);

    /** Drops what no fseq ended: a frame is in one packet. [any] */
    void endPacket (TouchCounters&);

private:
    bool readPart (const std::string& command, std::span<const OscArgument>);
    void endFrame (std::vector<Touch>&, TouchCounters&);
    TuioCursors& findCursors (const std::string& source, std::vector<Touch>&);

    TouchOptions options;
    std::int32_t sourcesSeen = 0;
    TuioFrame frame;
    bool isInFrame = false;
    std::vector<std::pair<std::string, TuioCursors>> sources; ///< The one heard last is the last.
};
} // namespace antinode
