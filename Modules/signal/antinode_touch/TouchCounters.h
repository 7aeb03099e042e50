#pragma once

#include "TouchFault.h"

#include <array>
#include <cstdint>

namespace antinode
{
/** Counters since the start. */
struct TouchCounters
{
    std::int64_t packets = 0;  ///< Datagrams, good or bad.
    std::int64_t touches = 0;  ///< Forwarded, stops among them.
    std::int64_t limited = 0;  ///< Good touches dropped because too many came.
    std::int64_t failures = 0; ///< Exceptions, of the callback or for want of memory; each cost a touch or a packet.
    std::array<std::int64_t, touchFaultKinds> faults {}; ///< In the order of TouchFault.

    std::int64_t of (TouchFault fault) const { return faults[static_cast<std::size_t> (fault)]; }
    void count (TouchFault fault) { ++faults[static_cast<std::size_t> (fault)]; }
};
} // namespace antinode
