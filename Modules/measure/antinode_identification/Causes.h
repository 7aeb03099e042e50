#pragma once

#include "Attempts.h"

namespace antinode
{
/** What may be wrong with responses that modes describe badly, each tested by putting it right and identifying again,
   the most likely first: the sign of time, inverted channels, delays or low-passes that differ from
   channel to channel, damping that is not proportional.
    @param modes  the best that was found, with these options
    @return       the first that makes the error clearly smaller, as a sentence; empty if none does
    [worker] Docs/Theory.md, section 8.5. */
std::string likelyCause (const FrequencyResponses&, const IdentificationOptions&, const IdentifiedModes& modes,
                         const Identify&);
} // namespace antinode
