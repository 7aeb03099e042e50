#pragma once

#include "OscMessage.h"
#include "TouchFault.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace antinode
{
/** The content of an OSC 1.0 datagram. */
struct OscPacket
{
    std::vector<OscMessage> messages; ///< In their order; bundles are laid open, their time tags left out.
    int unknownTypes = 0;             ///< Messages with types that are not read: left out, as OSC 1.0 asks.
    std::optional<TouchFault> fault;  ///< Of the packet as a whole: then there are no messages.

    // Of these addresses a message is one, without arguments, whatever is wrong with it or with the packet.
    static constexpr std::string_view stop = "/antinode/stop", lift = "/antinode/lift";
};

/** Reads a message, or bundles in each other, to 8 deep. Claimed sizes are checked before they are used: memory is
    bounded by the size of the packet. [any] */
OscPacket readOscPacket (std::span<const std::byte> packet);
} // namespace antinode
