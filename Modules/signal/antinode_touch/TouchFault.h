#pragma once

#include <cstddef>

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
} // namespace antinode
